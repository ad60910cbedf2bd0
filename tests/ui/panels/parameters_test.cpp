// Tests of the sliders of parameters and w below the statements.

#include "engine/image/framebuffer.hpp"
#include "tests/ui/panels.hpp"
#include "ui/model/edited.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/offscreen_window.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace zeroset::ui::parameters_test {
namespace {

class Parameters : public Panels {
protected:
    void add(int count) {
        state_.edited.layout.view_open = false;
        for (int i = 0; i < count; ++i)
            state_.shown.reading.parameters.push_back("p" + std::to_string(i));
    }
    [[nodiscard]] Slider slider_at(int row) const {
        return slider_named(state_.edited.document,
                            state_.shown.reading.parameters[static_cast<std::size_t>(row)]);
    }

    static const ImGuiWindow& list() { return *child("##side/##list_"); }
    static constexpr int below_field = 72;
    /// Vertical middle of a slider row, counted from 0, below a statement with its reading and the
    /// button that adds a row.
    [[nodiscard]] float middle(int row) const {
        return field(1).Rect().Max.y + static_cast<float>(px(below_field + 30 * row));
    }
    [[nodiscard]] glm::vec2 play_button(int row) const {
        return {list().Pos.x + static_cast<float>(px(13)), middle(row)};
    }
    /// A place on the slider, near its middle.
    [[nodiscard]] glm::vec2 slider(int row) const {
        return {list().Pos.x + static_cast<float>(px(85)), middle(row)};
    }
    [[nodiscard]] glm::vec2 value(int row) const {
        return {list().WorkRect.Max.x - static_cast<float>(px(37)), middle(row)};
    }
    [[nodiscard]] glm::vec2 more(int row) const {
        return {list().WorkRect.Max.x - static_cast<float>(px(13)), middle(row)};
    }

