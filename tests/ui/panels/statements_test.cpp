// Tests of the list of statements: rows by keyboard and mouse.

#include "tests/ui/panels/statements.hpp"

namespace zeroset::ui::statements_test {
namespace {

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

TEST_P(Statements, UnfoldTheReadingByAClick) {
    begin({"x = 0,5", "y = 1"}, 2);
    std::string text = "x";
    for (int i = 0; i < 40; ++i)
        text += " + 1000*x";
    const Reading reading{StatementKind::Surface, 0, text, {"1", "2", "3", "4", "5", "6"}};
    state_.shown.reading.reports[1] = {"x = 0,5", {reading}, std::nullopt};
    draw();
    const float folded = field(2).Pos.y;
    const auto click_reading = [&] {
        const ImRect typed = field(1).Rect();
        click_at(
            {typed.Min.x + static_cast<float>(px(30)), typed.Max.y + static_cast<float>(px(8))});
        draw();
        draw();
    };
    click_reading();
    EXPECT_GT(field(2).Pos.y, folded + static_cast<float>(px(50))) << "all of it, and all notes";
    click_reading();
    EXPECT_EQ(field(2).Pos.y, folded);
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

INSTANTIATE_TEST_SUITE_P(Looks, Statements, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::statements_test
