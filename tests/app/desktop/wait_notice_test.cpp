#include "app/desktop/wait_notice.hpp"

#include <gtest/gtest.h>

// Tests of the messages while a text is prepared, with a clock that the test sets.

namespace zeroset::test::wait_notice_test {
namespace {

constexpr WaitNotice::Causes nothing{};
constexpr WaitNotice::Causes reading{.picture = true, .reading = true};

TEST(WaitNotice, SaysNothingOfWhatIsDoneAtOnce) {
    WaitNotice waiting;
    waiting.follow(reading, 1.0);
    EXPECT_EQ(waiting.dimmed(1.0), 0.0F);
    EXPECT_EQ(waiting.text(1.0), "");
    EXPECT_EQ(waiting.dimmed(1.09), 0.0F);
    EXPECT_EQ(waiting.text(1.09), "");
    waiting.follow(nothing, 1.09);
    EXPECT_EQ(waiting.dimmed(2.0), 0.0F);
    EXPECT_EQ(waiting.text(2.0), "");
    EXPECT_FALSE(waiting.due_s(2.0));
}

TEST(WaitNotice, DimsThePictureOfAnotherTextAfterAWhile) {
    WaitNotice waiting;
    waiting.follow(reading, 1.0);
    waiting.follow(reading, 1.15);
    EXPECT_GT(waiting.dimmed(1.15), 0.1F);
    EXPECT_LT(waiting.dimmed(1.15), 0.9F);
    EXPECT_EQ(waiting.dimmed(1.5), 1.0F);
    EXPECT_EQ(waiting.text(1.5), "preparing\xE2\x80\xA6");
    waiting.follow({.picture = true}, 1.6);
    EXPECT_EQ(waiting.text(1.6), "drawing\xE2\x80\xA6");
    waiting.follow(nothing, 1.7);
    EXPECT_EQ(waiting.dimmed(1.7), 0.0F);
}

TEST(WaitNotice, TellsOfCodeWithoutDimmingThePictureThatIsThere) {
    WaitNotice waiting;
    const WaitNotice::Causes code{.code = true, .nodes = 812};
    waiting.follow(code, 1.0);
    EXPECT_EQ(waiting.text(1.05), "");
    EXPECT_EQ(waiting.text(1.2), "compiling\xE2\x80\xA6 (812 nodes)");
    EXPECT_EQ(waiting.dimmed(1.2), 0.0F);
}

TEST(WaitNotice, CountsFromTheFirstOfTextsThatOvertakeOneAnother) {
    WaitNotice waiting;
    for (int key = 0; key <= 5; ++key)
        waiting.follow(reading, 1.0 + 0.05 * key);
    EXPECT_EQ(waiting.dimmed(1.25), 1.0F);
}

TEST(WaitNotice, HidesTheFiguresOfAnotherTextsPicture) {
    WaitNotice waiting;
    waiting.follow({.figures = true}, 1.0);
    EXPECT_FALSE(waiting.hides_figures(1.05));
    EXPECT_TRUE(waiting.hides_figures(1.2));
    EXPECT_EQ(waiting.dimmed(1.2), 0.0F) << "a picture of the text is there";
    waiting.follow(nothing, 1.3);
    EXPECT_FALSE(waiting.hides_figures(1.3));
}

TEST(WaitNotice, WantsFramesWhereWhatIsSeenChanges) {
    WaitNotice waiting;
    waiting.follow(reading, 1.0);
    EXPECT_NEAR(waiting.due_s(1.0).value_or(-1.0), WaitNotice::delay_s, 1e-9);
    EXPECT_LT(waiting.due_s(1.15).value_or(9.0), 0.02) << "while it fades";
    EXPECT_FALSE(waiting.due_s(2.0));
}

}  // namespace
}  // namespace zeroset::test::wait_notice_test
