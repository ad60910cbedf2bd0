#pragma once

#include <array>
#include <cstdint>

namespace zeroset {

/// The colours behind the surfaces: an even change from top to bottom, 0xRRGGBB.
struct Background {
    std::uint32_t top = 0x2C323A;
    std::uint32_t bottom = 0x121418;

    bool operator==(const Background&) const = default;
};

/// The background of an image row, RGBA as in Framebuffer.
std::uint32_t background_color(const Background& background, int row, int height);

/// The background of an image row as linear red, green and blue, not rounded to 8 bits.
std::array<float, 3> background_light(const Background& background, int row, int height);

}  // namespace zeroset