    void type_number(const char* number) {
        draw();
        OffscreenWindow::type(number);
        draw_frame();
        press(GLFW_KEY_ENTER);
        draw();
    }
};

TEST_P(Parameters, HaveARowForWOnlyWhenThereIsOne) {
    add(40);  // more than the panel has room for
    const float without = (draw(), list().ContentSize.y);
    state_.shown.reading.uses_w = true;
    draw();
    EXPECT_GT(list().ContentSize.y, without + static_cast<float>(px(20)));
}

TEST_P(Parameters, KeepTheNumberOffTheSlidersGrab) {
    state_.edited.layout.details_open = true;
    for (const double value : {4.0, 13.0, 22.0}) {
        state_.edited.document.stop.value = value;
        section_line("details", 0);
        const Framebuffer frame = draw();
        const ImRect view = section("details")->Rect();
        const Rectangle line{static_cast<int>(view.Min.x) + px(56), static_cast<int>(view.Min.y),
                             static_cast<int>(view.Max.x), static_cast<int>(view.Min.y) + px(26)};
        const Rectangle grab = bounds(frame, blended_grab(), line, exact);
        const Rectangle number = bounds(frame, colors().text, line);
        ASSERT_LT(grab.left, grab.right);
        ASSERT_LT(number.left, number.right);
        EXPECT_GT(number.left, grab.right);
    }
}

TEST_P(Parameters, HaveASliderEach) {
    add(2);
    draw();
    click_at(slider(1));
    draw();
    EXPECT_NE(slider_at(1).value, 1.0);
    EXPECT_GE(slider_at(1).value, -5.0);
    EXPECT_LE(slider_at(1).value, 5.0);
    EXPECT_EQ(slider_at(0), Slider());
    EXPECT_EQ(state_.edited.document.parameters.size(), 1U) << "only what is changed is kept";
}

TEST_P(Parameters, StayOnTheirSteps) {
    add(1);
    state_.edited.document.parameters["p0"] = {.value = 0.0, .lo = -4.0, .hi = 4.0, .step = 2.0};
    draw();
    click_at(slider(0));
    EXPECT_EQ(std::fmod(slider_at(0).value, 2.0), 0.0);
    EXPECT_NE(slider_at(0).value, 0.0);
}

TEST_P(Parameters, TakeATypedNumberBeyondTheirEnds) {
    add(2);
    draw();
    click_at(value(1));
    type_number("-123.25");
    EXPECT_EQ(slider_at(1), (Slider{.value = -123.25, .lo = -123.25}));
    EXPECT_EQ(slider_at(0), Slider());
}

TEST_P(Parameters, AreTypedAfterADoubleClickToo) {
    add(1);
    draw();
    click_at(slider(0));
    click_at(slider(0));
    type_number("7");
    EXPECT_EQ(slider_at(0), (Slider{.value = 7.0, .hi = 7.0}));
}

TEST_P(Parameters, RefuseWhatIsNoNumber) {
    add(1);
    for (const char* number : {"inf", "nan", "1e300", ""}) {
        draw();
        click_at(value(0));
        type_number(number);
        EXPECT_EQ(slider_at(0), Slider()) << number;
    }
}

TEST_P(Parameters, ReadADecimalComma) {
    add(1);
    draw();
    click_at(value(0));
    type_number("2,5");
    EXPECT_EQ(slider_at(0), (Slider{.value = 2.5})) << "and not 25";
}

TEST_P(Parameters, ReadAPastedDecimalComma) {
    add(1);
    draw();
    click_at(value(0));
    draw();
    ImGui::SetClipboardText("2,5");
    press_with_ctrl(GLFW_KEY_V);
    press(GLFW_KEY_ENTER);
    EXPECT_EQ(slider_at(0), (Slider{.value = 2.5}));
}

TEST_P(Parameters, LeaveTheValueThatIsOnlyLookedAt) {
    add(1);
    state_.edited.document.parameters["p0"] = {.value = 1.23456789};
    draw();
    click_at(value(0));
    draw();
    press(GLFW_KEY_ENTER);
    draw();
    EXPECT_EQ(slider_at(0).value, 1.23456789);
}

TEST_P(Parameters, GoBackAtARightClick) {
    add(1);
    state_.edited.document.parameters["p0"] = {.value = 30.0, .lo = -40.0, .hi = 50.0};
    draw();
    OffscreenWindow::point(slider(0), false);
    for (const bool pressed : {false, true, false}) {
        OffscreenWindow::press_right(pressed);
        draw_frame();
    }
    EXPECT_EQ(slider_at(0), Slider());
}

TEST_P(Parameters, GoBackToTheRangeOfAVolume) {
    add(1);
    state_.edited.document.parameters["p0"] = {.value = 30.0, .lo = -40.0, .hi = 50.0};
    state_.shown.reading.histograms["p0"] = std::make_shared<const Histogram>(
        Histogram{.first = -1000, .width = 30, .counts = std::vector<std::uint64_t>(100, 1)});
    draw();
    const glm::vec2 below{slider(0).x, slider(0).y + ImGui::GetFrameHeightWithSpacing()};
    OffscreenWindow::point(below, false);
    for (const bool pressed : {false, true, false}) {
        OffscreenWindow::press_right(pressed);
        draw_frame();
    }
    EXPECT_EQ(slider_at(0), (Slider{.value = 500.0, .lo = -1000.0, .hi = 2000.0}));
}

TEST_P(Parameters, PlayAndStopAtTheirButton) {
    add(2);
    draw();
    click_at(play_button(1));
    ASSERT_TRUE(state_.edited.playing.contains("p1"));
    EXPECT_EQ(state_.edited.playing.size(), 1U);
    EXPECT_DOUBLE_EQ(state_.edited.playing["p1"].place, 0.6);
    click_at(play_button(1));
    EXPECT_TRUE(state_.edited.playing.empty());
}

TEST_P(Parameters, HaveTheirSettingsBehindAButton) {
    add(1);
    draw();
    click_at(more(0));
    draw();
    ASSERT_TRUE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup));
    const ImGuiWindow* popup = child("##Popup_");
    ASSERT_NE(popup, nullptr);
    // The first field is the slider's lower end.
    click_at(
        {popup->Pos.x + static_cast<float>(px(120)), popup->Pos.y + static_cast<float>(px(25))});
    press_with_ctrl(GLFW_KEY_A);
    type_number("2,5");
    EXPECT_EQ(slider_at(0), (Slider{.value = 2.5, .lo = 2.5}));
}

TEST_P(Parameters, ScrollWithTheStatementsWhenThereAreMany) {
    add(40);
    draw();
    EXPECT_LE(panel("##side").Rect().Max.y, panel("##status").Pos.y);
    EXPECT_GT(list().ScrollMax.y, static_cast<float>(px(100)));
    EXPECT_EQ(panel("##side").ScrollMax.y, 0.0F);
}

INSTANTIATE_TEST_SUITE_P(Looks, Parameters, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::parameters_test
