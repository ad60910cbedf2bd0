// Tests of surface colours, the point under the pointer, and markers, in the window.

#include "document/look.hpp"

#include "document/colors.hpp"
#include "engine/annotate/hidden.hpp"
#include "engine/annotate/legend.hpp"
#include "engine/view/pixel_ray.hpp"
#include "tests/ui/panels.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/window/clipboard.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

namespace zeroset::ui::look_test {
namespace {

class Looking : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        if (!window_) return;
        state_.edited.layout.view_open = false;
        state_.shown.picture.frame = std::make_shared<Framebuffer>(disc());
    }

    /// Window coordinates of a place in the picture, given in heights of the picture from its
    /// centre.
    glm::vec2 in_picture(float x, float y) const {
        const float left = side_panel_width(state_.edited.layout);
        const auto width = static_cast<float>(state_.input.viewport_px.x);
        const auto height = static_cast<float>(state_.input.viewport_px.y);
        return {std::floor(left + 0.5F * width + x * height), std::floor((0.5F - y) * height)};
    }
    [[nodiscard]] ImRect picture_corner() const {
        const auto right = static_cast<float>(px(GetParam().window.width));
        const auto bottom = static_cast<float>(state_.input.viewport_px.y);
        return {right - static_cast<float>(px(250)), bottom - static_cast<float>(px(110)), right,
                bottom};
    }
    [[nodiscard]] ImRect status_line() const {
        const auto height = static_cast<float>(px(GetParam().window.height));
        return {0.0F, height - static_cast<float>(px(24)),
                static_cast<float>(px(GetParam().window.width)), height};
    }
};

TEST_P(Looking, HasARowForEachThingThatColorsTell) {
    state_.edited.layout.look_open = true;
    for (const ColorBy by : color_modes()) {
        state_.edited.document.coloring.by = by;
        for (const bool wrong : {false, true}) {
            state_.shown.reading.color_error =
                wrong ? "there is no parameter 'b'; the formula's are a" : "";
            draw();
            section_line("look", by == ColorBy::Expression ? 1 : 0);
            const ImRect all = section("look")->ParentWindow->Rect();
            const bool shown = count(draw(), colors().error, all) > 0;
            EXPECT_EQ(shown, wrong && by == ColorBy::Expression) << name_of(by);
            const ImGuiWindow& look = *section("look");
            EXPECT_LE(look.ContentSize.y, look.Size.y + 1.0F) << name_of(by);
        }
    }
}

TEST_P(Looking, ChoosesFromTheListOfWhatColorsTell) {
    state_.edited.layout.look_open = true;
    state_.edited.document.coloring = {ColorBy::Height, "x", ColorMap::Gray, ValueRange{1, 2}};
    draw();
    const float beside = 6.0F * ImGui::GetFontSize();
    click_at(section_line("look", 0) + glm::vec2(beside, 0.0F));
    draw_frame();
    draw_frame();
    const ImGuiWindow* const list = child("##Combo_");
    ASSERT_NE(list, nullptr);
    const float row = ImGui::GetTextLineHeightWithSpacing();
    click_at({list->Pos.x + 20.0F, list->Pos.y + list->WindowPadding.y + 1.4F * row});
    draw();
    EXPECT_EQ(state_.edited.document.coloring, (ColorChoice{ColorBy::Normal, "x"}))
        << "map and range were of the height";
}

TEST_P(Looking, SaysInTheCornerWhichColorIsWhichNumber) {
    const Framebuffer plain = draw();
    EXPECT_EQ(count(plain, shown_color_at(ColorMap::Aurora, 1.0), picture_corner()), 0);
    Coloring coloring;
    coloring.by = ColorBy::MeanCurvature;
    coloring.map = ColorMap::Aurora;
    coloring.range = ValueRange{-2, 3};
    state_.shown.picture.legend = legend_of(coloring, "");
    EXPECT_EQ(state_.shown.picture.legend->title, "mean curvature");
    const Framebuffer frame = draw();
    if (state_.input.viewport_px.x < px(300)) {
        EXPECT_EQ(count(frame, shown_color_at(ColorMap::Aurora, 1.0), picture_corner()), 0)
            << "there is no room for it";
        return;
    }
    for (const double place : {0.0, 0.5, 1.0}) {
        EXPECT_GT(count(frame, shown_color_at(ColorMap::Aurora, place), picture_corner()),
                  px(2) * px(3))
            << place;
    }
    state_.shown.picture.legend.reset();
    state_.edited.document.mark_undecided = true;
    EXPECT_GT(count(draw(), colors().undecided, picture_corner()), px(6) * px(6));
}

TEST_P(Looking, SaysWhatIsUnderThePointer) {
    // Its other side is not as amber as a warning.
    state_.edited.document.statements[0].color = palette_fronts()[1];
    state_.shown.pointed = PointedFacts{{.point = {0.5, 0.25, -1},
                                         .distance = 4,
                                         .within = 1e-9,
                                         .certificate = Certificate::Certified},
                                        1,
                                        1e-3};
    const Framebuffer certified = draw();
    EXPECT_GT(count(certified, colors().text, status_line()), px(10));
    EXPECT_EQ(count(certified, colors().warning, status_line()), 0);
    state_.shown.pointed->facts.certificate = Certificate::Undecided;
    EXPECT_GT(count(draw(), colors().warning, status_line()), px(5));
}

