#pragma once

#include "engine/image/framebuffer.hpp"

#include <array>
#include <cstdint>
#include <limits>

namespace zeroset {

/// A part of a pixel that shows one surface, and a hit that stands for it.
struct CoverSample {
    std::uint16_t pixel;   ///< in the tile, in rows of tile_size
    std::uint8_t surface;  ///< index in the scene
    Certificate certificate;
    float area;                     ///< of the part; that of a pixel is 1
    float col, row;                 ///< where the hit's ray passes the image, as in RayPlaces
    float distance;                 ///< of the hit along its ray, as in Framebuffer::depth
    std::array<float, 3> gradient;  ///< of f at the hit
};

/// A pixel of which it is not known that one smooth sheet covers it, or nothing.
struct MixedPixel {
    std::uint16_t pixel;
    float from;  ///< depth along the view axis, as TileRays has it, before which nothing is seen
    float hit;   ///< how far the hit of its own ray is from the eye; +inf: there is none
    /// Depth behind which nothing is seen; +inf: not known.
    float to = std::numeric_limits<float>::infinity();
    /// The level to which the pixel is divided in any case: 4^level samples.
    std::uint8_t least_level = 0;
    bool is_calm = false;  ///< all pixels around it hit the same surface and look like it
    /// One smooth sheet of this surface covers the pixel, between `from` and `sheet_to`; +inf: that
    /// is not known.
    std::uint8_t surface = 0;
    float sheet_to = std::numeric_limits<float>::infinity();

    /// out: one smooth sheet covers it after all, and its own hit stands for it.
    bool is_plain = false;

    [[nodiscard]] bool is_sheet() const {
        return sheet_to < std::numeric_limits<float>::infinity();
    }
};

}  // namespace zeroset
