// Tests of how long what a wrong row drew is drawn.

#include "app/desktop/old_rows.hpp"

#include <gtest/gtest.h>

namespace zeroset::old_rows_test {
namespace {

const Sheet right{{.id = 1, .text = "x = 1"}};
const Sheet wrong{{.id = 1, .text = "x = "}};
const Sheet worse{{.id = 1, .text = "x = ("}};

TEST(OldRows, StayForASecondAfterTheLastKey) {
    OldRows rows;
    rows.follow(right, false, 0.0);
    EXPECT_TRUE(rows.stay(100.0));
    EXPECT_FALSE(rows.due_s(100.0));
    rows.follow(wrong, true, 100.0);
    EXPECT_TRUE(rows.stay(100.75));
    EXPECT_DOUBLE_EQ(rows.due_s(100.75).value_or(0.0), 0.25);
    rows.follow(worse, true, 100.75);
    EXPECT_TRUE(rows.stay(101.5));
    rows.follow(worse, true, 101.5);
    EXPECT_FALSE(rows.stay(101.75));
    EXPECT_FALSE(rows.due_s(101.75));
    rows.follow(right, false, 102.0);
    EXPECT_TRUE(rows.stay(102.0));
}

}  // namespace
}  // namespace zeroset::old_rows_test
