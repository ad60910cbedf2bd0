// Tests of the list of statements: errors, readings, long texts, letters.

#include "tests/ui/panels/statements.hpp"

namespace zeroset::ui::statement_texts_test {
namespace {

class StatementTexts : public Statements {};

TEST_P(StatementTexts, MarkTheWrongCharacterOfALine) {
    set_rows(state_, {"x = 1", "x", "y = 1"});
    set_error(2, "a +\n\u03B1    =   a z", 10);
    const Framebuffer frame = draw();
    const Rectangle marked = mark(frame, 2);
    expect_under_character(frame, marked);
    EXPECT_NEAR(static_cast<float>(marked.top), field(2).Pos.y + static_cast<float>(px(6 + 2 * 15)),
                static_cast<float>(px(3)));
    EXPECT_GE(mark(frame, 1).left, mark(frame, 1).right) << "no other row is marked";
}

TEST_P(StatementTexts, PutALikelyWordInThePlaceOfAnUnknownOne) {
    set_rows(state_, {"sinn x = 1"});
    set_error(1, "sinn x = 1", 0);
    state_.shown.reading.reports[1].error->mend = Mend{.word = "sinn", .by = "sin"};
    draw();
    const ImRect typed = field(1).Rect();
    const float small = font(FontRole::Small)->FontSize;
    click_at({typed.Min.x + static_cast<float>(px(30)),
              typed.Max.y + small + static_cast<float>(px(18))});
    EXPECT_EQ(texts()[0], "sin x = 1");
    draw();
    EXPECT_STREQ(ImGui::GetInputTextState(ImGui::GetActiveID())->TextA.Data, "sin x = 1");
}

TEST_P(StatementTexts, PointToAMarkOutOfSight) {
    begin({""}, 1);
    OffscreenWindow::type("x + " + std::string(1000, ' ') + "@     ");
    draw();
    set_error(1, texts()[0], 0);
    const Framebuffer frame = draw();
    const Rectangle arrow = mark(frame, 1);
    EXPECT_LT(arrow.left, arrow.right);
    EXPECT_LT(static_cast<float>(arrow.top), field(1).Pos.y + static_cast<float>(px(14)))
        << "the field shows its last lines";
}

TEST_P(StatementTexts, GrowWithWhatDoesNotFitInALine) {
    begin({"x = 1", "y = 2"}, 1);
    draw();
    const float before = field(1).Size.y;
    const float below = field(2).Pos.y;
    std::string added;
    for (int i = 0; i < 12; ++i)
        added += " + x^2*y^2";
    OffscreenWindow::type(added);
    draw();
    EXPECT_EQ(texts()[0], "x = 1" + added) << "no break in it";
    EXPECT_GT(field(1).Size.y, before + static_cast<float>(px(14)));
    EXPECT_GT(field(2).Pos.y, below + static_cast<float>(px(14)));
    const float grown = field(1).Size.y;
    for (std::size_t i = 0; i < added.size(); ++i)
        press(GLFW_KEY_BACKSPACE);
    EXPECT_EQ(texts()[0], "x = 1");
    EXPECT_FLOAT_EQ(field(1).Size.y, before);
    EXPECT_LT(before, grown);
}

TEST_P(StatementTexts, TypeAndCopyAcrossTheBreaksThatAreShown) {
    std::string text = "z = 0";
    for (int i = 0; i < 15; ++i)
        text += " + x*y";
    begin({text, "y"}, 1, RowFocus::Caret::All);
    draw();
    press_with_ctrl(GLFW_KEY_C);
    EXPECT_STREQ(ImGui::GetClipboardText(), text.c_str());
    press(GLFW_KEY_HOME);
    press(GLFW_KEY_DOWN);
    EXPECT_TRUE(is_typing(1)) << "to the next line of the same field";
    OffscreenWindow::type("q");
    draw();
    std::string shown = texts()[0];
    EXPECT_EQ(std::ranges::count(shown, 'q'), 1);
    EXPECT_NE(shown.find('q'), 0U);
    EXPECT_NE(shown.back(), 'q');
    std::erase(shown, 'q');
    EXPECT_EQ(shown, text);
}

TEST_P(StatementTexts, GoToTheErrorOfARow) {
    set_rows(state_, {"x = 1", "x + @ = 1", "y = $"});
    set_error(2, "x + @ = 1", 4);
    set_error(3, "y = $", 4);
    draw();
    press(GLFW_KEY_F8);
    draw();
    ASSERT_TRUE(is_typing(2));
    OffscreenWindow::type("7");
    draw();
    EXPECT_EQ(texts()[1], "x + 7@ = 1");
    press(GLFW_KEY_F8);
    draw();
    EXPECT_TRUE(is_typing(3)) << "row 2 is another text than the one with the error";
}

TEST_P(StatementTexts, SayWhatIsMissingQuietly) {
    begin({"x^2 +"}, 1);
    const auto red = [this](const Framebuffer& frame) {
        return count(frame, colors().error, child("##side/##list_")->Rect());
    };
    set_error(1, "x^2 +", 5, true);
    EXPECT_EQ(red(draw()), 0);
    set_error(1, "x^2 +", 5, false);
    EXPECT_GT(red(draw()), 50);
    set_error(1, "x^2 +", 5, true);
    press(GLFW_KEY_ESCAPE);
    EXPECT_GT(red(draw()), 50) << "nobody types there any more";
}

TEST_P(StatementTexts, TakeAndShowMathematicalLetters) {
    constexpr std::string_view text = "αβγδθλπφωΔΩ⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ₀₁₂×·÷−√∛≤≥≠≈∞±°∈∧∨→…";
    begin({""}, 1);
    OffscreenWindow::type(text);
    draw();
    EXPECT_EQ(texts(), Texts{std::string(text)});
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

TEST_P(StatementTexts, ScrollWhenThereAreMany) {
    set_rows(state_, Texts(60, "x = 1"));
    state_.wishes.focus = RowFocus{60, RowFocus::Caret::End};
    draw();
    draw();
    const ImGuiWindow& list = *child("##side/##list_");
    EXPECT_GT(list.ScrollMax.y, static_cast<float>(px(1000)));
    EXPECT_TRUE(is_typing(60));
    EXPECT_GE(field(60).Pos.y, list.Rect().Min.y) << "the row with the keyboard is in sight";
    EXPECT_LE(field(60).Rect().Max.y, list.Rect().Max.y + 1.0F);
}

INSTANTIATE_TEST_SUITE_P(Looks, StatementTexts, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::statement_texts_test
