// Rows that are equations or conditions, as they are typed.

#include "engine/language/rows/equation_reader.hpp"

#include "tests/engine/language/row_readers.hpp"

#include <gtest/gtest.h>

namespace zeroset::equation_reader_test {
namespace {

TEST(EquationReader, IsTheDifferenceOfBothSides) {
    RowReaders rows("x^2 = y, z < 1");
    const auto equation = rows.equations.read(0);
    ASSERT_TRUE(equation);
    EXPECT_FALSE(equation->solid);
    EXPECT_EQ(rows.text_of(equation->root), "where(x^2 - y, z < 1)");
    const auto restriction = rows.equations.restriction(0);
    ASSERT_TRUE(restriction && *restriction);
    EXPECT_EQ(rows.text_of(**restriction), "z < 1");
}

TEST(EquationReader, AConditionIsASolid) {
    RowReaders rows("x < 1 and not y < 2");
    const auto equation = rows.equations.read(0);
    ASSERT_TRUE(equation && equation->solid);
    EXPECT_EQ(rows.text_of(equation->root), "max(x - 1, 2 - y)");
}

TEST(EquationReader, ErrorsAreShownWhereTheyAre) {
    RowReaders mixed("x = y < 1");
    expect_error(mixed.equations.read(0), 2, "an equation and an inequality in one");
    RowReaders equation("x = y, z = 1");
    expect_error(equation.equations.read(0), 9, "behind a comma");
    RowReaders never("x = y, 1 < 0");
    expect_error(never.equations.read(0), 9, "this never holds");
    RowReaders thin("x < 1 and y == z");
    expect_error(thin.equations.read(0), 0, "no boundary");
    EXPECT_FALSE(thin.values.failed());
}

}  // namespace
}  // namespace zeroset::equation_reader_test
