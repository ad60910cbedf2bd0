// Draws a real frame of every state of the panels on an offscreen window.

#include "engine/image/framebuffer.hpp"
#include "tests/ui/panels.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/sections.hpp"
#include "ui/screen.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/gl.hpp"
#include "ui/window/offscreen_window.hpp"
#include "ui/window/texture.hpp"
#include "ui/window/window.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

/// Called by the leak sanitizer: OSMesa keeps a few bytes of each context.
// NOLINTNEXTLINE(readability-identifier-naming): the sanitizer's name
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa"; }

namespace zeroset::ui::panel_test {
namespace {

/// Height of what the panel scrolls through.
float panel_content() {
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        if (window->WasActive && std::string(window->Name).starts_with("##side/##list_") &&
            window->ParentWindow == ImGui::FindWindowByName("##side"))
            return window->ContentSize.y;
    }
    return 0.0F;
}

TEST_P(Panels, ShowAPicture) {
    const Framebuffer frame = draw();
    EXPECT_EQ(std::ranges::count(frame.color, colors().error), 0);
    const auto panel_px = static_cast<int>(side_panel_width(state_.edited.layout));
    EXPECT_EQ(state_.input.viewport_px.x, frame.width - panel_px);
    EXPECT_GT(state_.input.viewport_px.x, frame.width / 3);
    EXPECT_GT(state_.input.viewport_px.y, frame.height / 2);
}

TEST_P(Panels, FoldAtTheirButtonAndUnfold) {
    draw();
    const float edge = side_panel_width(state_.edited.layout);
    click_at({edge - static_cast<float>(px(22)), static_cast<float>(px(22))});
    EXPECT_TRUE(state_.edited.layout.folded);
    const Framebuffer frame = draw();
    EXPECT_EQ(state_.input.viewport_px.x, frame.width);
    click(22, 22);
    EXPECT_FALSE(state_.edited.layout.folded);
    press_with_ctrl(GLFW_KEY_B);
    EXPECT_TRUE(state_.edited.layout.folded);
}

TEST_P(Panels, ChangeTheirWidthAtTheEdge) {
    draw();
    const float edge = side_panel_width(state_.edited.layout) - 2.0F;
    const float y = static_cast<float>(px(200));
    const float wished = static_cast<float>(px(260));
    OffscreenWindow::point({edge, y}, false);
    draw_frame();
    for (const float x : {edge, wished, wished}) {
        OffscreenWindow::point({x, y}, true);
        draw_frame();
    }
    OffscreenWindow::point({wished, y}, false);
    draw();
    EXPECT_NEAR(side_panel_width(state_.edited.layout), wished, 2.0F);
}

TEST_P(Panels, SayThatAPictureIsBeingTraced) {
    const auto accents = [this](const Framebuffer& frame) {
        const Rectangle line{0, frame.height - px(24), frame.width, frame.height};
        const Rectangle text = bounds(frame, colors().accent, line);
        return text.right - text.left;
    };
    EXPECT_LE(accents(draw()), 0);
    state_.shown.picture.tracing = true;
    EXPECT_GT(accents(draw()), px(30));
}

TEST_P(Panels, ShowTheNoteInTheStatusLine) {
    const auto warnings = [this](const Framebuffer& frame) {
        const Rectangle line{0, frame.height - px(24), frame.width, frame.height};
        return bounds(frame, colors().warning, line);
    };
    state_.shown.figures.counts.undecided = 0;
    EXPECT_LE(warnings(draw()).right, 0);
    state_.shown.status.note = "interpreted until its machine code is ready";
    const Framebuffer frame = draw();
    const Rectangle note = warnings(frame);
    EXPECT_GT(note.right, frame.width - px(40)) << "at the right end, apart from the facts";
    EXPECT_GT(note.right - note.left, px(150));
}

TEST_P(Panels, TellOfUndecidedPixelsInTheDetails) {
    state_.edited.layout.view_open = false;
    // So many rows that the sections are not at the bottom.
    set_rows(state_, std::vector<std::string>(30, "a = 1"));
    draw();
    const float folded = panel_content();
    state_.edited.layout.details_open = true;
    draw();
    ASSERT_NE(section("details"), nullptr);
    EXPECT_GT(panel_content(), folded);
    state_.shown.figures.counts.jumps = 0;
    draw();
    const float without = section("details")->Size.y;
    state_.shown.figures.counts.jumps = 3;
    draw();
    EXPECT_GT(section("details")->Size.y, without) << "a line for jumps";
    state_.shown.figures.hidden = true;
    draw();
    EXPECT_LT(section("details")->Size.y, without) << "figures of another text";
}

TEST_P(Panels, WarnOfUndecidedPixelsOnlyWhereTheyMatter) {
    PictureFigures figures;
    figures.width_px = 1000;
    figures.height_px = 100;
    figures.counts.undecided = 500;
    EXPECT_FALSE(many_undecided(figures));
    figures.counts.undecided = 501;
    EXPECT_TRUE(many_undecided(figures));
    EXPECT_EQ(undecided_text(figures), "501 undecided");
    figures.counts.not_drawn = 7;
    EXPECT_EQ(undecided_text(figures), "501 undecided, 7 of them not drawn");
    state_.shown.figures = figures;
    const auto warnings = [this](const Framebuffer& frame) {
        return bounds(frame, colors().warning,
                      {0, frame.height - px(24), frame.width, frame.height});
    };
    EXPECT_GT(warnings(draw()).right, 0);
    state_.shown.figures.counts.undecided = 400;
    EXPECT_LE(warnings(draw()).right, 0);
}

TEST_P(Panels, SayHowManyUndecidedPixelsAreNotDrawn) {
    const auto warnings = [this](const Framebuffer& frame) {
        const Rectangle line{0, frame.height - px(24), frame.width, frame.height};
        const Rectangle text = bounds(frame, colors().warning, line);
        return text.right - text.left;
    };
    state_.shown.figures.frame_ms = 1.0;
    state_.shown.figures.counts = {1, 20'000, 3};
    const int short_text = warnings(draw());
    state_.shown.figures.counts.not_drawn = 7;
    EXPECT_GT(warnings(draw()), short_text + px(60));
}

TEST_P(Panels, MarkUndecidedPixels) {
    const ImVec2 size(static_cast<float>(px(GetParam().window.width)),
                      static_cast<float>(px(GetParam().window.height)));
    const auto solid = [&](const Framebuffer& frame) {
        return count(frame, colors().undecided, ImRect(ImVec2(0, 0), size));
    };
    Framebuffer picture = disc();
    for (int row = 0; row < picture.height; ++row) {
        for (int col = 0; col < picture.width / 2; ++col)
            picture.certificate[picture.index(col, row)] = Certificate::Undecided;
    }
    picture_->upload(picture, behind_picture(GetParam().theme));
    EXPECT_EQ(solid(draw()), 0);
    picture_->upload(picture, behind_picture(GetParam().theme), undecided_tint(GetParam().theme));
    const int marked = solid(draw());
    const int half = static_cast<int>(size.x * size.y) / 2;
    EXPECT_GT(marked, half / 5) << "all of the left that is not drawn, and half the rest";
    EXPECT_LT(marked, half);
}

TEST_P(Panels, HaveASwitchForTheMarksWithALegend) {
    const auto legend = [this](const Framebuffer& frame) {
        return count(frame, colors().undecided, section("details")->ParentWindow->Rect());
    };
    state_.edited.layout.view_open = false;
    state_.edited.layout.details_open = true;
    EXPECT_EQ(legend(draw()), 0);
    click_at(section_line("details", 1));
    EXPECT_TRUE(state_.edited.document.mark_undecided);
    OffscreenWindow::point({-1, -1}, false);
    section_line("details", 2);
    EXPECT_GT(legend(draw()), px(8) * px(8));
}

TEST_P(Panels, HaveSwitchesForShadowsAndSmoothEdges) {
    draw();
    click_at(section_line("view", 3));
    EXPECT_FALSE(state_.edited.document.shadows);
    EXPECT_EQ(state_.edited.document.antialias, Antialias::None);
    EXPECT_FALSE(state_.edited.layout.smooth_edges);
    click_at(section_line("view", 3) + glm::vec2(10.0F * ImGui::GetFontSize(), 0.0F));
    EXPECT_TRUE(state_.edited.document.shadows);
    EXPECT_EQ(state_.edited.document.antialias, Antialias::None);
    EXPECT_FALSE(state_.edited.layout.smooth_edges);
}

TEST_P(Panels, KeepTheTitleOfASectionThatOpensUnderThePointer) {
    state_.edited.layout.view_open = false;
    draw();
    ImGuiWindow* const list = const_cast<ImGuiWindow*>(child("##side/##list_"));
    const float row = ImGui::GetFrameHeight();
    const glm::vec2 title(list->Pos.x + row, list->Pos.y + 5.0F * row);
    const auto open_ones = [this] {
        const Layout& layout = state_.edited.layout;
        return static_cast<int>(layout.view_open) + static_cast<int>(layout.camera_open) +
               static_cast<int>(layout.look_open);
    };
    click_at(title);
    draw();
    EXPECT_EQ(open_ones(), 1);
    click_at(title);
    draw();
    EXPECT_EQ(open_ones(), 0) << "the same title was met again";
}

INSTANTIATE_TEST_SUITE_P(Looks, Panels, testing::ValuesIn(all_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

/// Returns the frame that a context draws; empty if there is no such context.
Framebuffer drawn_by(OffscreenContextOr (*make_context)(glm::ivec2)) {
    const auto window = make_offscreen_window({.width = 640, .height = 400}, make_context);
    if (!window) return {};
    Texture picture;
    picture.upload(disc(), behind_picture(Theme::Dark));
    UiState state = usual_state(Theme::Dark);
    for (int i = 0; i <= frames_to_settle; ++i) {
        (*window)->begin_frame(Theme::Dark);
        draw_screen(state, picture);
        (*window)->end_frame();
    }
    return (*window)->pixels();
}

// The scale changes when the user moves the window to another screen.
TEST(OffscreenContext, MakesItsFontsAnewForAnotherScale) {
    auto made = make_offscreen_window({.width = 1280, .height = 800});
    if (!made) GTEST_SKIP() << made.error();
    OffscreenWindow& window = **made;
    const Texture picture;
    UiState state = usual_state(Theme::Dark);
    const auto panel_at = [&](float scale) {
        window.set_scale(scale);
        for (int i = 0; i <= frames_to_settle; ++i) {
            window.begin_frame(Theme::Dark);
            draw_screen(state, picture);
            window.end_frame();
        }
        return side_panel_width(state.edited.layout);
    };
    const float usual = panel_at(1.0F);
    EXPECT_NEAR(panel_at(1.5F), 1.5F * usual, 2.0F);
    EXPECT_NEAR(panel_at(1.0F), usual, 0.01F);
}

GlLoader& real_loader() {
    static GlLoader loader = nullptr;
    return loader;
}

/// Loads functions like the real loader, except that the context reports itself lost.
GlFunction loader_of_a_lost_context(const char* name) {
    if (std::string(name) == "glGetGraphicsResetStatus") {
        return reinterpret_cast<GlFunction>(+[] { return GLenum{0x8253}; });  // guilty
    }
    return real_loader()(name);
}

TEST(OffscreenContext, IsLostWhenTheDriverSaysSo) {
    const auto context = make_egl_context({16, 16});
    if (!context) GTEST_SKIP() << context.error();
    real_loader() = (*context)->loader();
    ASSERT_TRUE(load_gl(real_loader()));
    EXPECT_FALSE(is_context_lost());
    ASSERT_TRUE(load_gl(loader_of_a_lost_context));
    EXPECT_TRUE(is_context_lost());
    ASSERT_TRUE(load_gl(real_loader()));
}

TEST(OffscreenContext, DrawsTheSameInOneProcess) {
    const Framebuffer egl = drawn_by(make_egl_context);
    const Framebuffer osmesa = drawn_by(make_osmesa_context);
    if (egl.color.empty() || osmesa.color.empty()) GTEST_SKIP() << "not both of EGL and OSMesa";
    ASSERT_EQ(egl.color.size(), osmesa.color.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < egl.color.size(); ++i) {
        for (const unsigned shift : {0U, 8U, 16U}) {
            const auto a = static_cast<int>((egl.color[i] >> shift) & 0xFFU);
            const auto b = static_cast<int>((osmesa.color[i] >> shift) & 0xFFU);
            different += std::abs(a - b) > 8 ? 1 : 0;
        }
    }
    EXPECT_LT(different, egl.color.size() / 100);  // a graphics card may round differently
    const std::set<std::uint32_t> shades(egl.color.begin(), egl.color.end());
    EXPECT_GT(shades.size(), 100U);
}

}  // namespace
}  // namespace zeroset::ui::panel_test
