// Texts of how definitions were read.

#include "engine/language/rows/definition_readings.hpp"

#include "tests/engine/language/row_readers.hpp"

#include <gtest/gtest.h>

namespace zeroset::definition_readings_test {
namespace {

TEST(DefinitionReadings, FunctionsOfVectorsAreReadAsSuch) {
    RowReaders rows("f(p) = p.y + c\nr = 2\nx = f((x, y)) + r");
    const auto function = rows.definitions.read(*rows.table.of_statement(0));
    ASSERT_TRUE(function);
    EXPECT_EQ(*function, "f(p) = p.y + c");
    const auto value = rows.definitions.read(*rows.table.of_statement(1));
    ASSERT_TRUE(value);
    EXPECT_EQ(*value, "r = 2");
    ASSERT_EQ(rows.taken_notes().size(), 1U);
}

TEST(DefinitionReadings, WhatOnlyARowUsesIsReadByItsVariables) {
    RowReaders rows("r = 2 + v\n(r, v, 0), 0 < v < 1");
    ASSERT_TRUE(rows.patches.read(1));
    EXPECT_EQ(rows.definitions.read(*rows.table.of_statement(0)), "r = 2 + v");
    EXPECT_TRUE(rows.reader.names().parameters().empty());
}

}  // namespace
}  // namespace zeroset::definition_readings_test
