// Boundaries of the solids in which conditions hold.

#include "engine/language/rows/solid_boundaries.hpp"

#include "tests/engine/language/row_readers.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace zeroset::solid_boundaries_test {
namespace {

/// The boundary of a condition that is a text; "none" where it has none.
std::string boundary(std::string_view text) {
    RowReaders rows(text);
    const auto condition = rows.reader.build(rows.tree.statements[0].relation, {});
    if (!condition) return rows.values.failure().error().reason;
    SolidBoundaries boundaries(rows.values);
    const auto result = boundaries.boundary(condition->id, 0);
    return result ? rows.text_of(*result) : "none";
}

TEST(SolidBoundaries, JoinAsTheirConditionsDo) {
    EXPECT_EQ(boundary("x < 1"), "x - 1");
    EXPECT_EQ(boundary("x < 1 and y > 2"), "max(x - 1, 2 - y)");
    EXPECT_EQ(boundary("x < 1 or y > 2"), "min(x - 1, 2 - y)");
    EXPECT_EQ(boundary("not (x < 1 and y > 2)"), "-max(x - 1, 2 - y)");
}

TEST(SolidBoundaries, EqualitiesHoldInNoSolid) {
    EXPECT_EQ(boundary("x < 1 and y == z"), "none");
    EXPECT_EQ(boundary("x < 1 or y != z"), "none");
}

TEST(SolidBoundaries, ManyConditionsNeedNoDeepStack) {
    std::string text = "x < 0";
    for (int i = 1; i < 20'000; ++i)
        text += " or x < " + std::to_string(i);
    EXPECT_TRUE(boundary(text).starts_with("min("));
}

}  // namespace
}  // namespace zeroset::solid_boundaries_test
