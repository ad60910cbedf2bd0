#include "engine/trace/tile_hits.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace zeroset::pixel_cover_test {
namespace {

constexpr std::size_t size = tile_size;
constexpr std::size_t pixels = size * size;

/// The marks of a pixel: nothing, one sheet, a sheet with something before its end, or
/// something that is no sheet.
enum class Kind : std::uint8_t { Nothing, Sheet, SheetAndMore, More };

Kind kind_of(std::size_t pixel) { return static_cast<Kind>((pixel * 2654435761U >> 7U) % 4); }

void write(PixelCover& cover, std::size_t pixel, Kind kind) {
    if (kind == Kind::Nothing) return;
    cover.mark(pixel);
    cover.last[pixel] = 3.0F;
    if (kind != Kind::More) {
        cover.from[pixel] = 1.0F;
        cover.to[pixel] = 2.0F;
    }
    if (kind == Kind::SheetAndMore) cover.other_from[pixel] = 2.0F;
    if (kind == Kind::More) cover.other_from[pixel] = 0.5F;
}

TEST(PixelCover, TellsWhichPixelsOfARowAreMixed) {
    PixelCover cover;
    cover.clear();
    // Marks every other block, in a board's pattern, and one whole row of blocks.
    const auto is_written = [](std::size_t pixel) {
        const std::size_t row = pixel / size / tile_block;
        const std::size_t col = pixel % size / tile_block;
        return row == 5 || (row + col) % 2 == 0;
    };
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        if (is_written(pixel)) write(cover, pixel, kind_of(pixel));
    }
    for (std::size_t row = 0; row < size; ++row) {
        const std::uint64_t mixed = cover.mixed_in_row(static_cast<int>(row));
        for (std::size_t col = 0; col < size; ++col) {
            const std::size_t pixel = row * size + col;
            const Kind kind = is_written(pixel) ? kind_of(pixel) : Kind::Nothing;
            ASSERT_EQ((mixed >> col & 1U) != 0, kind == Kind::SheetAndMore || kind == Kind::More)
                << col << ", " << row;
        }
    }
}

TEST(PixelCover, HasNoMixedPixelsInBlocksThatSheetsCoverUntilMoreIsMarked) {
    constexpr std::size_t pixel = 5 * size + 12;
    PixelCover cover;
    cover.clear();
    cover.from[pixel] = 1.0F;
    cover.to[pixel] = 2.0F;
    cover.mark_covered(pixel);
    EXPECT_TRUE(cover.is_marked());
    EXPECT_TRUE(cover.is_marked(pixel));
    EXPECT_FALSE(cover.is_marked(pixel + tile_block));
    EXPECT_EQ(cover.mixed_in_row(5), 0U);
    write(cover, pixel + 1, Kind::More);
    EXPECT_EQ(cover.mixed_in_row(5), std::uint64_t{1} << 13U);
    cover.clear();
    EXPECT_FALSE(cover.is_marked(pixel));
    EXPECT_EQ(cover.mixed_in_row(5), 0U);
    EXPECT_EQ(cover.from[pixel], std::numeric_limits<float>::infinity());
}

TEST(PixelCover, ForgetsWhatWasMarkedWhereverThatWas) {
    constexpr float none = std::numeric_limits<float>::infinity();
    PixelCover cover;
    for (std::size_t first = 0; first < pixels; first += 61) {
        cover.clear();
        write(cover, first, Kind::SheetAndMore);
        write(cover, pixels - 1 - first, Kind::More);
        ASSERT_TRUE(cover.is_marked());
        cover.clear();
        ASSERT_FALSE(cover.is_marked());
        for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
            ASSERT_EQ(cover.from[pixel], none) << first << ", " << pixel;
            ASSERT_EQ(cover.to[pixel], none) << first << ", " << pixel;
            ASSERT_EQ(cover.other_from[pixel], none) << first << ", " << pixel;
            ASSERT_EQ(cover.last[pixel], -none) << first << ", " << pixel;
        }
    }
}

}  // namespace
}  // namespace zeroset::pixel_cover_test
