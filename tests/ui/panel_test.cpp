// One real frame of every state of the panels, drawn on a window that nobody sees.

#include "engine/image/framebuffer.hpp"
#include "engine/trace/camera.hpp"
#include "ui/offscreen_window.hpp"
#include "ui/screen.hpp"
#include "ui/texture.hpp"
#include "ui/theme.hpp"
#include "ui/ui_state.hpp"
#include "ui/window.hpp"

#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <ostream>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

/// The leak sanitizer asks: OSMesa keeps a few bytes of each context.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa"; }

namespace zeroset::ui {
namespace {

struct Look {
    Theme theme;
    OffscreenOptions window;
};

std::string name_of(const Look& look) {
    return (look.theme == Theme::Dark ? "dark_" : "light_") + std::to_string(look.window.width) +
           "x" + std::to_string(look.window.height) + "_scale" +
           std::to_string(std::lround(look.window.scale));
}

void PrintTo(const Look& look, std::ostream* out) { *out << name_of(look); }

/// A disc of many colours on nothing.
Framebuffer disc() {
    constexpr int size = 96;
    Framebuffer frame(size, size);
    for (int row = 0; row < size; ++row) {
        for (int col = 0; col < size; ++col) {
            const std::size_t at = frame.index(col, row);
            const bool drawn = std::hypot(col - size / 2, row - size / 2) < 0.45 * size;
            const auto shade = static_cast<std::uint32_t>(2 * row + col / 2);
            frame.color[at] = 0xFF404000U | std::min(shade, 255U);
            frame.depth[at] = drawn ? 1.0F : HUGE_VALF;
        }
    }
    return frame;
}

UiState usual_state(Theme theme) {
    UiState state;
    state.equation = "x^2 + y^2 + z^2 = 1";
    state.reading = "x^2 + y^2 + z^2 - 1 = 0";
    state.clip = Box::cube(2.0);
    state.camera = default_camera(state.clip);
    state.stop.value = 14.0;
    state.theme = theme;
    state.focus_equation = false;
    for (int i = 0; i < 30; ++i) {
        state.gallery.push_back({"Surface", "x + " + std::to_string(i) + " = 0", "A plane."});
    }
    state.picture = {false, 1280, 800, 1234.5, {1'002'003, 20'021, 1234}};
    return state;
}

/// Columns and rows [lo, hi).
struct Rectangle {
    int left = 0, top = 0, right = 0, bottom = 0;
};

class Panels : public testing::TestWithParam<Look> {
protected:
    void SetUp() override {
        auto made = make_offscreen_window(GetParam().window);
        if (!made) GTEST_SKIP() << made.error();
        window_ = std::move(*made);
        picture_ = std::make_unique<Texture>();
        picture_->upload(disc(), behind_picture(GetParam().theme));
        state_ = usual_state(GetParam().theme);
    }

    /// The picture when the layout is settled, checked for what must hold in every state.
    Framebuffer draw() {
        for (int i = 0; i <= frames_to_settle; ++i) {
            draw_frame();
        }
        Framebuffer frame = window_->pixels();
        expect_in_order(frame);
        return frame;
    }

    void draw_frame() {
        window_->begin_frame(state_.theme);
        draw_screen(state_, *picture_);
        window_->end_frame();
    }

    void expect_in_order(const Framebuffer& frame) const {
        const float width = static_cast<float>(frame.width);
        const float height = static_cast<float>(frame.height);
        for (const ImGuiWindow* panel : ImGui::GetCurrentContext()->Windows) {
            if (!panel->WasActive || panel->IsFallbackWindow) continue;
            const ImRect place = panel->Rect();
            EXPECT_TRUE(place.Min.x >= 0 && place.Min.y >= 0 && place.Max.x <= width &&
                        place.Max.y <= height)
                << panel->Name << " sticks out of the window";
            EXPECT_LE(panel->ContentSize.x, panel->WorkRect.GetWidth() + 1.0F)
                << panel->Name << " is too narrow for what is in it";
        }
        EXPECT_EQ(std::ranges::count(frame.color, 0xFFFF00FFU), 0) << "magenta";
        EXPECT_EQ(frame.color.back() | 0xFF000000U, colors().bar) << "a gap below the status line";
        if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) return;  // covers the picture
        const std::set<std::uint32_t> shades(frame.color.begin() + middle(frame),
                                             frame.color.begin() + middle(frame) + frame.width);
        EXPECT_GT(shades.size(), 30U) << "no picture";
    }

    /// Where the row through the middle of the picture begins.
    static std::ptrdiff_t middle(const Framebuffer& frame) {
        return static_cast<std::ptrdiff_t>(frame.index(0, frame.height / 2));
    }

    [[nodiscard]] const Palette& colors() const { return palette(GetParam().theme); }
    [[nodiscard]] int px(int design_units) const {
        return static_cast<int>(
            std::lround(static_cast<float>(design_units) * GetParam().window.scale));
    }

    /// Thin letters hardly reach their colour.
    static constexpr int letters = 40;
    static constexpr int exact = 2;

    static bool is_like(std::uint32_t a, std::uint32_t b, int tolerance) {
        const auto channel = [](std::uint32_t color, unsigned shift) {
            return static_cast<int>((color >> shift) & 0xFFU);
        };
        return std::abs(channel(a, 0) - channel(b, 0)) <= tolerance &&
               std::abs(channel(a, 8) - channel(b, 8)) <= tolerance &&
               std::abs(channel(a, 16) - channel(b, 16)) <= tolerance;
    }

    /// Of the pixels like a colour within `area`; empty if there is none.
    static Rectangle bounds(const Framebuffer& frame, std::uint32_t color, const Rectangle& area,
                            int tolerance = letters) {
        Rectangle box{area.right, area.bottom, area.left, area.top};
        for (int row = area.top; row < area.bottom; ++row) {
            for (int col = area.left; col < area.right; ++col) {
                if (!is_like(frame.color[frame.index(col, row)], color, tolerance)) continue;
                box = {std::min(box.left, col), std::min(box.top, row),
                       std::max(box.right, col + 1), std::max(box.bottom, row + 1)};
            }
        }
        return box;
    }

    /// The slider's grab on its track.
    [[nodiscard]] std::uint32_t blended_grab() const {
        const std::uint32_t alpha = colors().grab >> 24U;
        std::uint32_t mixed = 0;
        for (const unsigned shift : {0U, 8U, 16U}) {
            const std::uint32_t over = (colors().grab >> shift) & 0xFFU;
            const std::uint32_t under = (colors().field >> shift) & 0xFFU;
            mixed |= ((over * alpha + under * (255U - alpha)) / 255U) << shift;
        }
        return mixed;
    }

    /// The mark in the text field: the topmost red.
    [[nodiscard]] Rectangle mark(const Framebuffer& frame) const {
        const Rectangle all = bounds(frame, colors().error, {0, 0, frame.width, frame.height});
        return bounds(frame, colors().error, {0, all.top, frame.width, all.top + px(8)});
    }

    /// Expects ink above the mark and none of it beside: the marked character stands between
    /// spaces.
    void expect_under_character(const Framebuffer& frame, const Rectangle& marked) const {
        ASSERT_LT(marked.left, marked.right) << "no mark";
        const int wide = marked.right - marked.left;
        EXPECT_NEAR(wide, px(10), px(2));
        int inside = 0;
        int beside = 0;
        for (int row = marked.top - px(15); row < marked.top - px(1); ++row) {
            for (int col = marked.left - wide + 1; col < marked.right + wide - 1; ++col) {
                const bool ink = frame.color[frame.index(col, row)] != colors().field;
                const bool above = col >= marked.left - px(1) && col < marked.right + px(1);
                (above ? inside : beside) += ink ? 1 : 0;
            }
        }
        EXPECT_GT(inside, 20);
        EXPECT_EQ(beside, 0);
    }

    void click(int x, int y) {
        const auto at = glm::vec2(px(x), px(y));
        for (const bool pressed : {false, true, false}) {
            OffscreenWindow::point(at, pressed);
            draw_frame();
        }
    }

    std::unique_ptr<OffscreenWindow> window_;  // outlives the texture
    std::unique_ptr<Texture> picture_;
    UiState state_;
};

TEST_P(Panels, ShowAPicture) {
    const Framebuffer frame = draw();
    EXPECT_EQ(std::ranges::count(frame.color, colors().error), 0);
    EXPECT_EQ(state_.viewport_px.x, frame.width);
    EXPECT_GT(state_.viewport_px.y, frame.height / 2);
}

TEST_P(Panels, MarkTheWrongCharacter) {
    state_.equation = "\u03B1 +     @     + x";
    state_.error = "'@' has no meaning here";
    state_.error_column = 9;
    const Framebuffer frame = draw();
    expect_under_character(frame, mark(frame));
}

TEST_P(Panels, MarkTheWrongCharacterOfAScrolledFormula) {
    state_.equation.clear();
    state_.focus_equation = true;
    draw();
    OffscreenWindow::type("x + " + std::string(200, ' ') + "@     ");
    draw();
    ASSERT_EQ(state_.equation.size(), 210U);
    state_.error = "'@' has no meaning here";
    state_.error_column = 205;
    Framebuffer frame = draw();
    expect_under_character(frame, mark(frame));

    state_.error_column = 1;  // out of sight: an arrow at the left end of the field
    frame = draw();
    const Rectangle arrow = mark(frame);
    EXPECT_LT(arrow.left, arrow.right);
    EXPECT_LT(arrow.right, px(30));
}

TEST_P(Panels, GrowForALongError) {
    const float usual = (draw(), ImGui::FindWindowByName("##equation bar")->Size.y);
    state_.error = "'@' has no meaning here";
    for (int i = 0; i < 40; ++i) {
        state_.error += "; and so on";
    }
    draw();
    EXPECT_GT(ImGui::FindWindowByName("##equation bar")->Size.y, usual);
}

TEST_P(Panels, ShowTheSliderOfWOnlyWhenThereIsOne) {
    const float without = (draw(), ImGui::FindWindowByName("##view")->Size.y);
    state_.uses_w = true;
    draw();
    EXPECT_GT(ImGui::FindWindowByName("##view")->Size.y, without + static_cast<float>(px(20)));
    EXPECT_LE(ImGui::FindWindowByName("##view")->Rect().Max.y,
              ImGui::FindWindowByName("##status")->Pos.y);
}

TEST_P(Panels, KeepTheNumberOffTheSlidersGrab) {
    state_.uses_w = true;
    for (const double value : {4.0, 13.0, 22.0}) {
        state_.stop.value = value;
        const Framebuffer frame = draw();
        const ImRect card = ImGui::FindWindowByName("##view")->Rect();
        const Rectangle line{
            static_cast<int>(card.Min.x) + px(70), static_cast<int>(card.Min.y) + px(12),
            static_cast<int>(card.Max.x) - px(5), static_cast<int>(card.Min.y) + px(38)};
        const Rectangle grab = bounds(frame, blended_grab(), line, exact);
        const Rectangle number = bounds(frame, colors().text, line);
        ASSERT_LT(grab.left, grab.right);
        ASSERT_LT(number.left, number.right);
        EXPECT_GT(number.left, grab.right);
    }
}

TEST_P(Panels, SayThatAPictureIsBeingTraced) {
    const auto accents = [this](const Framebuffer& frame) {
        const Rectangle line{0, frame.height - px(24), frame.width, frame.height};
        const Rectangle text = bounds(frame, colors().accent, line);
        return text.right - text.left;
    };
    EXPECT_LE(accents(draw()), 0);
    state_.picture.tracing = true;
    EXPECT_GT(accents(draw()), px(30));
}

TEST_P(Panels, OpenTheGallery) {
    draw();
    click(GetParam().window.width - 30, 26);
    OffscreenWindow::point({-1, -1}, false);
    draw();
    EXPECT_TRUE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup));
    EXPECT_FALSE(state_.surface);
    click(GetParam().window.width - 60, 70);
    EXPECT_EQ(state_.surface, 0U);
}

std::vector<Look> all_looks() {
    std::vector<Look> looks;
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        for (const auto& [width, height] :
             {std::pair(min_width, min_height), std::pair(1280, 800)}) {
            for (const float scale : {1.0F, 2.0F}) {
                looks.push_back({theme, {width, height, scale}});
            }
        }
    }
    return looks;
}

INSTANTIATE_TEST_SUITE_P(Looks, Panels, testing::ValuesIn(all_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

/// What a context draws, or an empty frame where there is no such context.
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
    EXPECT_LT(different, egl.color.size() / 100);  // a graphics card may round otherwise
    const std::set<std::uint32_t> shades(egl.color.begin(), egl.color.end());
    EXPECT_GT(shades.size(), 100U);
}

}  // namespace
}  // namespace zeroset::ui
