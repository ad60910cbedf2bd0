// Segments, vectors and polygons: that their points make sense.

#include "engine/language/rows/thing_reader.hpp"

#include "tests/engine/language/row_readers.hpp"

#include <gtest/gtest.h>

namespace zeroset::thing_reader_test {
namespace {

PatchKind kind_of(RowReaders& rows, const RowSurface& surface) {
    return patch_of(rows.values.builder().finish(surface.root))->kind;
}

TEST(ThingReader, IsMadeOfPoints) {
    RowReaders rows("segment((0, 0, 0), (1, 2, 3))\nvector((0, 0, 0), (0, 0, 0))\nx = 1");
    ASSERT_TRUE(rows.things.may_read(0) && rows.things.may_read(1));
    EXPECT_FALSE(rows.things.may_read(2));
    const auto segment = rows.things.read(0);
    ASSERT_TRUE(segment);
    EXPECT_EQ(kind_of(rows, *segment), PatchKind::Segment);
    EXPECT_EQ(segment->text, "segment((0, 0, 0), (1, 2, 3))");
    expect_error(rows.things.read(1), 48, "this vector has no length");
}

TEST(ThingReader, APolygonIsFlat) {
    RowReaders rows(
        "polygon((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))\n"
        "polygon((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 1))\n"
        "polygon((0, 0, 0), (1, 1, 1), (2, 2, 2))");
    const auto square = rows.things.read(0);
    ASSERT_TRUE(square && square->sheet);
    EXPECT_TRUE(rows.taken_notes().empty());
    expect_error(rows.things.read(1), 93, "corner 4 is not in the plane");
    expect_error(rows.things.read(2), 104, "no area");
}

}  // namespace
}  // namespace zeroset::thing_reader_test
