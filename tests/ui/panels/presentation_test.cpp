// Tests of the presentation: only the picture and the sliders chosen for it, in larger letters; of
// a read-only session, and of the size of letters.

#include "tests/ui/panels.hpp"
#include "ui/actions/action_functions.hpp"
#include "ui/actions/actions.hpp"
#include "ui/panels/setting_rows.hpp"
#include "ui/window/gui_context.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <string>
#include <vector>

namespace zeroset::ui::presentation_test {
namespace {

class Presentations : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        if (window_ == nullptr) return;
        set_rows(state_, {"x^2 + y^2 + z^2 = a + b + w"});
        state_.shown.reading.uses_w = true;
        OffscreenWindow::point({-1, -1}, false);
        draw();
    }
    /// Draws until the layout has settled; there is no status line to be checked.
    void settle() {
        for (int i = 0; i <= frames_to_settle; ++i)
            draw_frame();
    }
    static bool is_drawn(const std::string& name) {
        const ImGuiWindow* const window = child(name);
        return window != nullptr && window->WasActive;
    }
    void run(const char* name) { action_named(name).run(state_); }
};

TEST_P(Presentations, ShowNothingButThePictureAndSliders) {
    EXPECT_TRUE(is_drawn("##side") && is_drawn("##status") && !is_drawn("##presented"));
    press(GLFW_KEY_F5);
    EXPECT_TRUE(state_.edited.layout.presents);
    EXPECT_TRUE(state_.edited.full_screen) << "wanted";
    settle();
    EXPECT_TRUE(is_drawn("##presented") && is_drawn("##leave"));
    for (const char* name : {"##side", "##status", "##gizmo", "##unfold"})
        EXPECT_FALSE(is_drawn(name)) << name;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    EXPECT_EQ(state_.input.viewport_px, glm::ivec2(window.x, window.y)) << "all of the window";
    press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(state_.edited.layout.presents || state_.edited.full_screen);
    settle();
    EXPECT_TRUE(is_drawn("##side") && is_drawn("##status") && !is_drawn("##presented"));
}

TEST_P(Presentations, LeaveOutWhatIsNotChosen) {
    EXPECT_EQ(presented_sliders(state_.edited.document, state_.shown.reading),
              (std::vector<std::string>{"w", "a", "b"}));
    Slider slider;
    slider.presented = false;
    set_slider(state_.edited.document, "a", slider);
    state_.edited.document.w.presented = false;
    EXPECT_EQ(presented_sliders(state_.edited.document, state_.shown.reading),
              std::vector<std::string>{"b"});
    run("Presentation");
    settle();
    const float one = child("##presented")->Size.y;
    set_slider(state_.edited.document, "a", Slider());
    settle();
    EXPECT_GT(child("##presented")->Size.y, one);
    set_slider(state_.edited.document, "a", slider);
    set_slider(state_.edited.document, "b", slider);
    settle();
    EXPECT_FALSE(is_drawn("##presented")) << "no slider, no card";
}

TEST_P(Presentations, MoveSliders) {
    run("Presentation");
    settle();
    const ImRect card = child("##presented")->Rect();
    // The last row is b's; its slider begins left of the middle.
    const glm::vec2 at(
        0.5F * (card.Min.x + card.Max.x),
        card.Max.y - ImGui::GetStyle().WindowPadding.y - 0.5F * ImGui::GetFrameHeight());
    const Slider before = slider_named(state_.edited.document, "b");
    click_at(at);
    const Slider after = slider_named(state_.edited.document, "b");
    EXPECT_NE(after.value, before.value);
    EXPECT_EQ(slider_named(state_.edited.document, "a"), Slider());
}

TEST_P(Presentations, LetPagesCloseFirst) {
    run("Presentation");
    run("Help");
    settle();
    press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(state_.pages.help.open);
    EXPECT_TRUE(state_.edited.layout.presents);
    press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(state_.edited.layout.presents);
}

