#include "ui/widgets/number_field.hpp"

#include <gtest/gtest.h>

namespace zeroset::ui::number_field_test {
namespace {

TEST(NumberField, ReadsPointsAndCommas) {
    double value = 0.0;
    EXPECT_TRUE(read_typed("2.5", value));
    EXPECT_EQ(value, 2.5);
    EXPECT_TRUE(read_typed(" 3,25 ", value));
    EXPECT_EQ(value, 3.25);
    EXPECT_TRUE(read_typed("-1e-3", value));
    EXPECT_EQ(value, -1e-3);
}

TEST(NumberField, LeavesTheValueWhereNoNumberIsTyped) {
    double value = 7.0;
    for (const char* text : {"", " ", "x", "2,5,1", "1 2", "3mm", "--1"})
        EXPECT_FALSE(read_typed(text, value)) << text;
    EXPECT_EQ(value, 7.0);
}

}  // namespace
}  // namespace zeroset::ui::number_field_test
