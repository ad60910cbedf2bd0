// Rows that are given by a point: which they are, their ranges and their texts.

#include "engine/language/rows/patch_reader.hpp"

#include "tests/engine/language/row_readers.hpp"

#include <gtest/gtest.h>

#include <array>

namespace zeroset::patch_reader_test {
namespace {

PatchKind kind_of(RowReaders& rows, const RowSurface& surface) {
    return patch_of(rows.values.builder().finish(surface.root))->kind;
}

TEST(PatchReader, TheNumberOfRangesIsTheKind) {
    RowReaders rows("(1, 2, 3)\n(t, 2, 3), 0 < t < 1\np(u, v) = (u, v, 0), 0 < u < v, 0 < v < 1");
    constexpr std::array kinds{PatchKind::Point, PatchKind::Curve, PatchKind::Surface};
    for (const std::size_t statement : {0U, 1U}) {
        ASSERT_TRUE(rows.patches.may_read(statement));
        const auto surface = rows.patches.read(statement);
        ASSERT_TRUE(surface);
        EXPECT_EQ(kind_of(rows, *surface), kinds.at(statement));
    }
    ASSERT_TRUE(rows.patches.may_read(2));
    expect_error(rows.patches.read(2), 54, "the range of u goes by v");
}

TEST(PatchReader, TakesNoConditionsAndNoEquations) {
    RowReaders rows("x = 1\n(x, y, z) = p, x < 1\n(x, y, z), x < 1");
    EXPECT_FALSE(rows.patches.may_read(0));
    EXPECT_FALSE(rows.patches.may_read(1));
    ASSERT_TRUE(rows.patches.may_read(2));
    expect_error(rows.patches.read(2), 40, "only ranges of its variables");
}

TEST(PatchReader, ATextHasAllOfItsRanges) {
    RowReaders rows("(u, v, 2 u v), 1 > u > 0, 0 <= v <= c");
    const auto surface = rows.patches.read(0);
    ASSERT_TRUE(surface);
    EXPECT_EQ(surface->text, "(u, v, 2*u*v), 0 < u < 1, 0 < v < c");
}

}  // namespace
}  // namespace zeroset::patch_reader_test
