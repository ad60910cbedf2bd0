#include "engine/scene/lighting.hpp"
#include "tests/ui/panels.hpp"
#include "ui/panels/sections.hpp"

#include <glm/glm.hpp>

#include <vector>

// Tests of the section with looks, mirrors, background and lights.

namespace zeroset::ui::light_section_test {
namespace {

constexpr int first_light = 4;  ///< its line in the section

class LightSection : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        state_.edited.layout.view_open = false;
        state_.edited.layout.light_open = true;
    }

    /// A place in a line of the section; `along` is 0 left, 1 right.
    glm::vec2 in_line(int line, float along) {
        const glm::vec2 at = section_line("light", line);
        return {section("light")->Pos.x + along * section("light")->WorkRect.GetWidth(), at.y};
    }
    void click_line(int line, float along) {
        click_at(in_line(line, along));
        OffscreenWindow::point({-1, -1}, false);
        // A section that is out of sight keeps the size that it had when it was seen.
        ImGuiWindow* const all = section("light")->ParentWindow;
        ImGui::SetScrollY(all, section("light")->Pos.y - all->Pos.y + all->Scroll.y);
        draw_frame();
        draw();
    }
    LightChoice& light() { return state_.edited.document.light; }
};

TEST_P(LightSection, SetsMirrorsToneAndBackground) {
    click_line(1, 0.75F);
    EXPECT_GT(light().reflections, 2);
    click_line(3, 0.02F);
    EXPECT_EQ(light().tone, Tone::Filmic);
    EXPECT_FALSE(light().background);
}

TEST_P(LightSection, OffersLooksByPictures) {
    click_at(in_line(0, 0.75F));
    draw();
    const auto size_px = state_.wishes.look_pictures_px;
    ASSERT_TRUE(size_px);
    EXPECT_NEAR(static_cast<double>(size_px->x) / size_px->y, 4.0 / 3.0, 0.05);
    Texture texture;
    texture.upload(RgbaImage{1, 1, {0xFF0000FFU}});
    for (const zeroset::Look look : looks())
        state_.shown.look_pictures[look] = texture.name();
    const Framebuffer frame = draw();
    const ImGuiWindow& list = panel("##Combo_00");
    EXPECT_GT(count(frame, 0xFF0000FFU, list.Rect()),
              static_cast<int>(looks().size()) * size_px->x * size_px->y / 2)
        << "each has its picture";
    const float first = list.Pos.y + ImGui::GetStyle().WindowPadding.y;
    const float line = static_cast<float>(size_px->y) / ImGui::GetIO().DisplayFramebufferScale.y +
                       ImGui::GetStyle().ItemSpacing.y;
    click_at({list.Pos.x + 0.7F * list.Size.x, first + 2.5F * line});
    EXPECT_EQ(light().look, looks()[2]);
    state_.wishes.look_pictures_px.reset();
    draw();
    EXPECT_FALSE(state_.wishes.look_pictures_px) << "the list is closed";
}

TEST_P(LightSection, AddsUpToFourLightsAndRemovesThem) {
    for (std::size_t i = 0; i < max_lights; ++i) {
        SCOPED_TRACE("adding to " + std::to_string(light().lights.size()));
        click_line(first_light + 3 * static_cast<int>(i), 0.5F);
    }
    ASSERT_EQ(light().lights.size(), max_lights);
    EXPECT_NE(light().lights[0].towards, light().lights[1].towards);
    for (std::size_t i = 0; i < max_lights; ++i) {
        SCOPED_TRACE("removing from " + std::to_string(light().lights.size()));
        click_line(first_light + 2, 0.97F);
    }
    EXPECT_TRUE(light().lights.empty());
}

TEST_P(LightSection, AimsALightByDraggingItsBall) {
    light().lights = {{.towards = {0, 0, 1}}};
    const glm::vec2 line = in_line(first_light, 0.0F);
    const float row = ImGui::GetFrameHeightWithSpacing();
    const glm::vec2 middle(section("light")->Pos.x + 1.4F * row, line.y + row);
    OffscreenWindow::point(middle, false);
    draw_frame();
    OffscreenWindow::point(middle, true);
    draw_frame();
    OffscreenWindow::point(middle + glm::vec2(0.7F * row, 0.0F), true);
    draw_frame();
    OffscreenWindow::point(middle + glm::vec2(0.7F * row, 0.0F), false);
    draw_frame();
    const glm::dvec3 aimed = light().lights.front().towards;
    EXPECT_NEAR(glm::length(aimed), 1.0, 1e-9);
    EXPECT_GT(aimed.x, 0.3);
    EXPECT_LT(std::abs(aimed.y), 0.4);
    EXPECT_GT(aimed.z, 0.1);
}

TEST_P(LightSection, FitsWithAllItCanHold) {
    light().lights.assign(max_lights, {.with_camera = false, .power = 100.0, .radius_deg = 90.0});
    light().background = Background{};
    light().absorption = 123456.75;
    for (const zeroset::Look look : looks()) {
        light().look = look;
        draw();
    }
    EXPECT_LE(section("light")->ContentSize.y, section("light")->Size.y + 1.0F);
}

INSTANTIATE_TEST_SUITE_P(Looks, LightSection, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::light_section_test
