#pragma once

// Fixture that draws the panels on an offscreen window, for each combination of theme, size and
// scale.

#include "document/colors.hpp"
#include "document/row_program.hpp"
#include "document/sheet.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/view/camera.hpp"
#include "tests/support/long_run.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/picture/view_notice.hpp"
#include "ui/screen.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/offscreen_window.hpp"
#include "ui/window/texture.hpp"
#include "ui/window/window.hpp"

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

namespace zeroset::ui {

struct Look {
    Theme theme;
    OffscreenOptions window;
};

inline std::string name_of(const Look& look) {
    return (look.theme == Theme::Dark ? "dark_" : "light_") + std::to_string(look.window.width) +
           "x" + std::to_string(look.window.height) + "_scale" +
           std::to_string(std::lround(look.window.scale));
}

inline void PrintTo(const Look& look, std::ostream* out) { *out << name_of(look); }

/// Returns a disc of many colours on an empty background.
inline Framebuffer disc() {
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

/// Sets rows with the ids 1, 2, ..., reads them and colours their surfaces.
inline void set_rows(UiState& state, const std::vector<std::string>& texts) {
    Sheet sheet;
    state.edited.document.statements.clear();
    for (const std::string& text : texts) {
        const int id = static_cast<int>(sheet.size()) + 1;
        sheet.push_back({id, text});
        state.edited.document.statements.push_back({id, text, true, {}});
    }
    SheetReading reading = SheetReader().read(sheet);
    state.shown.reading.reports = std::move(reading.reports);
    state.shown.reading.surface_rows = reading.surface_rows;
    state.shown.reading.parameters = reading.program->parameters;
    choose_colors(state.edited.document, reading.surface_rows);
}

inline UiState usual_state(Theme theme) {
    UiState state;
    set_rows(state, {"x^2 + y^2 + z^2 = 1"});
    state.edited.document.camera = default_camera(state.edited.document.clip);
    state.shown.picture.camera = *state.edited.document.camera;
    state.edited.theme = theme;
    for (int i = 0; i < 30; ++i) {
        state.shown.gallery.push_back({"Surface", "x + " + std::to_string(i) + " = 0", "A plane."});
    }
    state.shown.figures = {.width_px = 1280,
                           .height_px = 800,
                           .frame_ms = 1234.5,
                           .counts = {1'002'003, 20'021, 1234}};
    return state;
}

/// A rectangle of pixels: columns [left, right), rows [top, bottom).
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

    /// Returns the frame after the layout has settled; checks what must hold in every state.
    Framebuffer draw() {
        for (int i = 0; i <= frames_to_settle; ++i) {
            draw_frame();
        }
        Framebuffer frame = window_->pixels();
        expect_in_order(frame);
        return frame;
    }

    void draw_frame() {
        window_->begin_frame(state_.edited.theme);
        draw_screen(state_, *picture_);
        window_->end_frame();
    }

    void expect_in_order(const Framebuffer& frame) const {
        const float width = static_cast<float>(frame.width);
        const float height = static_cast<float>(frame.height);
        for (const ImGuiWindow* shown : ImGui::GetCurrentContext()->Windows) {
            if (!shown->WasActive || shown->IsFallbackWindow) continue;
            const ImRect place = shown->Rect();
            const bool inside = place.Min.x >= 0 && place.Min.y >= 0 && place.Max.x <= width &&
                                place.Max.y <= height;
            const bool is_clipped = (shown->Flags & ImGuiWindowFlags_ChildWindow) != 0;
            EXPECT_TRUE(inside || is_clipped) << shown->Name << " sticks out of the window";
            const bool is_field = std::string(shown->Name).contains("/##equation_");
            if (is_field) continue;  // scrolls, so its content may be wider
            EXPECT_LE(shown->ContentSize.x, shown->WorkRect.GetWidth() + 1.0F)
                << shown->Name << " is too narrow for what is in it";
        }
        EXPECT_EQ(std::ranges::count(frame.color, 0xFFFF00FFU), 0) << "magenta";
        if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) return;  // covers the picture
        EXPECT_EQ(frame.color.back() | 0xFF000000U, colors().bar) << "a gap below the status line";
        // These cover the picture of a small window.
        if (state_.pages.help.open || state_.pages.exports.open) return;
        if (emptiness_of(state_) != Emptiness::None) return;
        const auto middle =
            frame.color.begin() + static_cast<std::ptrdiff_t>(frame.index(0, frame.height / 2));
        const auto left = static_cast<std::ptrdiff_t>(side_panel_width(state_.edited.layout));
        const std::set<std::uint32_t> shades(middle + left, middle + frame.width);
        EXPECT_GT(shades.size(), 30U) << "no picture";
    }

    [[nodiscard]] const Palette& colors() const { return palette(GetParam().theme); }
    [[nodiscard]] int px(int design_units) const {
        return static_cast<int>(
            std::lround(static_cast<float>(design_units) * GetParam().window.scale));
    }

    /// Tolerance of a colour channel for letters; thin ones hardly reach their colour.
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

    /// Bounding box of the pixels like `color` within `area`; left > right if there is none.
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

    /// Colour of the slider's grab blended with its track.
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

    /// Returns ImGui's window of a row's text field.
    static const ImGuiWindow& field(int row) {
        const std::string list = child("##side/##list_")->Name;
        const ImGuiID id =
            ImHashStr("##equation", 0, ImHashData(&row, sizeof row, panel(list.c_str()).ID));
        char name[256];
        ImFormatString(name, sizeof name, "%s/##equation_%08X", list.c_str(), id);
        return panel(name);
    }
    static bool is_typing(int row) { return ImGui::GetActiveID() == field(row).ChildId; }

    /// Bounding box of the error mark in a row's field.
    [[nodiscard]] Rectangle mark(const Framebuffer& frame, int row) const {
        const ImRect place = field(row).Rect();
        return bounds(frame, colors().error,
                      {static_cast<int>(place.Min.x), static_cast<int>(place.Min.y),
                       static_cast<int>(place.Max.x), static_cast<int>(place.Max.y)});
    }

    /// Expects ink above the mark and none beside it: the marked character stands between spaces.
    void expect_under_character(const Framebuffer& frame, const Rectangle& marked) const {
        ASSERT_LT(marked.left, marked.right) << "no mark";
        const int wide = marked.right - marked.left;
        EXPECT_NEAR(wide, px(9), px(2));
        int inside = 0;
        int beside = 0;
        for (int row = marked.top - px(13); row < marked.top - px(1); ++row) {
            for (int col = marked.left - wide + 1; col < marked.right + wide - 1; ++col) {
                const std::uint32_t color = frame.color[frame.index(col, row)];
                const bool ink = color != colors().field && color != colors().row_field;
                const bool above = col >= marked.left - px(1) && col < marked.right + px(1);
                (above ? inside : beside) += ink ? 1 : 0;
            }
        }
        EXPECT_GT(inside, 20);
        EXPECT_EQ(beside, 0);
    }

    /// Clicks at a point in design units.
    void click(int x, int y) { click_at(glm::vec2(px(x), px(y))); }
    /// Clicks at a point in window coordinates.
    void click_at(glm::vec2 at) {
        for (const bool pressed : {false, true, false}) {
            OffscreenWindow::point(at, pressed);
            draw_frame();
        }
    }

    /// Window with the contents of an open section of the side panel: "view", "look".
    static const ImGuiWindow* section(const std::string& id) {
        for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
            if (window->WasActive && std::string(window->Name).contains("/##" + id + "_"))
                return window;
        }
        return nullptr;
    }
    /// Scrolls to a line of a section, counted from 0; returns the place of its checkbox.
    glm::vec2 section_line(const std::string& id, int line) {
        draw();
        ImGuiWindow* const all = section(id)->ParentWindow;
        const float row = ImGui::GetFrameHeightWithSpacing();
        const float down = row * static_cast<float>(line);
        const float top = section(id)->Pos.y - all->Pos.y + all->Scroll.y + down;
        ImGui::SetScrollY(all, std::min(top, all->ScrollMax.y));
        draw();
        const ImVec2 place = section(id)->Pos;
        return {place.x + 0.4F * row, place.y + down + 0.4F * row};
    }

    /// Presses and releases a key (GLFW's number).
    void press(int key) {
        for (const bool pressed : {true, false}) {
            OffscreenWindow::key(key, pressed);
            draw_frame();
        }
        draw_frame();
    }

    void press_with_ctrl(int key) {
        OffscreenWindow::hold_ctrl(true);
        press(key);
        OffscreenWindow::hold_ctrl(false);
    }

    static const ImGuiWindow& panel(const char* name) { return *ImGui::FindWindowByName(name); }
    /// Returns the active window whose name begins with `name`; ImGui appends to names of child
    /// windows.
    static const ImGuiWindow* child(const std::string& name) {
        for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
            if (window->WasActive && std::string(window->Name).starts_with(name)) return window;
        }
        return nullptr;
    }

