// Tests of the tour of the window: its steps, and how it ends.

#include "tests/ui/panels.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/pages/pages_drawn.hpp"
#include "ui/window/offscreen_window.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <cstddef>
#include <optional>

namespace zeroset::ui::tour_test {
namespace {

class TourOfTheWindow : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        if (window_ == nullptr) return;
        state_.edited.tour_seen = false;
        action_named("Tour of the window").run(state_);
        draw();
    }

    static bool is_shown() {
        const ImGuiWindow* tour = ImGui::FindWindowByName("##tour");
        return tour != nullptr && tour->WasActive;
    }
    /// Clicks on the button at the card's lower right. In a small window the card may hide most of
    /// the picture, so that this is not looked at.
    void click_on_last_button() {
        const ImRect card = panel("##tour").Rect();
        click_at(
            {card.Max.x - static_cast<float>(px(30)), card.Max.y - static_cast<float>(px(22))});
        for (int i = 0; i <= frames_to_settle; ++i)
            draw_frame();
    }
    [[nodiscard]] std::optional<std::size_t> step() const { return state_.pages.tour.step; }
};

TEST_P(TourOfTheWindow, GoesThroughItsStepsAndEnds) {
    for (std::size_t i = 0; i < tour_steps; ++i) {
        ASSERT_TRUE(is_shown());
        EXPECT_EQ(step(), i);
        EXPECT_FALSE(state_.edited.tour_seen);
        click_on_last_button();
    }
    EXPECT_FALSE(is_shown());
    EXPECT_EQ(step(), std::nullopt);
    EXPECT_TRUE(state_.edited.tour_seen);
}

TEST_P(TourOfTheWindow, GoesOnByEnter) {
    for (std::size_t i = 0; i < tour_steps; ++i) {
        EXPECT_EQ(step(), i);
        press(GLFW_KEY_ENTER);
    }
    EXPECT_EQ(step(), std::nullopt);
}

TEST_P(TourOfTheWindow, EndsAtEscape) {
    press(GLFW_KEY_ESCAPE);
    draw();
    EXPECT_FALSE(is_shown());
    EXPECT_TRUE(state_.edited.tour_seen);
}

TEST_P(TourOfTheWindow, WaitsWhileSomethingElseIsOpen) {
    state_.pages.gallery.open = true;
    draw();
    EXPECT_FALSE(is_shown());
    EXPECT_EQ(step(), 0U);
    press(GLFW_KEY_ESCAPE);
    draw();
    EXPECT_FALSE(state_.pages.gallery.open);
    EXPECT_TRUE(is_shown());
}

TEST_P(TourOfTheWindow, UnfoldsThePanel) {
    state_.edited.layout.folded = true;
    action_named("Tour of the window").run(state_);
    EXPECT_FALSE(state_.edited.layout.folded);
}

INSTANTIATE_TEST_SUITE_P(Looks, TourOfTheWindow, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::tour_test
