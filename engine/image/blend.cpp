#include "engine/image/blend.hpp"

#include "engine/image/gamma.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset {
namespace {

/// Mean of opaque colours, taken in linear light.
std::uint32_t mean_of(const std::array<std::uint32_t, 5>& colors) {
    std::uint32_t mean = 0xFF000000U;
    for (unsigned shift = 0; shift < 24; shift += 8) {
        float light = 0.0F;
        for (const std::uint32_t color : colors)
            light += light_of_channel(color >> shift & 0xFFU);
        mean |= channel_of_light(light / 5.0F) << shift;
    }
    return mean;
}

/// Alpha of a pixel of which `hits` of five rays hit a surface.
std::uint32_t alpha_of(std::uint32_t hits) { return hits == 0 ? 255U : 51U * hits; }

}  // namespace

void blend_finer(const Framebuffer& finer, const PixelRect& rect, Framebuffer& picture) {
    for (int row = 0; row < rect.rows; ++row) {
        for (int col = 0; col < rect.cols; ++col) {
            const std::size_t above = finer.index(2 * col, 2 * row);
            const std::size_t below = finer.index(2 * col, 2 * row + 1);
            const std::size_t at = picture.index(rect.col + col, rect.row + row);
            std::uint32_t& color = picture.color[at];
            const std::array colors{color, finer.color[above], finer.color[above + 1],
                                    finer.color[below], finer.color[below + 1]};
            const bool even = std::ranges::all_of(colors, [&](auto c) { return c == color; });
            if (!even) color = mean_of(colors);
            const std::array depths{picture.depth[at], finer.depth[above], finer.depth[above + 1],
                                    finer.depth[below], finer.depth[below + 1]};
            const auto hits =
                std::ranges::count_if(depths, [](float d) { return std::isfinite(d); });
            color = (color & 0xFFFFFFU) | alpha_of(static_cast<std::uint32_t>(hits)) << 24U;
        }
    }
}

std::uint32_t without_background(std::uint32_t color, std::uint32_t background) {
    const std::uint32_t alpha = color >> 24U;
    const float part = static_cast<float>(alpha) / 255.0F;
    std::uint32_t drawn = alpha << 24U;
    for (unsigned shift = 0; shift < 24; shift += 8) {
        const float mixed = light_of_channel(color >> shift & 0xFFU);
        const float behind = light_of_channel(background >> shift & 0xFFU);
        drawn |= channel_of_light((mixed - (1.0F - part) * behind) / part) << shift;
    }
    return drawn;
}

}  // namespace zeroset