TEST_P(Presentations, CannotBeLeftWhereNothingIsToBeChanged) {
    state_.edited.read_only = state_.edited.full_screen = state_.edited.layout.presents = true;
    settle();
    EXPECT_FALSE(is_drawn("##leave"));
    press(GLFW_KEY_ESCAPE);
    EXPECT_TRUE(state_.edited.layout.presents);
    EXPECT_FALSE(state_.edited.full_screen) << "but the full screen";
    press(GLFW_KEY_F5);
    EXPECT_TRUE(state_.edited.layout.presents);
    press_with_ctrl(GLFW_KEY_K);
    press_with_ctrl(GLFW_KEY_G);
    press_with_ctrl(GLFW_KEY_S);
    press_with_ctrl(GLFW_KEY_E);
    EXPECT_FALSE(state_.pages.commands.open || state_.pages.gallery.open ||
                 state_.pages.exports.open || state_.wishes.command);
    press(GLFW_KEY_F11);
    EXPECT_TRUE(state_.edited.full_screen);
}

INSTANTIATE_TEST_SUITE_P(Looks, Presentations, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

TEST(ReadOnly, LeavesTheViewAndWhatIsHarmless) {
    UiState state;
    state.edited.read_only = true;
    state.edited.document.camera = default_camera(state.edited.document.clip);
    state.shown.document.can_undo = true;
    for (const char* name : {"View from above", "Zoom in", "Reset the view", "Axes", "Undo",
                             "Larger letters", "Full screen", "Copy the picture", "Quit"})
        EXPECT_TRUE(is_enabled(action_named(name), state)) << name;
    for (const char* name : {"New", "Open...", "Save", "Save as...", "Save the picture...", "Paste",
                             "Presentation", "Fold the panel", "Gallery", "Find a command..."})
        EXPECT_FALSE(is_enabled(action_named(name), state)) << name;
}

TEST(Letters, GrowAndShrinkInSteps) {
    Layout layout;
    change_letters(layout, 1);
    EXPECT_FLOAT_EQ(layout.letters, 1.15F);
    change_letters(layout, -1);
    EXPECT_FLOAT_EQ(layout.letters, 1.0F);
    layout.letters = 1.2F;  // of a file
    change_letters(layout, -1);
    EXPECT_FLOAT_EQ(layout.letters, 1.15F);
    for (int i = 0; i < 20; ++i)
        change_letters(layout, 1);
    EXPECT_FLOAT_EQ(layout.letters, letter_sizes.back());
    for (int i = 0; i < 20; ++i)
        change_letters(layout, -1);
    EXPECT_FLOAT_EQ(layout.letters, letter_sizes.front());
    layout.presents = true;
    EXPECT_FLOAT_EQ(shown_letters(layout), presented_letters * letter_sizes.front());
}

TEST(Letters, AreNoLargerThanTheWindowHasRoomFor) {
    const auto scale = GuiContext::scale_of_letters;
    EXPECT_FLOAT_EQ(scale(1.0F, 1.0F, 1280, 800), 1.0F);
    EXPECT_FLOAT_EQ(scale(2.0F, 1.5F, 2560, 1600), 3.0F);
    EXPECT_FLOAT_EQ(scale(1.0F, 0.75F, 480, 320), 0.75F);
    EXPECT_FLOAT_EQ(scale(1.0F, 2.5F, 2 * min_width, 3 * min_height), 2.0F) << "two narrow windows";
    EXPECT_FLOAT_EQ(scale(1.0F, 2.0F, min_width, min_height), 1.0F);
    EXPECT_FLOAT_EQ(scale(2.0F, 2.0F, 10, 10), 2.0F) << "never less than as usual";
}

class LargeLetters : public Panels {};

TEST_P(LargeLetters, StillFitIntoTheWindow) {
    window_->set_letters(letter_sizes.back());
    state_.edited.layout = {.look_open = true, .markers_open = true, .space_open = true};
    draw();
    const float size = ImGui::GetFontSize();
    window_->set_letters(1.0F);
    draw();
    EXPECT_GE(size, ImGui::GetFontSize());
}

INSTANTIATE_TEST_SUITE_P(Looks, LargeLetters, testing::ValuesIn(all_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::presentation_test