    /// Number of pixels like a colour within an area.
    static int count(const Framebuffer& frame, std::uint32_t color, const ImRect& area) {
        int found = 0;
        for (int row = static_cast<int>(area.Min.y); row < static_cast<int>(area.Max.y); ++row) {
            for (int col = static_cast<int>(area.Min.x); col < static_cast<int>(area.Max.x);
                 ++col) {
                found += is_like(frame.color[frame.index(col, row)], color, letters) ? 1 : 0;
            }
        }
        return found;
    }

    std::unique_ptr<OffscreenWindow> window_;  // outlives the texture
    std::unique_ptr<Texture> picture_;
    UiState state_;
};

/// Returns looks in which each theme, size and scale is met with each other; in a long run all.
inline std::vector<Look> all_looks() {
    std::vector<Look> looks;
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        for (const bool large : {false, true}) {
            for (const bool fine : {false, true}) {
                if (!test::is_long_run() && ((theme == Theme::Light) != (large != fine))) continue;
                const auto [width, height] =
                    large ? std::pair(1280, 800) : std::pair(min_width, min_height);
                looks.push_back({theme, {width, height, fine ? 2.0F : 1.0F}});
            }
        }
    }
    return looks;
}

/// Returns fewer looks, for tests that depend little on the look.
inline std::vector<Look> different_looks() {
    std::vector<Look> looks{{Theme::Dark, {min_width, min_height, 1.0F}},
                            {Theme::Light, {min_width, min_height, 2.0F}}};
    if (test::is_long_run()) looks.push_back({Theme::Dark, {1280, 800, 1.0F}});
    return looks;
}

}  // namespace zeroset::ui
