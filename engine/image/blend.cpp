#include "engine/image/blend.hpp"

#include "engine/image/gamma.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset {
namespace {

/// light_of_channel of all channels.
const std::array<float, 256> channel_lights = [] {
    std::array<float, 256> lights{};
    for (std::uint32_t channel = 0; channel < 256; ++channel)
        lights[channel] = light_of_channel(channel);
    return lights;
}();

/// The mean of colours, in linear light.
struct MeanColor {
    std::array<float, 3> light{};
    int count = 0;
    std::uint32_t cover = 0;  ///< the sum of the hits' alpha

    void add(std::uint32_t color, bool hit) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            light[channel] += channel_lights[color >> 8 * channel & 0xFFU];
        ++count;
        cover += hit ? color >> 24U : 0U;
    }
    /// With the mean of the hits' alpha; 255 where there is none.
    [[nodiscard]] std::uint32_t color() const {
        const auto colors = static_cast<std::uint32_t>(count);
        const std::uint32_t alpha = cover == 0 ? 255U : (cover + colors / 2U) / colors;
        std::uint32_t mean = alpha << 24U;
        for (std::size_t channel = 0; channel < 3; ++channel)
            mean |= channel_of_light(light[channel] / static_cast<float>(count)) << 8 * channel;
        return mean;
    }
};

/// The mean of the light of the square of pixels from `first` on.
std::array<float, 4> mean_light(const Framebuffer& finer, std::size_t first, std::size_t side) {
    std::array<float, 4> mean{};
    for (std::size_t y = 0; y < side; ++y) {
        const std::size_t left = first + y * static_cast<std::size_t>(finer.width);
        for (std::size_t at = left; at < left + side; ++at) {
            for (std::size_t channel = 0; channel < mean.size(); ++channel)
                mean[channel] += finer.light[at][channel];
        }
    }
    for (float& channel : mean)
        channel /= static_cast<float>(side * side);
    return mean;
}

}  // namespace

void blend_finer(const Framebuffer& finer, int across, const PixelRect& rect,
                 Framebuffer& picture) {
    const auto side = static_cast<std::size_t>(across);
    for (int row = 0; row < rect.rows; ++row) {
        for (int col = 0; col < rect.cols; ++col) {
            const std::size_t first = finer.index(across * col, across * row);
            MeanColor mean;
            for (std::size_t y = 0; y < side; ++y) {
                const std::size_t left = first + y * static_cast<std::size_t>(finer.width);
                for (std::size_t at = left; at < left + side; ++at)
                    mean.add(finer.color[at], std::isfinite(finer.depth[at]));
            }
            const std::size_t to = picture.index(rect.col + col, rect.row + row);
            picture.color[to] = mean.color();
            if (!finer.light.empty() && !picture.light.empty())
                picture.light[to] = mean_light(finer, first, side);
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
