#include "engine/image/rgba_image.hpp"

#include "engine/image/blend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

/// The mean of some pixels' colours.
class Mean {
public:
    void add(std::uint32_t color) {
        for (std::size_t i = 0; i < sums_.size(); ++i)
            sums_[i] += (color >> (8U * i)) & 0xFFU;
        ++count_;
    }
    [[nodiscard]] std::uint32_t count() const { return count_; }
    /// The mean colour, with alpha 0; needs at least one pixel.
    [[nodiscard]] std::uint32_t color() const {
        std::uint32_t mean = 0;
        for (std::size_t i = 0; i < sums_.size(); ++i)
            mean |= ((sums_[i] + count_ / 2) / count_) << (8U * i);
        return mean;
    }

private:
    std::array<std::uint32_t, 3> sums_{};
    std::uint32_t count_ = 0;
};

std::uint32_t pixel_of(const Framebuffer& frame, int col, int row) {
    Mean mean;
    for (const int down : {0, 1}) {
        for (const int right : {0, 1}) {
            const std::size_t at = frame.index(2 * col + right, 2 * row + down);
            if (std::isfinite(frame.depth[at])) mean.add(frame.color[at]);
        }
    }
    if (mean.count() == 0) return 0;
    return mean.color() | ((mean.count() * 255U / 4U) << 24U);
}

std::size_t index(const RgbaImage& image, int col, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
           static_cast<std::size_t>(col);
}

/// The mean colour, with alpha 0, of the drawn pixels around (col, row); 0 where there are none.
std::uint32_t color_around(const RgbaImage& image, int col, int row) {
    Mean mean;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, image.height - 1); ++y) {
        for (int x = std::max(col - 1, 0); x <= std::min(col + 1, image.width - 1); ++x) {
            const std::uint32_t pixel = image.pixels[index(image, x, y)];
            if (pixel >= 1U << 24U) mean.add(pixel);
        }
    }
    return mean.count() == 0 ? 0 : mean.color();
}

void spread_colors(RgbaImage& image) {
    const RgbaImage before = image;
    for (int row = 0; row < image.height; ++row) {
        for (int col = 0; col < image.width; ++col) {
            std::uint32_t& pixel = image.pixels[index(image, col, row)];
            if (pixel == 0) pixel = color_around(before, col, row);
        }
    }
}

}  // namespace

std::uint32_t drawn_color(const Framebuffer& frame, const Framebuffer& painted, std::size_t pixel,
                          std::uint32_t background) {
    constexpr std::uint32_t opaque = 0xFF000000U;
    const std::uint32_t color = frame.color[pixel];
    const bool is_hit = frame.depth[pixel] < std::numeric_limits<float>::infinity();
    if (painted.color[pixel] != color) return painted.color[pixel];
    if (is_hit && !is_partly_drawn(color)) return color | opaque;
    return is_partly_drawn(color) ? without_background(color, background) : 0;
}

RgbaImage halved(const Framebuffer& frame) {
    RgbaImage image{.width = frame.width / 2, .height = frame.height / 2, .pixels = {}};
    for (int row = 0; row < image.height; ++row) {
        for (int col = 0; col < image.width; ++col)
            image.pixels.push_back(pixel_of(frame, col, row));
    }
    spread_colors(image);
    return image;
}

}  // namespace zeroset