TEST_P(Looking, ClaimsNothingOfAnotherText) {
    state_.shown.pointed = PointedFacts{{.point = {0.5, 0.25, -1},
                                         .distance = 4,
                                         .within = 1e-9,
                                         .certificate = Certificate::Certified},
                                        1,
                                        1e-3};
    const Framebuffer own = draw();
    const int own_accents = count(own, colors().accent, status_line());
    state_.shown.picture.dimmed = 0.3F;
    state_.shown.status.doing = "preparing\xE2\x80\xA6";
    const Framebuffer old = draw();
    EXPECT_EQ(count(old, colors().text, status_line()), 0) << "the point of the old picture";
    EXPECT_NE(count(old, colors().accent, status_line()), own_accents);
}

TEST_P(Looking, KnowsWhereThePointerRests) {
    draw();
    OffscreenWindow::point(in_picture(0.1F, -0.2F), false);
    draw();
    ASSERT_TRUE(state_.input.pointer.has_value());
    EXPECT_NEAR(state_.input.pointer->x, 0.1, 0.01);
    EXPECT_NEAR(state_.input.pointer->y, -0.2, 0.01);
    OffscreenWindow::point({static_cast<float>(px(60)), static_cast<float>(px(60))}, false);
    draw();
    EXPECT_FALSE(state_.input.pointer.has_value());
}

TEST_P(Looking, TellsAClickFromADragAndFromADoubleClick) {
    draw();
    click_at(in_picture(-0.1F, -0.1F));
    ASSERT_TRUE(state_.wishes.click.has_value());
    EXPECT_NEAR(state_.wishes.click->cursor.x, -0.1, 0.01);
    EXPECT_FALSE(state_.wishes.click->again);
    state_.wishes.click.reset();
    click_at(in_picture(-0.1F, -0.1F));
    ASSERT_TRUE(state_.wishes.click.has_value());
    EXPECT_TRUE(state_.wishes.click->again);
    state_.wishes.click.reset();
    const glm::vec2 from = in_picture(-0.2F, 0.1F);
    for (const float far : {0.0F, 10.0F, 40.0F}) {
        OffscreenWindow::point(from + glm::vec2(far, far), true);
        draw_frame();
    }
    OffscreenWindow::point(from + glm::vec2(40.0F, 40.0F), false);
    draw_frame();
    EXPECT_FALSE(state_.wishes.click.has_value());
    OffscreenWindow::type("m");
    draw_frame();
    ASSERT_TRUE(state_.wishes.click.has_value());
    EXPECT_TRUE(state_.wishes.click->at_once);
}

TEST_P(Looking, DrawsMarkersFaintBehindTheSurface) {
    draw();
    const Camera& camera = state_.shown.picture.camera;
    const ViewFrame view(camera);
    const glm::vec2 middle = in_picture(0.0F, 0.0F);
    const auto reach = static_cast<float>(px(6));
    const ImRect around(middle.x - reach, middle.y - reach, middle.x + reach, middle.y + reach);
    const auto accents = [&] { return count(draw(), colors().accent, around); };
    const int none = accents();
    // The disc's depth is 1.
    add_marker(state_.edited.document.markers, camera.eye + 0.999 * view.forward);
    EXPECT_FALSE(
        is_behind(*state_.shown.picture.frame, view, state_.edited.document.markers[0].at));
    const int shown = accents();
    EXPECT_GT(shown, none + px(3) * px(3));
    state_.edited.document.markers[0].at = camera.eye + 2.0 * view.forward;
    EXPECT_TRUE(is_behind(*state_.shown.picture.frame, view, state_.edited.document.markers[0].at));
    EXPECT_LT(accents(), shown);
    EXPECT_TRUE(is_behind(*state_.shown.picture.frame, view, camera.eye - view.forward));
}

TEST_P(Looking, SelectsTheMarkerThatIsClicked) {
    draw();
    const ViewFrame view(state_.shown.picture.camera);
    add_marker(state_.edited.document.markers,
               state_.shown.picture.camera.eye + 0.9 * view.forward);
    draw();
    click_at(in_picture(0.0F, 0.0F));
    ASSERT_TRUE(state_.wishes.click.has_value());
    EXPECT_EQ(state_.wishes.click->marker, 1);
}

TEST_P(Looking, ListsMarkersToSelectCopyAndRemove) {
    state_.edited.layout.markers_open = true;
    draw();
    EXPECT_LE(section("markers")->ContentSize.y, section("markers")->Size.y + 1.0F);
    add_marker(state_.edited.document.markers, {0.5, -0.25, 1.0 / 3.0});
    add_marker(state_.edited.document.markers, {3.5, 3.75, 1.0 / 3.0});
    const float first = section_line("markers", 1).y;  // below the field for a point
    const ImGuiWindow& list = *section("markers");
    const float line = 0.5F * static_cast<float>(px(26));
    click_at({list.Pos.x + static_cast<float>(px(60)), first});
    EXPECT_EQ(state_.edited.selected_marker, 1);
    click_at({list.Pos.x + list.Size.x - 3.0F * line, first});
    EXPECT_EQ(clipboard(), "(0.5, -0.25, 0.3333333333333333)");
    click_at({list.Pos.x + list.Size.x - line, first});
    ASSERT_EQ(state_.edited.document.markers.size(), 1U);
    EXPECT_EQ(state_.edited.document.markers[0].number, 2);
    state_.edited.selected_marker = 2;
    press(GLFW_KEY_DELETE);
    EXPECT_TRUE(state_.edited.document.markers.empty());
    draw();
}

INSTANTIATE_TEST_SUITE_P(Looks, Looking, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::look_test
