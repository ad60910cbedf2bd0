#include "engine/image/blend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset {
namespace {

/// Of colours with gamma 2.
std::uint32_t mean_of(const std::array<std::uint32_t, 5>& colors) {
    std::uint32_t mean = 0xFF000000U;
    for (unsigned shift = 0; shift < 24; shift += 8) {
        std::uint32_t light = 0;
        for (const std::uint32_t color : colors) {
            const std::uint32_t channel = color >> shift & 0xFFU;
            light += channel * channel;
        }
        const float value = std::sqrt(static_cast<float>(light) / 5.0F);
        mean |= std::min(255U, static_cast<std::uint32_t>(value + 0.5F)) << shift;
    }
    return mean;
}

}  // namespace

void blend_finer(const Framebuffer& finer, const PixelRect& rect, Framebuffer& picture) {
    for (int row = 0; row < rect.rows; ++row) {
        for (int col = 0; col < rect.cols; ++col) {
            const std::size_t above = finer.index(2 * col, 2 * row);
            const std::size_t below = finer.index(2 * col, 2 * row + 1);
            std::uint32_t& color = picture.color[picture.index(rect.col + col, rect.row + row)];
            const std::array colors{color, finer.color[above], finer.color[above + 1],
                                    finer.color[below], finer.color[below + 1]};
            const bool even = std::ranges::all_of(colors, [&](auto c) { return c == color; });
            if (!even) color = mean_of(colors);
        }
    }
}

}  // namespace zeroset
