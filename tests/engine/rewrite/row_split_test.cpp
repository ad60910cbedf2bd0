#include "engine/rewrite/row_split.hpp"

#include "engine/language/parse.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace zeroset::row_split_test {
namespace {

std::vector<std::string> texts_of(const std::vector<Expr>& parts) {
    std::vector<std::string> texts;
    for (const Expr& part : parts)
        texts.push_back(part.canonical());
    return texts;
}

using Texts = std::vector<std::string>;

TEST(RowSplit, LeavesForEachPointOnlyWhereXMeetsTheOthers) {
    const RowSplit split = split_for_rows(*parse("sin(x) + y^2 z"));
    EXPECT_EQ(texts_of(split.tables), Texts{"sin(x)"});
    EXPECT_EQ(texts_of(split.of_row), Texts{"y^2*z"});
    EXPECT_EQ(split.along.canonical(), "x + row0");
}

TEST(RowSplit, KeepsWAndTheParametersOfTheFunction) {
    const RowSplit split = split_for_rows(*parse("a x^2 + w y + cos(z b)"));
    EXPECT_EQ(texts_of(split.tables), Texts{"a*x^2"});
    EXPECT_EQ(texts_of(split.of_row), (Texts{"w*y", "cos(z*b)"}));
    EXPECT_EQ(split.along.canonical(), "x + row0 + row1");
    EXPECT_EQ(split.along.parameter_names(), (Texts{"a", "b", "row0", "row1"}));
}

TEST(RowSplit, AFunctionOfARowAloneIsOneNumber) {
    const RowSplit split = split_for_rows(*parse("y + z"));
    EXPECT_TRUE(split.tables.empty());
    EXPECT_EQ(split.along.canonical(), "row0");
    EXPECT_EQ(texts_of(split.of_row), Texts{"y + z"});
}

TEST(RowSplit, AFunctionOfXAloneIsATable) {
    const RowSplit split = split_for_rows(*parse("exp(x) - x"));
    EXPECT_TRUE(split.of_row.empty());
    EXPECT_EQ(texts_of(split.tables), Texts{"exp(x) - x"});
    EXPECT_EQ(split.along.canonical(), "x");
}

TEST(RowSplit, AConstantStaysOne) {
    const RowSplit split = split_for_rows(*parse("a - 2"));
    EXPECT_TRUE(split.tables.empty());
    EXPECT_TRUE(split.of_row.empty());
    EXPECT_EQ(split.along.canonical(), "a - 2");
}

TEST(RowSplit, TakesXAndTheCostliestFunctionsWhereThereAreMoreThanTables) {
    const RowSplit split =
        split_for_rows(*parse("x^2 y + sin(x) z + x^3 y z + exp(cos(x)) y^2 + (x + 1) z^2"));
    EXPECT_EQ(texts_of(split.tables), (Texts{"x", "exp(cos(x))", "sin(x)"}));
    EXPECT_EQ(split.along.canonical(), "x^2*row0 + z*row1 + x^3*row0*row1 + y*row2 + (x + 1)*row3");
}

}  // namespace
}  // namespace zeroset::row_split_test
