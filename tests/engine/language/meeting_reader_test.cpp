// Curves where two surfaces meet.

#include "engine/language/rows/meeting_reader.hpp"

#include "tests/engine/language/row_readers.hpp"

#include <gtest/gtest.h>

namespace zeroset::meeting_reader_test {
namespace {

PatchKind kind_of(RowReaders& rows, const RowSurface& surface) {
    return patch_of(rows.values.builder().finish(surface.root))->kind;
}

TEST(MeetingReader, IsOfTwoEquations) {
    RowReaders rows("x = 1 and y = z, z < 2\nx < 1 and y = 2\nx = 1 and 2 = 3");
    ASSERT_TRUE(rows.meetings.may_read(0));
    EXPECT_FALSE(rows.meetings.may_read(1));
    const auto curve = rows.meetings.read(0);
    ASSERT_TRUE(curve);
    EXPECT_EQ(kind_of(rows, *curve), PatchKind::Meeting);
    EXPECT_EQ(curve->text, "x - 1 = 0 and y - z = 0, z < 2");
    expect_error(rows.meetings.read(2), 39, "no x, y or z");
}

}  // namespace
}  // namespace zeroset::meeting_reader_test
