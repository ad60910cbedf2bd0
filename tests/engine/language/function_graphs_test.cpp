// Graphs of functions that stand alone.

#include "engine/language/rows/function_graphs.hpp"

#include "tests/engine/language/row_readers.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace zeroset::function_graphs_test {
namespace {

TEST(FunctionGraphs, AreOfTwoAxes) {
    RowReaders rows("f(x, z) = x z\ng(a) = a\nh(x, y) = g(x)");
    for (Definition& definition : rows.table.all())
        ASSERT_TRUE(rows.definitions.read(definition));
    ASSERT_TRUE(rows.graphs.may_read(rows.table.all()[0]));
    EXPECT_FALSE(rows.graphs.may_read(rows.table.all()[1]));
    const auto graph = rows.graphs.read(rows.table.all()[0]);
    ASSERT_TRUE(graph && *graph);
    EXPECT_EQ(rows.text_of((*graph)->root), "y - x*z");
    EXPECT_EQ(rows.taken_notes(), std::vector<std::string>{"this is the graph of y = f(x, z)"});
    const auto none = rows.graphs.read(rows.table.all()[1]);
    ASSERT_TRUE(none);
    EXPECT_FALSE(*none);
}

}  // namespace
}  // namespace zeroset::function_graphs_test
