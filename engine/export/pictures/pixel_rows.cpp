#include "engine/export/pictures/pixel_rows.hpp"

#include "engine/base/parallel.hpp"
#include "engine/image/background.hpp"
#include "engine/image/gamma.hpp"
#include "engine/image/rgba_image.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

/// Writes a pixel's channels as bytes.
template <unsigned channels>
std::uint8_t* append_8(std::uint32_t color, std::uint8_t* out) {
    for (unsigned channel = 0; channel < channels; ++channel)
        *out++ = static_cast<std::uint8_t>(color >> 8U * channel & 0xFFU);
    return out;
}

void write_row_8(const PictureBand& band, int row, int height, bool alpha, std::uint8_t* out) {
    const Framebuffer& frame = band.frame;
    const std::size_t end = frame.index(0, row + 1);
    if (!alpha) {
        for (std::size_t at = frame.index(0, row); at < end; ++at)
            out = append_8<3>(band.painted.color[at], out);
        return;
    }
    const std::uint32_t background = background_color(frame.background, band.row + row, height);
    for (std::size_t at = frame.index(0, row); at < end; ++at)
        out = append_8<4>(drawn_color(frame, band.painted, at, background), out);
}

std::uint8_t* append_16(float shown, std::endian order, std::uint8_t* out) {
    const auto number = static_cast<std::uint32_t>(std::clamp(shown, 0.0F, 1.0F) * 65535.0F + 0.5F);
    const auto high = static_cast<std::uint8_t>(number >> 8U);
    const auto low = static_cast<std::uint8_t>(number & 0xFFU);
    *out++ = order == std::endian::big ? high : low;
    *out++ = order == std::endian::big ? low : high;
    return out;
}

void write_row_16(const PictureBand& band, int row, int height, const PixelLayout& layout,
                  std::uint8_t* out) {
    const Framebuffer& frame = band.frame;
    const auto background = background_light(frame.background, band.row + row, height);
    for (std::size_t at = frame.index(0, row); at < frame.index(0, row + 1); ++at) {
        const auto light = pixel_light(band, at, background, layout.alpha);
        for (std::size_t channel = 0; channel < 3; ++channel)
            out = append_16(std::sqrt(std::max(light[channel], 0.0F)), layout.order, out);
        if (layout.alpha) out = append_16(light[3], layout.order, out);
    }
}

}  // namespace

std::array<float, 4> pixel_light(const PictureBand& band, std::size_t pixel,
                                 const std::array<float, 3>& background, bool without_background) {
    const std::uint32_t painted = band.painted.color[pixel];
    if (painted != band.frame.color[pixel]) {
        return {light_of_channel(painted & 0xFFU), light_of_channel(painted >> 8U & 0xFFU),
                light_of_channel(painted >> 16U & 0xFFU),
                static_cast<float>(painted >> 24U) / 255.0F};
    }
    std::array<float, 4> light = band.frame.light[pixel];
    const float part = std::clamp(light[3], 0.0F, 1.0F);
    if (!without_background || part == 1.0F) {
        light[3] = 1.0F;
        return light;
    }
    if (part == 0.0F) return {};
    for (std::size_t channel = 0; channel < 3; ++channel)
        light[channel] =
            std::max((light[channel] - (1.0F - part) * background[channel]) / part, 0.0F);
    light[3] = part;
    return light;
}

void take_pixel_rows(const PictureBand& band, int height, const PixelLayout& layout,
                     std::vector<std::uint8_t>& rows) {
    assert(layout.bits == 8 || band.frame.light.size() == band.frame.color.size());
    const std::size_t row_bytes = static_cast<std::size_t>(band.frame.width) * layout.pixel_bytes();
    rows.resize(row_bytes * static_cast<std::size_t>(band.frame.height));
    parallel_for(static_cast<std::size_t>(band.frame.height), 0, [&](std::size_t i) {
        std::uint8_t* const out = rows.data() + i * row_bytes;
        const int row = static_cast<int>(i);
        if (layout.bits == 8) {
            write_row_8(band, row, height, layout.alpha, out);
        } else {
            write_row_16(band, row, height, layout, out);
        }
    });
}

void take_drawn_pixels(const PictureBand& band, int height, std::vector<std::uint32_t>& pixels) {
    const Framebuffer& frame = band.frame;
    pixels.resize(frame.color.size());
    parallel_for(static_cast<std::size_t>(frame.height), 0, [&](std::size_t i) {
        const int row = static_cast<int>(i);
        const auto background = background_color(frame.background, band.row + row, height);
        for (std::size_t at = frame.index(0, row); at < frame.index(0, row + 1); ++at)
            pixels[at] = drawn_color(frame, band.painted, at, background);
    });
}

}  // namespace zeroset
