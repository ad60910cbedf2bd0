// Surfaces of graphs: that they depend on the point, and are cut to boxes.

#include "engine/language/rows/row_maker.hpp"

#include "tests/engine/language/row_readers.hpp"

#include <gtest/gtest.h>

#include <array>

namespace zeroset::row_maker_test {
namespace {

TEST(RowMaker, ASurfaceGoesByThePoint) {
    RowReaders rows("c = 1; d + 1");
    const auto root = rows.reader.number(rows.tree.statements[1].relation, {.statement = 1});
    ASSERT_TRUE(root);
    expect_error(rows.maker.surface(1, *root), 7, "no x, y or z");
}

TEST(RowMaker, CutsRowsToTheirBoxes) {
    const std::array cuts{CutText{.begin = 2, .end = 10, .box = {-1, 1, -2, 2, -3, 3}}};
    RowReaders rows("x\ny", cuts);
    for (const std::size_t statement : {0U, 1U}) {
        const auto equation = rows.equations.read(statement);
        auto surface = rows.maker.surface(statement, equation->root);
        ASSERT_TRUE(surface && rows.maker.cut(*surface));
        const bool is_cut = rows.values.builder().node(surface->root).op == Op::Where;
        EXPECT_EQ(is_cut, statement == 1);
        EXPECT_EQ(rows.maker.inside_box(statement).has_value(), statement == 1);
        // A box is no part of how the row was read.
        EXPECT_EQ(surface->text, is_cut ? "y = 0" : "");
    }
}

}  // namespace
}  // namespace zeroset::row_maker_test
