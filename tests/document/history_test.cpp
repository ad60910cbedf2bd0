// Tests of undo and redo, by value.

#include "document/history.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zeroset::test::history_test {
namespace {

/// A document being edited, with a clock and gestures that the test advances.
class Undo : public testing::Test {
protected:
    void SetUp() override {
        document_ = empty_document();
        history_ = History(document_);
    }

    void change(double after_s = 0.1) {
        now_s_ += after_s;
        history_.follow(document_, now_s_, gesture_, held_);
    }
    void type(const std::string& text, double after_s = 0.1) {
        document_.statements[0].text += text;
        change(after_s);
    }
    void undo() { document_ = history_.undo(); }
    void redo() { document_ = history_.redo(); }
    [[nodiscard]] const std::string& text() const { return document_.statements[0].text; }

    Document document_;
    History history_{Document{}};
    double now_s_ = 0.0;
    unsigned gesture_ = 0;
    bool held_ = false;
};

TEST_F(Undo, TakesARunOfTypingAsOneStep) {
    for (const char* letter : {"x", "^", "2"})
        type(letter);
    type("+", 2.0);
    type("y");
    undo();
    EXPECT_EQ(text(), "x^2");
    undo();
    EXPECT_EQ(text(), "");
    EXPECT_FALSE(history_.can_undo());
    undo();
    EXPECT_EQ(text(), "");
    redo();
    redo();
    EXPECT_EQ(text(), "x^2+y");
    EXPECT_FALSE(history_.can_redo());
}

TEST_F(Undo, TakesADragAsOneStepHoweverLongItRests) {
    held_ = true;
    for (int i = 1; i <= 3; ++i) {
        document_.clip.hi.x = 2.0 + i;
        change(5.0);
    }
    undo();
    EXPECT_EQ(document_.clip.hi.x, 2.0);
    EXPECT_FALSE(history_.can_undo());
}

TEST_F(Undo, TakesWhatComesBackToItsBeginningAsNoStep) {
    document_.clip.hi.x = 3.0;
    change();
    document_.clip.hi.x = 2.0;
    change();
    EXPECT_FALSE(history_.can_undo());
    document_.clip.hi.x = 4.0;
    change();
    undo();
    EXPECT_EQ(document_.clip.hi.x, 2.0);
}

TEST_F(Undo, TakesEachDragAsOneStep) {
    for (gesture_ = 1; gesture_ <= 2; ++gesture_) {
        for (int i = 0; i < 10; ++i) {
            document_.w.value += 0.1;
            change();
        }
    }
    undo();
    EXPECT_NEAR(document_.w.value, 1.0, 1e-12);
    undo();
    EXPECT_EQ(document_.w.value, 0.0);
}

TEST_F(Undo, TakesADragThatMovesSeveralSlidersAsOneStep) {
    document_.parameters["a"] = Slider{};
    document_.parameters["b"] = Slider{};
    change();
    history_.end_step();
    gesture_ = 7;
    held_ = true;
    for (int i = 0; i < 6; ++i) {
        // A step of the pointer moves one of them, or both.
        if (i % 3 != 0) document_.parameters["a"].value += 0.125;
        if (i % 3 != 1) document_.parameters["b"].value += 0.25;
        if (i % 2 == 0) document_.w.value += 0.5;
        change(3.0);
    }
    held_ = false;
    gesture_ = 8;
    document_.parameters["b"].value = 4.0;
    change(0.01);
    undo();
    EXPECT_EQ(document_.parameters["b"].value, 2.0) << "another drag";
    undo();
    EXPECT_EQ(document_.parameters["a"].value, 1.0);
    EXPECT_EQ(document_.parameters["b"].value, 1.0);
    EXPECT_EQ(document_.w.value, 0.0);
}

TEST_F(Undo, BringsBackTheCamera) {
    document_.camera = Camera{{1, 2, 3}, {0, 0, 0}, {0, 0, 1}, 1.0};
    change();
    document_.camera->eye.x = 9;
    change(5.0);
    undo();
    ASSERT_TRUE(document_.camera);
    EXPECT_EQ(document_.camera->eye.x, 1);
    undo();
    EXPECT_FALSE(document_.camera);
}

TEST_F(Undo, BeginsAStepForAnotherPart) {
    type("x");
    document_.statements[0].color = 0x123456;
    change();
    document_.statements[0].visible = false;
    change();
    document_.parameters["a"].value = 3;
    change();
    document_.parameters["b"].value = 4;
    change();
    document_.clip = Box::cube(7);
    change();
    document_.region.sections.push_back({});
    change();
    undo();
    EXPECT_EQ(document_.region, Region());
    undo();
    EXPECT_EQ(document_.clip, Box());
    undo();
    EXPECT_FALSE(document_.parameters.contains("b"));
    undo();
    EXPECT_TRUE(document_.parameters.empty());
    undo();
    EXPECT_TRUE(document_.statements[0].visible);
    undo();
    EXPECT_FALSE(document_.statements[0].color);
    undo();
    EXPECT_EQ(text(), "");
}

TEST_F(Undo, KeepsSavedViewsApartButTheTypingOfANameTogether) {
    const Camera camera{{0, -3, 0}, {0, 0, 0}, {0, 0, 1}, 1.0};
    for (int i = 0; i < 2; ++i) {
        add_view(document_.views, camera);
        change();
    }
    for (const char* name : {"h", "ho", "hol"}) {
        EXPECT_TRUE(rename_view(document_.views, 1, name));
        change();
    }
    undo();
    EXPECT_EQ(view_names(document_.views), "View 1, View 2");
    undo();
    EXPECT_EQ(view_names(document_.views), "View 1");
    undo();
    EXPECT_TRUE(document_.views.empty());
}

TEST_F(Undo, KeepsAddedAndRemovedRowsApartButADragOfARowTogether) {
    document_.statements.push_back({2, "b", true, {}});
    change();
    document_.statements.push_back({3, "c", true, {}});
    change();
    std::swap(document_.statements[0], document_.statements[1]);
    change();
    std::swap(document_.statements[1], document_.statements[2]);
    change();
    undo();
    EXPECT_EQ(document_.statements[0].id, 1);
    EXPECT_EQ(document_.statements[1].id, 2);
    EXPECT_EQ(document_.statements.size(), 3U);
    undo();
    EXPECT_EQ(document_.statements.size(), 2U);
}

TEST_F(Undo, ForgetsWhatWasUndoneAfterAChange) {
    type("x");
    undo();
    type("y");
    EXPECT_FALSE(history_.can_redo());
    redo();
    EXPECT_EQ(text(), "y");
}

TEST_F(Undo, LeavesOutWhatNobodyDid) {
    type("x");
    history_.amend([](Document& document) { document.statements[0].color = 5; });
    document_.statements[0].color = 5;
    change(2.0);
    undo();
    EXPECT_EQ(text(), "");
    redo();
    EXPECT_EQ(document_.statements[0].color, 5U);
}

TEST_F(Undo, EndsAStepWhenAsked) {
    type("x");
    history_.end_step();
    type("y");
    undo();
    EXPECT_EQ(text(), "x");
}

TEST_F(Undo, KeepsSoManySteps) {
    for (std::size_t i = 0; i < History::most_steps + 10; ++i)
        type("x", 2.0);
    while (history_.can_undo())
        undo();
    EXPECT_EQ(text(), std::string(10, 'x'));
}

}  // namespace
}  // namespace zeroset::test::history_test
