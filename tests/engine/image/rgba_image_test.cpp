#include "engine/image/rgba_image.hpp"

#include "engine/export/png.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace zeroset::test::rgba_image_test {
namespace {

/// 8x2: four drawn pixels of two colours, then three, then none twice.
Framebuffer frame() {
    Framebuffer frame(8, 2);
    for (const int row : {0, 1}) {
        for (int col = 0; col < frame.width; ++col) {
            const std::size_t at = frame.index(col, row);
            const bool drawn = col < 3 || (col == 3 && row == 0);
            frame.color[at] = col == 0 ? 0xFF000010U : 0xFF000030U;
            frame.depth[at] = drawn ? 1.0F : HUGE_VALF;
        }
    }
    return frame;
}

TEST(RgbaImage, IsTheMeanOfWhatIsDrawn) {
    const RgbaImage image = halved(frame());
    EXPECT_EQ(image.width, 4);
    EXPECT_EQ(image.height, 1);
    ASSERT_EQ(image.pixels.size(), 4U);
    EXPECT_EQ(image.pixels[0], 0xFF000020U);
    EXPECT_EQ(image.pixels[1], 0xBF000030U) << "three of four";
    EXPECT_EQ(image.pixels[2], 0x00000030U) << "the colour beside, transparent";
    EXPECT_EQ(image.pixels[3], 0U);
}

TEST(RgbaImage, IsTheSameAfterAFile) {
    const RgbaImage image = halved(frame());
    const std::vector<std::byte> png = png_of(image);
    ASSERT_GT(png.size(), 8U);
    EXPECT_EQ(image_from_png(png), image);
}

TEST(RgbaImage, IsNotReadFromWhatIsNoPicture) {
    const std::vector<std::byte> png = png_of(halved(frame()));
    EXPECT_FALSE(image_from_png({}));
    EXPECT_FALSE(image_from_png(std::span(png).first(png.size() / 2)));
    EXPECT_FALSE(image_from_png(std::as_bytes(std::span("no picture"))));
    const RgbaImage wide{5000, 1, std::vector<std::uint32_t>(5000)};
    EXPECT_FALSE(image_from_png(png_of(wide)));
}

}  // namespace
}  // namespace zeroset::test::rgba_image_test
