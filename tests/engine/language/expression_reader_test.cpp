// Expressions of a text as values, where they stand.

#include "engine/language/expressions/expression_reader.hpp"

#include "tests/engine/language/row_readers.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zeroset::expression_reader_test {
namespace {

/// The relation of a statement.
SyntaxId relation(const RowReaders& rows, std::size_t statement = 0) {
    return rows.tree.statements[statement].relation;
}

TEST(ExpressionReader, LocalNamesHideOthers) {
    RowReaders rows("c*x");
    const BuiltValue seven{.id = rows.values.builder().constant(7.0)};
    const LocalName outer{.name = "x", .value = seven, .outer = nullptr};
    const LocalName inner{.name = "c", .value = seven, .outer = &outer};
    const auto product = rows.reader.number(relation(rows), {.scope = &inner});
    ASSERT_TRUE(product);
    EXPECT_EQ(rows.text_of(*product), "7*7");
    const auto free = rows.reader.number(relation(rows), {});
    ASSERT_TRUE(free);
    EXPECT_EQ(rows.text_of(*free), "c*x");
    EXPECT_EQ(rows.reader.names().parameters(), std::vector<std::string>{"c"});
}

TEST(ExpressionReader, TheStatementDecidesWhichDefinitionIsMeant) {
    RowReaders rows("a = 1\nb := a + x\na = 2\na + y");
    const Definition& b = *rows.table.of_statement(1);
    const auto earlier = rows.reader.number(b.body, {.statement = 1});
    const auto later = rows.reader.number(relation(rows, 3), {.statement = 3});
    ASSERT_TRUE(earlier && later);
    EXPECT_EQ(rows.text_of(*earlier), "1 + x");
    EXPECT_EQ(rows.text_of(*later), "2 + y");
}

TEST(ExpressionReader, AConditionIsAnOperandAsANumber) {
    RowReaders rows("x < 1");
    const auto built = rows.reader.build(relation(rows), {});
    ASSERT_TRUE(built && built->condition);
    const auto operand = rows.reader.operand(relation(rows), {});
    ASSERT_TRUE(operand && !operand->condition);
    EXPECT_EQ(rows.taken_notes().size(), 1U);
}

TEST(ExpressionReader, ErrorsCarryTheirOffsets) {
    RowReaders rows("1 + mod(x, 0)");
    EXPECT_FALSE(rows.reader.number(relation(rows), {}));
    EXPECT_EQ(rows.values.failure().error().offset, 4U);
}

TEST(ExpressionReader, ErrorsInABodyOfTheLibraryAreShownAtItsCall) {
    RowReaders rows("x + prism(p, n, 1, 1)");
    const BuiltValue x{.id = rows.values.builder().variable(0)};
    ASSERT_TRUE(rows.values.done(x.id, 0));
    const LocalName p{.name = "p", .value = BuiltValue::vector({x, x, x}), .outer = nullptr};
    const LocalName n{.name = "n", .value = x, .outer = &p};
    EXPECT_FALSE(rows.reader.number(relation(rows), {.scope = &n}));
    const ParseError error = rows.values.failure().error();
    EXPECT_EQ(error.offset, 4U);
    EXPECT_EQ(error.reason, "the number of parts here is a whole number");
}

TEST(ExpressionReader, WholeNumbersAreExact) {
    RowReaders rows("(4 + 2)/3");
    const ExpressionReader::Complaint complaint{.reason = "whole", .hint = "one"};
    EXPECT_EQ(rows.reader.whole_number(relation(rows), {}, complaint), 2.0);
    RowReaders others("7/2");
    EXPECT_FALSE(others.reader.whole_number(relation(others), {}, complaint));
    EXPECT_EQ(others.values.failure().error().reason, "whole");
}

TEST(ExpressionReader, SlidersBoundSumsOnlyOutsideOfReadings) {
    RowReaders rows("sum(x^i, i, 0, n)");
    EXPECT_TRUE(rows.reader.number(relation(rows), {}));
    EXPECT_FALSE(rows.reader.number(relation(rows), {.reads_function = true}));
    EXPECT_EQ(rows.values.failure().error().reason, "the bounds of sum are whole numbers");
}

TEST(ExpressionReader, NumbersAreNoConditionsWhereTheseAreWanted) {
    using Numbers = ExpressionReader::Numbers;
    RowReaders rows("x + y");
    EXPECT_FALSE(rows.reader.condition(relation(rows), {}, Numbers::Refused));
    EXPECT_EQ(rows.values.failure().error().reason, "a condition is wanted here");
    EXPECT_TRUE(rows.reader.condition(relation(rows), {}, Numbers::TrueUnlessZero));
}

}  // namespace
}  // namespace zeroset::expression_reader_test
