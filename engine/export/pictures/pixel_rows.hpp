#pragma once

#include "engine/export/pictures/picture_writer.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace zeroset {

/// How pixels lie in memory.
struct PixelLayout {
    int bits = 8;  ///< of a channel: 8 or 16
    bool alpha = false;
    std::endian order = std::endian::native;  ///< of 16 bits

    [[nodiscard]] std::size_t channels() const { return alpha ? 4 : 3; }
    [[nodiscard]] std::size_t pixel_bytes() const {
        return channels() * static_cast<std::size_t>(bits) / 8;
    }
};

/// Puts a band's pixels row by row into `rows` as RGB or RGBA, not multiplied by alpha. For 16 bits
/// the frame must keep its light. `height`: of the whole picture.
void take_pixel_rows(const PictureBand& band, int height, const PixelLayout& layout,
                     std::vector<std::uint8_t>& rows);

/// Puts a band's pixels without their background into `pixels`, as drawn_color gives them.
void take_drawn_pixels(const PictureBand& band, int height, std::vector<std::uint32_t>& pixels);

/// The linear light of a band's pixel with its alpha: mixed with the background, alpha 1; or, if
/// `without_background`, that of the drawn part alone, not multiplied by alpha.
std::array<float, 4> pixel_light(const PictureBand& band, std::size_t pixel,
                                 const std::array<float, 3>& background, bool without_background);

}  // namespace zeroset
