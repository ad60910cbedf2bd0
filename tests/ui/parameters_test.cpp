// The sliders over the picture.

#include "engine/image/framebuffer.hpp"
#include "tests/ui/panels.hpp"
#include "ui/offscreen_window.hpp"
#include "ui/theme.hpp"
#include "ui/ui_state.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <string>

namespace zeroset::ui {
namespace {

class Parameters : public Panels {
protected:
    void add(int count) {
        for (int i = 0; i < count; ++i) {
            state_.parameters.push_back({"p" + std::to_string(i)});
        }
    }

    /// The middle of a slider, or its value at the right.
    [[nodiscard]] glm::vec2 slider(int row) const {
        const ImVec2 at = child("##view/##parameters")->Pos;
        return {at.x + static_cast<float>(px(70)), at.y + static_cast<float>(px(13 + 34 * row))};
    }
    [[nodiscard]] glm::vec2 value(int row) const {
        const ImGuiWindow* rows = child("##view/##parameters");
        return {rows->Rect().Max.x - static_cast<float>(px(12)), slider(row).y};
    }

    void type_number(const char* number) {
        draw();
        OffscreenWindow::type(number);
        draw_frame();
        press(GLFW_KEY_ENTER);
        draw();
    }
};

TEST_P(Parameters, ShowTheSliderOfWOnlyWhenThereIsOne) {
    const float without = (draw(), ImGui::FindWindowByName("##view")->Size.y);
    state_.uses_w = true;
    draw();
    EXPECT_GT(ImGui::FindWindowByName("##view")->Size.y, without + static_cast<float>(px(20)));
    EXPECT_LE(ImGui::FindWindowByName("##view")->Rect().Max.y,
              ImGui::FindWindowByName("##status")->Pos.y);
}

TEST_P(Parameters, KeepTheNumberOffTheSlidersGrab) {
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

TEST_P(Parameters, HaveASliderEach) {
    const float without = (draw(), panel("##view").Size.y);
    add(1);
    const float with_one = (draw(), panel("##view").Size.y);
    EXPECT_GT(with_one, without + static_cast<float>(px(20)));
    click_at(slider(0));
    draw();
    EXPECT_NE(state_.parameters[0].value, 1.0);
    EXPECT_GE(state_.parameters[0].value, -5.0);
    EXPECT_LE(state_.parameters[0].value, 5.0);
}

TEST_P(Parameters, TakeATypedNumberBeyondTheirEnds) {
    add(2);
    draw();
    click_at(value(1));
    type_number("-123.25");
    EXPECT_DOUBLE_EQ(state_.parameters[1].value, -123.25);
    EXPECT_DOUBLE_EQ(state_.parameters[1].lo, -123.25);
    EXPECT_DOUBLE_EQ(state_.parameters[1].hi, 5.0);
    EXPECT_DOUBLE_EQ(state_.parameters[0].value, 1.0);
}

TEST_P(Parameters, AreTypedAfterADoubleClickToo) {
    add(1);
    draw();
    click_at(slider(0));
    click_at(slider(0));
    type_number("7");
    EXPECT_DOUBLE_EQ(state_.parameters[0].value, 7.0);
    EXPECT_DOUBLE_EQ(state_.parameters[0].hi, 7.0);
}

TEST_P(Parameters, RefuseWhatIsNoNumber) {
    add(1);
    for (const char* number : {"inf", "nan", "1e300", ""}) {
        draw();
        click_at(value(0));
        type_number(number);
        EXPECT_DOUBLE_EQ(state_.parameters[0].value, 1.0) << number;
        EXPECT_DOUBLE_EQ(state_.parameters[0].hi, 5.0) << number;
    }
}

TEST_P(Parameters, GoBackAtARightClick) {
    add(1);
    state_.parameters[0] = {"p0", 30.0, -40.0, 50.0};
    draw();
    OffscreenWindow::point(slider(0), false);
    for (const bool pressed : {false, true, false}) {
        OffscreenWindow::press_right(pressed);
        draw_frame();
    }
    EXPECT_DOUBLE_EQ(state_.parameters[0].value, 1.0);
    EXPECT_DOUBLE_EQ(state_.parameters[0].lo, -5.0);
    EXPECT_DOUBLE_EQ(state_.parameters[0].hi, 5.0);
}

TEST_P(Parameters, ScrollWhenThereAreMany) {
    add(30);
    draw();
    const ImGuiWindow* rows = child("##view/##parameters");
    EXPECT_LE(panel("##view").Rect().Max.y, panel("##status").Pos.y);
    EXPECT_GT(rows->ScrollMax.y + panel("##view").ScrollMax.y, static_cast<float>(px(100)));
    // One of them scrolls, so that the wheel does what is expected.
    EXPECT_TRUE(rows->ScrollMax.y == 0.0F || panel("##view").ScrollMax.y == 0.0F);
}

INSTANTIATE_TEST_SUITE_P(Looks, Parameters, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui
