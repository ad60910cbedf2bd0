// The text field with several lines, its error and its readings.

#include "engine/image/framebuffer.hpp"
#include "tests/ui/panels.hpp"
#include "ui/fonts.hpp"
#include "ui/offscreen_window.hpp"
#include "ui/theme.hpp"
#include "ui/ui_state.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr const char* four_lines =
    "a = 2\nf(u, v) = u^2 + v^2\nf(x, y)   =   a z, -1 < z < 1\nx^2 + y^2 = 1/2";

class Equation : public Panels {
protected:
    /// Into the empty field, which has the keyboard.
    void begin_typing(const std::string& text) {
        state_.equation.clear();
        state_.focus_equation = true;
        draw();
        OffscreenWindow::type(text);
        draw();
    }

    static const ImGuiWindow& field() { return *child("##equation bar/##equation_"); }
    static float bar_height() { return panel("##equation bar").Size.y; }
    static bool has_keyboard() { return ImGui::GetIO().WantTextInput; }
};

TEST_P(Equation, MarksTheWrongCharacter) {
    state_.equation = "\u03B1 +     @     + x";
    state_.error = "'@' has no meaning here";
    state_.error_at = 9;
    const Framebuffer frame = draw();
    expect_under_character(frame, mark(frame));
}

TEST_P(Equation, MarksTheWrongCharacterOfAScrolledFormula) {
    state_.equation.clear();
    state_.focus_equation = true;
    draw();
    OffscreenWindow::type("x + " + std::string(200, ' ') + "@     ");
    draw();
    ASSERT_EQ(state_.equation.size(), 210U);
    state_.error = "'@' has no meaning here";
    state_.error_at = 204;
    Framebuffer frame = draw();
    expect_under_character(frame, mark(frame));

    state_.error_at = 0;  // out of sight: an arrow at the left end of the field
    frame = draw();
    const Rectangle arrow = mark(frame);
    EXPECT_LT(arrow.left, arrow.right);
    EXPECT_LT(arrow.right, px(30));
}

TEST_P(Equation, MarksTheWrongCharacterOfALine) {
    state_.equation = four_lines;
    state_.error = "wrong";
    state_.error_at = state_.equation.find("=   a");
    const Framebuffer frame = draw();
    const Rectangle marked = mark(frame);
    expect_under_character(frame, marked);
    const float line = static_cast<float>(px(17));
    EXPECT_NEAR(static_cast<float>(marked.top),
                field().Pos.y + static_cast<float>(px(6)) + 3 * line, static_cast<float>(px(2)));
}

TEST_P(Equation, MarksTheWrongCharacterOfALineScrolledTo) {
    begin_typing("");
    for (int line = 0; line < 20; ++line) {
        OffscreenWindow::type("a");
        press(GLFW_KEY_ENTER);
    }
    OffscreenWindow::type("    @    ");
    draw();
    ASSERT_GT(field().Scroll.y, 0.0F);
    state_.error = "wrong";
    state_.error_at = state_.equation.find('@');
    Framebuffer frame = draw();
    expect_under_character(frame, mark(frame));

    state_.error_at = 0;  // out of sight: an arrow at the upper end of the field
    frame = draw();
    const Rectangle arrow = mark(frame);
    EXPECT_LT(arrow.left, arrow.right);
    EXPECT_LT(static_cast<float>(arrow.top), field().Pos.y + static_cast<float>(px(8)));
}

TEST_P(Equation, ShowsWhatIsMissingQuietly) {
    state_.equation = "x^2 +";
    state_.error = "... a number or a variable is missing after '+'";
    state_.error_at = state_.equation.size();
    state_.unfinished = true;
    const Framebuffer frame = draw();
    const ImRect bar = panel("##equation bar").Rect();
    EXPECT_EQ(count(frame, colors().error, bar), 0);
    const ImRect below(bar.Min.x, field().Rect().Max.y, bar.Max.x, bar.Max.y);
    EXPECT_GT(count(frame, colors().quiet, below), 100);
    state_.unfinished = false;
    EXPECT_GT(count(draw(), colors().error, bar), 100);
}

TEST_P(Equation, GrowsWithItsLinesUpToALimit) {
    draw();
    const float one = bar_height();
    const int picture = state_.viewport_px.y;
    const auto line = static_cast<float>(px(17));
    state_.equation = four_lines;
    draw();
    EXPECT_FLOAT_EQ(bar_height(), one + 3 * line);
    EXPECT_EQ(state_.viewport_px.y, picture - 3 * px(17));
    EXPECT_FLOAT_EQ(field().ScrollMax.y, 0.0F);
    for (int i = 0; i < 16; ++i) {
        state_.equation += "\nb = 3";
    }
    draw();
    const bool low = GetParam().window.height < 400;
    EXPECT_FLOAT_EQ(bar_height(), one + (low ? 4 : 5) * line);
    EXPECT_GT(field().ScrollMax.y, 0.0F);
}

TEST_P(Equation, EnterBeginsALineWithoutScrolling) {
    begin_typing("a = 2");
    OffscreenWindow::key(GLFW_KEY_ENTER, true);
    draw_frame();
    EXPECT_EQ(state_.equation, "a = 2\n");
    EXPECT_FLOAT_EQ(field().Scroll.y, 0.0F);
    OffscreenWindow::key(GLFW_KEY_ENTER, false);
    OffscreenWindow::type("x = a");
    draw_frame();
    EXPECT_FLOAT_EQ(field().Scroll.y, 0.0F);
    EXPECT_EQ(state_.equation, "a = 2\nx = a");
}

TEST_P(Equation, TabAndEscapeLeaveTheField) {
    for (const int key : {GLFW_KEY_TAB, GLFW_KEY_ESCAPE}) {
        begin_typing("x + y");
        ASSERT_TRUE(has_keyboard());
        press(key);
        draw();
        EXPECT_FALSE(has_keyboard());
        OffscreenWindow::type("z");
        draw();
        EXPECT_EQ(state_.equation, "x + y");
    }
}

TEST_P(Equation, CanBeTypedOverAtTheStart) {
    state_.equation = four_lines;
    state_.focus_equation = true;
    draw();
    EXPECT_FALSE(state_.focus_equation);
    OffscreenWindow::type("x");
    draw();
    EXPECT_EQ(state_.equation, "x");
    press_with_ctrl(GLFW_KEY_Z);  // the letter
    press_with_ctrl(GLFW_KEY_Z);  // what it replaced
    EXPECT_EQ(state_.equation, four_lines);
}

TEST_P(Equation, KeepsPastedLines) {
    begin_typing("");
    ImGui::SetClipboardText("a = 2\r\nb = 3\n");
    press_with_ctrl(GLFW_KEY_V);
    draw();
    EXPECT_EQ(state_.equation, "a = 2\nb = 3\n");
}

TEST_P(Equation, HintsWhatToTypeWhileItIsEmpty) {
    state_.equation = " ";
    Framebuffer frame = draw();
    EXPECT_EQ(count(frame, colors().quiet, field().Rect()), 0);
    state_.equation.clear();
    frame = draw();
    EXPECT_GT(count(frame, colors().quiet, field().Rect()), 50);
}

TEST_P(Equation, TakesAndShowsMathematicalLetters) {
    constexpr std::string_view text = "αβγδθλπφωΔΩ⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ₀₁₂×·÷−√∛≤≥≠≈∞±°∈∧∨→…";
    begin_typing(std::string(text));
    EXPECT_EQ(state_.equation, text);
    for (const FontRole role : {FontRole::Formula, FontRole::SmallFormula, FontRole::Text}) {
        const char* at = text.data();
        while (at < text.data() + text.size()) {
            unsigned int letter = 0;
            at += ImTextCharFromUtf8(&letter, at, text.data() + text.size());
            EXPECT_NE(font(role)->FindGlyphNoFallback(static_cast<ImWchar>(letter)), nullptr)
                << std::hex << letter;
        }
    }
}

TEST_P(Equation, ShowsEachReadingWithItsColor) {
    constexpr std::uint32_t front = 0xFF30C0E0U;
    state_.readings = {{"a = 2", std::nullopt}, {"x + 2 = 0", front}};
    const Framebuffer frame = draw();
    const ImRect bar = panel("##equation bar").Rect();
    const Rectangle swatch = bounds(
        frame, front,
        {0, static_cast<int>(field().Rect().Max.y), frame.width, static_cast<int>(bar.Max.y)},
        exact);
    EXPECT_NEAR(swatch.right - swatch.left, px(8), 2);
    EXPECT_NEAR(swatch.bottom - swatch.top, px(8), 2);
    EXPECT_GT(static_cast<float>(swatch.top), field().Rect().Max.y + static_cast<float>(px(20)));
}

TEST_P(Equation, ScrollsManyReadings) {
    state_.readings.assign(4, {"a = 2", std::nullopt});
    draw();
    const float four = bar_height();
    state_.readings.assign(20, {"a = 2", std::nullopt});
    draw();
    EXPECT_FLOAT_EQ(bar_height(), four);
    EXPECT_GT(child("##equation bar/##readings")->ScrollMax.y, static_cast<float>(px(100)));
}

TEST_P(Equation, KeepsThePictureWhileAnErrorHidesTheReadings) {
    state_.readings.assign(4, {"a = 2", std::nullopt});
    draw();
    const int height = state_.viewport_px.y;
    state_.error = "wrong";
    state_.error_at = 1;
    draw();
    EXPECT_EQ(state_.viewport_px.y, height);
}

TEST_P(Equation, CopiesAReading) {
    state_.readings = {{"a = 2", std::nullopt}, {"x + 2 = 0", 0xFF30C0E0U}};
    draw();
    const ImVec2 readings = child("##equation bar/##readings")->Pos;
    click_at({readings.x + static_cast<float>(px(30)), readings.y + static_cast<float>(px(25))});
    draw();
    ASSERT_TRUE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup));
    const ImVec2 menu = child("##Popup_")->Pos;
    click_at({menu.x + static_cast<float>(px(30)), menu.y + static_cast<float>(px(20))});
    draw();
    EXPECT_STREQ(ImGui::GetClipboardText(), "x + 2 = 0");
    EXPECT_FALSE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup));
}

INSTANTIATE_TEST_SUITE_P(Looks, Equation, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui
