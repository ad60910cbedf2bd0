// Values of definitions: built once, and anew for the variables of a row.

#include "engine/language/expressions/definition_values.hpp"

#include "tests/engine/language/row_readers.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zeroset::definition_values_test {
namespace {

GraphValues::Built value(RowReaders& rows, std::size_t statement, RowScope* row = nullptr) {
    Definition& definition = *rows.table.of_statement(statement);
    return rows.reader.definitions().value(definition, rows.reader.name_of(definition),
                                           {.statement = statement, .row = row});
}

TEST(DefinitionValues, AreBuiltOnce) {
    RowReaders rows("a = noise(x, y, z)\nb = a + (x < 1)\nb");
    const auto first = value(rows, 1);
    const auto again = value(rows, 1);
    ASSERT_TRUE(first && again);
    EXPECT_EQ(first->id, again->id);
    ASSERT_NE(rows.reader.definitions().known(*rows.table.of_statement(0)), nullptr);
}

TEST(DefinitionValues, GoByTheVariablesOfARow) {
    RowReaders rows("r = 2 + v\nc = 3\n(r, v, c), 0 < v < 1");
    RowScope row(rows.variables.going_by({"v"}));
    const BuiltValue five{.id = rows.values.builder().constant(5.0)};
    const LocalName v{.name = "v", .value = five, .outer = nullptr};
    row.bind(&v);
    const auto by_row = value(rows, 0, &row);
    const auto free = value(rows, 0);
    ASSERT_TRUE(by_row && free);
    EXPECT_EQ(rows.text_of(by_row->id), "2 + 5");
    EXPECT_EQ(rows.text_of(free->id), "2 + v");
    EXPECT_FALSE(row.holds(*rows.table.of_statement(1)));
    const BuiltValue six{.id = rows.values.builder().constant(6.0)};
    const LocalName other{.name = "v", .value = six, .outer = nullptr};
    row.bind(&other);
    EXPECT_EQ(rows.text_of(value(rows, 0, &row)->id), "2 + 6");
    EXPECT_EQ(*rows.variables.names_of(*rows.table.of_statement(0)), std::vector<std::string>{"v"});
}

TEST(DefinitionValues, NothingIsDefinedByItself) {
    RowReaders rows("a = b + 1\nb = a\nb + x");
    EXPECT_FALSE(value(rows, 0));
    EXPECT_EQ(rows.values.failure().error().reason, "'a' is defined by itself");
}

TEST(DefinitionValues, ABuiltInNameKeepsItsMeaningInItsOwnDefinition) {
    RowReaders rows("x + r\nr := r + 1");
    const auto r = value(rows, 1);
    ASSERT_TRUE(r);
    EXPECT_EQ(rows.text_of(r->id), "sqrt(x^2 + y^2 + z^2) + 1");
}

TEST(DefinitionValues, ChainsMayBeLong) {
    constexpr int count = 20'000;
    std::string text = "a_0 = x\n";
    for (int i = 1; i < count; ++i)
        text += "a_" + std::to_string(i) + " = a_" + std::to_string(i - 1) + " + 1\n";
    RowReaders rows(text + "a_" + std::to_string(count - 1) + " + y");
    EXPECT_TRUE(value(rows, count - 1));
}

TEST(DefinitionValues, AVectorIsAllArgumentsOfAFunction) {
    RowReaders rows("f(a, b) = a - b\nf((x, y))\nf(x)");
    const auto spread = rows.reader.number(rows.tree.statements[1].relation, {.statement = 1});
    ASSERT_TRUE(spread);
    EXPECT_EQ(rows.text_of(*spread), "x - y");
    EXPECT_TRUE(rows.table.of_statement(0)->is_called);
    EXPECT_FALSE(rows.reader.number(rows.tree.statements[2].relation, {.statement = 2}));
    EXPECT_EQ(rows.values.failure().error().reason, "f takes 2 arguments, not 1");
}

}  // namespace
}  // namespace zeroset::definition_values_test
