// Tests of the side panel without a mouse: Tab, arrows, Space and Escape.

#include "tests/ui/panels.hpp"
#include "ui/model/edited.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/window/offscreen_window.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <vector>

namespace zeroset::ui::keyboard_test {
namespace {

class Keyboard : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        if (window_ == nullptr) return;
        ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
        OffscreenWindow::point({-1, -1}, false);
        set_rows(state_, {"x^2 + y^2 + z^2 = b"});
        state_.edited.layout.view_open = false;
        draw();
    }

    static const ImGuiContext& gui() { return *ImGui::GetCurrentContext(); }
    static ImGuiWindow& list() {
        for (ImGuiWindow* const window : gui().Windows) {
            if (window->WasActive && window->ParentWindow == &panel("##side")) return *window;
        }
        return *gui().Windows[0];
    }
    static ImGuiID slider() { return ImHashStr("##value", 0, list().GetID("b")); }
    [[nodiscard]] double value() const { return slider_named(state_.edited.document, "b").value; }

    /// Presses Tab until the control has the keyboard; false if it never gets it.
    bool tab_to(ImGuiID control) {
        constexpr int most = 60;
        for (int i = 0; i < most; ++i) {
            if (gui().NavId == control && i > 0) return true;
            press(GLFW_KEY_TAB);
            draw_frame();
        }
        return false;
    }
};

TEST_P(Keyboard, PressesInMenusByEnter) {
    press(GLFW_KEY_TAB);
    draw_frame();
    press(GLFW_KEY_SPACE);
    draw();
    ASSERT_TRUE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) << "the document's menu";
    press(GLFW_KEY_ENTER);
    draw_frame();
    EXPECT_EQ(state_.wishes.command, Command::New);
    EXPECT_FALSE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup));
}

TEST_P(Keyboard, WalksThroughAllControls) {
    std::vector<ImGuiID> seen;
    for (int i = 0; i < 40; ++i) {
        press(GLFW_KEY_TAB);
        draw_frame();
        seen.push_back(gui().NavId);
    }
    const auto has = [&seen](ImGuiID id) { return std::ranges::find(seen, id) != seen.end(); };
    EXPECT_TRUE(has(ImHashStr("##document", 0, panel("##side").ID)));
    EXPECT_TRUE(has(ImHashStr("##add", 0, list().ID)));
    EXPECT_TRUE(has(slider()));
    for (const char* const title :
         {"View", "Look", "Light", "Clip", "Navigation", "Markers", "Details", "Expert"})
        EXPECT_TRUE(has(ImHashStr(title, 0, list().ID))) << title;
    EXPECT_FALSE(state_.pages.gallery.open) << "walking presses nothing";
    EXPECT_FALSE(state_.edited.layout.folded);
}

TEST_P(Keyboard, MovesASliderByArrows) {
    ASSERT_TRUE(tab_to(slider()));
    EXPECT_FALSE(gui().NavDisableHighlight) << "it is marked";
    EXPECT_FALSE(ImGui::GetIO().WantTextInput) << "the slider itself, not its number";
    press(GLFW_KEY_RIGHT);
    EXPECT_NEAR(value(), 1.1, 1e-9);
    press(GLFW_KEY_LEFT);
    press(GLFW_KEY_LEFT);
    EXPECT_NEAR(value(), 0.9, 1e-9);
    press(GLFW_KEY_TAB);
    draw_frame();
    EXPECT_NE(gui().NavId, slider()) << "Tab leads on";
}

TEST_P(Keyboard, MovesASliderByItsStepAtLeast) {
    state_.edited.document.parameters["b"] = {.value = 1.0, .lo = -5.0, .hi = 5.0, .step = 2.0};
    ASSERT_TRUE(tab_to(slider()));
    press(GLFW_KEY_RIGHT);
    EXPECT_EQ(value(), 3.0);
}

TEST_P(Keyboard, TypesIntoASliderAfterEnter) {
    ASSERT_TRUE(tab_to(slider()));
    press(GLFW_KEY_ENTER);
    draw();
    OffscreenWindow::type("2,25");
    draw();
    press(GLFW_KEY_ENTER);
    EXPECT_EQ(value(), 2.25);
}

TEST_P(Keyboard, OpensASectionBySpace) {
    ASSERT_TRUE(tab_to(ImHashStr("Look", 0, list().ID)));
    press(GLFW_KEY_SPACE);
    EXPECT_TRUE(state_.edited.layout.look_open);
}

TEST_P(Keyboard, IsGivenUpByEscapeWithoutAMarkedPanel) {
    ASSERT_TRUE(tab_to(ImHashStr("Look", 0, list().ID)));
    press(GLFW_KEY_ESCAPE);
    draw();
    EXPECT_EQ(gui().NavWindow, nullptr);
    EXPECT_EQ(gui().NavId, 0U);
    state_.wishes.focus = RowFocus{.row = 1};
    draw();
    ASSERT_TRUE(is_typing(1));
    press(GLFW_KEY_ESCAPE);
    press(GLFW_KEY_ESCAPE);
    draw();
    EXPECT_NE(gui().NavId, list().ChildId) << "the list is not marked as a whole";
}

TEST_P(Keyboard, StaysInTheRowWhenAltIsTapped) {
    state_.wishes.focus = RowFocus{.row = 1};
    draw();
    ASSERT_TRUE(is_typing(1));
    OffscreenWindow::hold_alt(true);
    draw();
    OffscreenWindow::hold_alt(false);
    draw();
    EXPECT_TRUE(is_typing(1));
}

INSTANTIATE_TEST_SUITE_P(Looks, Keyboard, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::keyboard_test
