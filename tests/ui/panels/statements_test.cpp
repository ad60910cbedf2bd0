// Tests of the list of statements: rows by keyboard and mouse, errors and readings.

#include "document/colors.hpp"
#include "engine/image/framebuffer.hpp"
#include "tests/ui/panels.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/panels/statement_list.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/offscreen_window.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace zeroset::ui {
namespace {

class Statements : public Panels {
protected:
    using Texts = std::vector<std::string>;

    void SetUp() override {
        Panels::SetUp();
        state_.edited.layout.view_open = false;
    }
    /// Sets rows with these texts and gives the keyboard to the row with id `row`.
    void begin(const Texts& texts, int row, RowFocus::Caret caret = RowFocus::Caret::End) {
        set_rows(state_, texts);
        state_.wishes.focus = RowFocus{row, caret};
        draw();
        ASSERT_TRUE(is_typing(row));
    }
    void type(const char* text) {
        OffscreenWindow::type(text);
        draw_frame();
    }
    void press_with_alt(int key) {
        OffscreenWindow::hold_alt(true);
        press(key);
        OffscreenWindow::hold_alt(false);
    }
    void press_with_shift(int key) {
        OffscreenWindow::hold_shift(true);
        press(key);
        OffscreenWindow::hold_shift(false);
    }
    [[nodiscard]] Texts texts() const {
        Texts texts;
        for (const Statement& statement : state_.edited.document.statements)
            texts.push_back(statement.text);
        return texts;
    }
    [[nodiscard]] int id_at(std::size_t index) const {
        return state_.edited.document.statements.at(index).id;
    }
    /// Index of the row that has the keyboard; -1: none.
    [[nodiscard]] int typing() const {
        for (std::size_t i = 0; i < state_.edited.document.statements.size(); ++i) {
            if (is_typing(id_at(i))) return static_cast<int>(i);
        }
        return -1;
    }
    /// A place in a row: `x` design units from the list's left end or, if negative, from its right
    /// end.
    [[nodiscard]] glm::vec2 in_row(int row, int x) const {
        const ImRect list = child("##side/##list_")->WorkRect;
        const float across = static_cast<float>(px(x));
        return {x < 0 ? list.Max.x + across : list.Min.x + across,
                field(row).Pos.y + static_cast<float>(px(13))};
    }
    void set_error(int row, const std::string& text, std::size_t at, bool unfinished = false) {
        state_.edited.document.statements[static_cast<std::size_t>(row - 1)].text = text;
        state_.shown.reading.reports[row] = {text, {}, RowError{"wrong", at, unfinished}};
    }
};

TEST_P(Statements, NotesStandBelowTheirRow) {
    begin({"x = 0,5", "y = 1"}, 2);
    const auto place_with = [&](std::vector<std::string> notes) {
        const Reading reading{StatementKind::Surface, 0, "x = 0,5", std::move(notes)};
        state_.shown.reading.reports[1] = {"x = 0,5", {reading}, std::nullopt};
        draw();
        draw();
        return field(2).Pos.y;
    };
    const float without = place_with({});
    const float with_one = place_with({"one"});
    EXPECT_GT(with_one, without + static_cast<float>(px(8)));
    EXPECT_GT(place_with({"one", "two"}), with_one);
    const float with_many = place_with({"1", "2", "3", "4"});
    EXPECT_EQ(place_with({"1", "2", "3", "4", "5", "6"}), with_many) << "not more than fit";
}

TEST_P(Statements, EnterMakesTheNextRow) {
    begin({"a = 2", "x = a"}, 1);
    type("+ 1");
    press(GLFW_KEY_ENTER);
    EXPECT_EQ(typing(), 1);
    type("b = 3");
    EXPECT_EQ(texts(), (Texts{"a = 2+ 1", "b = 3", "x = a"}));
}

TEST_P(Statements, TakeTheLettersThatComeWithAKey) {
    begin({""}, 1);
    OffscreenWindow::type("a = 2");
    press(GLFW_KEY_ENTER);
    type("x = a");
    press(GLFW_KEY_ESCAPE);
    EXPECT_EQ(texts(), (Texts{"a = 2", "x = a"}));
    EXPECT_EQ(typing(), -1);
}

TEST_P(Statements, ShiftEnterBeginsALineInTheRow) {
    begin({"x +"}, 1);
    const float one = field(1).Size.y;
    press_with_shift(GLFW_KEY_ENTER);
    type("y = 2");
    EXPECT_EQ(texts(), (Texts{"x +\ny = 2"}));
    draw();
    EXPECT_FLOAT_EQ(field(1).Size.y, one + static_cast<float>(px(15)));
    EXPECT_FLOAT_EQ(field(1).Scroll.y, 0.0F);
}

TEST_P(Statements, ArrowsMoveBetweenRows) {
    begin({"a = 2", "x +\ny = a", "z = 1"}, 1);
    for (const int expected : {1, 1, 2, 2}) {
        press(GLFW_KEY_DOWN);
        EXPECT_EQ(typing(), expected);
        if (expected == 1) press(GLFW_KEY_HOME);
    }
    for (const int expected : {1, 1, 0, 0}) {
        press(GLFW_KEY_UP);
        EXPECT_EQ(typing(), expected);
        // At the very end of a text ImGui's Up moves the caret to the beginning of the last line.
        if (expected == 1) press(GLFW_KEY_HOME);
    }
}

TEST_P(Statements, TabGoesThroughTheRowsAndLeaves) {
    begin({"a = 2", "x = a"}, 1);
    press(GLFW_KEY_TAB);
    EXPECT_EQ(typing(), 1);
    press_with_shift(GLFW_KEY_TAB);
    EXPECT_EQ(typing(), 0);
    type("b = 7");
    EXPECT_EQ(texts(), (Texts{"b = 7", "x = a"})) << "all was marked";
    press(GLFW_KEY_TAB);
    press(GLFW_KEY_TAB);
    EXPECT_EQ(typing(), -1);
    type("z");
    EXPECT_EQ(texts(), (Texts{"b = 7", "x = a"}));
}

TEST_P(Statements, BackspaceRemovesAnEmptyRow) {
    begin({"a = 2", "x", "y"}, 2);
    press(GLFW_KEY_BACKSPACE);
    EXPECT_EQ(texts(), (Texts{"a = 2", "", "y"}));
    press(GLFW_KEY_BACKSPACE);
    EXPECT_EQ(texts(), (Texts{"a = 2", "y"}));
    EXPECT_EQ(typing(), 0);
    type("1");
    EXPECT_EQ(texts(), (Texts{"a = 21", "y"}));
    press(GLFW_KEY_ESCAPE);
    begin({"", "y"}, 1);
    press(GLFW_KEY_DELETE);
    EXPECT_EQ(texts(), (Texts{"y"}));
    EXPECT_EQ(typing(), 0);
}

TEST_P(Statements, KeepARowWhenTheLastIsRemoved) {
    begin({"x = 1"}, 1);
    press_with_ctrl(GLFW_KEY_A);
    press(GLFW_KEY_BACKSPACE);
    press(GLFW_KEY_BACKSPACE);
    EXPECT_EQ(texts(), (Texts{""}));
    EXPECT_EQ(typing(), 0);
}

TEST_P(Statements, AltArrowsMoveTheRow) {
    begin({"a = 2", "b = 3", "x = a b"}, 1);
    press_with_alt(GLFW_KEY_DOWN);
    press_with_alt(GLFW_KEY_DOWN);
    press_with_alt(GLFW_KEY_DOWN);
    EXPECT_EQ(texts(), (Texts{"b = 3", "x = a b", "a = 2"}));
    EXPECT_EQ(typing(), 2);
    press_with_alt(GLFW_KEY_UP);
    EXPECT_EQ(texts(), (Texts{"b = 3", "a = 2", "x = a b"}));
    EXPECT_EQ(typing(), 1);
}

TEST_P(Statements, CtrlDDuplicatesTheRow) {
    begin({"x = 1", "y = 2"}, 1);
    press_with_ctrl(GLFW_KEY_D);
    EXPECT_EQ(texts(), (Texts{"x = 1", "x = 1", "y = 2"}));
    EXPECT_EQ(typing(), 1);
    EXPECT_NE(id_at(0), id_at(1));
    EXPECT_FALSE(state_.edited.document.statements[1].color) << "it gets one of its own";
}

TEST_P(Statements, PastedStatementsBecomeRows) {
    begin({""}, 1);
    ImGui::SetClipboardText("a = 2\r\nx^2 + y^2 =\n a\n");
    press_with_ctrl(GLFW_KEY_V);
    draw();
    EXPECT_EQ(texts(), (Texts{"a = 2", "x^2 + y^2 =\n a"}));
}

TEST_P(Statements, ShowATextThatWasSetElsewhereWhileTyping) {
    begin({"x + y"}, 1);
    state_.edited.document.statements[0].text = "x";
    state_.wishes.reload = 1;
    draw_frame();
    type("1");
    EXPECT_EQ(texts(), (Texts{"x1"}));
    EXPECT_FALSE(state_.wishes.reload);
}

TEST_P(Statements, LeaveUndoToTheDocument) {
    begin({"x"}, 1);
    type("1");
    state_.shown.document.can_undo = state_.shown.document.can_redo = true;
    press_with_ctrl(GLFW_KEY_Z);
    EXPECT_EQ(state_.wishes.command, Command::Undo);
    EXPECT_EQ(texts(), (Texts{"x1"})) << "the field itself does not undo";
    OffscreenWindow::hold_shift(true);
    press_with_ctrl(GLFW_KEY_Z);
    OffscreenWindow::hold_shift(false);
    EXPECT_EQ(state_.wishes.command, Command::Redo);
}

TEST_P(Statements, AreAddedBelowTheLast) {
    set_rows(state_, {"x = 1"});
    draw();
    click_at({in_row(1, 80).x, field(1).Pos.y + static_cast<float>(px(62))});
    draw();
    EXPECT_EQ(texts(), (Texts{"x = 1", ""}));
    EXPECT_EQ(typing(), 1);
}

TEST_P(Statements, AreHiddenByTheirEyeAndRemovedByTheirCross) {
    set_rows(state_, {"a = 2", "x = a"});
    draw();
    click_at(in_row(2, -30));
    EXPECT_FALSE(state_.edited.document.statements[1].visible);
    click_at(in_row(2, -30));
    EXPECT_TRUE(state_.edited.document.statements[1].visible);
    click_at(in_row(1, -30));
    EXPECT_TRUE(state_.edited.document.statements[0].visible) << "a constant has no eye";
    click_at(in_row(1, -10));
    EXPECT_EQ(texts(), (Texts{"x = a"}));
}

TEST_P(Statements, AreReorderedByTheirGrip) {
    set_rows(state_, {"a = 2", "b = 3", "x = a b"});
    draw();
    const glm::vec2 start = in_row(1, 6);
    const float end = field(3).Rect().Max.y + static_cast<float>(px(30));
    OffscreenWindow::point(start, false);
    draw_frame();
    OffscreenWindow::point(start, true);
    draw_frame();
    for (int i = 0; i < 8; ++i) {
        OffscreenWindow::point({start.x, end}, true);
        draw_frame();
    }
    OffscreenWindow::point({start.x, end}, false);
    draw_frame();
    EXPECT_EQ(texts(), (Texts{"b = 3", "x = a b", "a = 2"}));
    EXPECT_EQ(id_at(2), 1);
}

TEST_P(Statements, MarkTheWrongCharacterOfALine) {
    set_rows(state_, {"x = 1", "x", "y = 1"});
    set_error(2, "a +\n\u03B1    =   a z", 10);
    const Framebuffer frame = draw();
    const Rectangle marked = mark(frame, 2);
    expect_under_character(frame, marked);
    EXPECT_NEAR(static_cast<float>(marked.top), field(2).Pos.y + static_cast<float>(px(6 + 2 * 15)),
                static_cast<float>(px(3)));
    EXPECT_GE(mark(frame, 1).left, mark(frame, 1).right) << "no other row is marked";
}

TEST_P(Statements, PutALikelyWordInThePlaceOfAnUnknownOne) {
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

TEST_P(Statements, PointToAMarkOutOfSight) {
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

TEST_P(Statements, GrowWithWhatDoesNotFitInALine) {
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

TEST_P(Statements, TypeAndCopyAcrossTheBreaksThatAreShown) {
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

TEST_P(Statements, GoToTheErrorOfARow) {
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

TEST_P(Statements, SayWhatIsMissingQuietly) {
    set_rows(state_, {"x"});
    const auto red = [this](const Framebuffer& frame) {
        return count(frame, colors().error, child("##side/##list_")->Rect());
    };
    set_error(1, "x^2 +", 5, true);
    EXPECT_EQ(red(draw()), 0);
    set_error(1, "x^2 +", 5, false);
    EXPECT_GT(red(draw()), 50);
}

TEST_P(Statements, TakeAndShowMathematicalLetters) {
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

TEST_P(Statements, ScrollWhenThereAreMany) {
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

INSTANTIATE_TEST_SUITE_P(Looks, Statements, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui
