#pragma once

#include "engine/antialias/cover_sample.hpp"
#include "engine/antialias/half_square.hpp"
#include "engine/antialias/square_rays.hpp"

#include <cstdint>
#include <limits>

namespace zeroset {

/// The rest of a square beside an edge.
struct SquareRest {
    double share;           ///< of the square
    SquarePart part;        ///< of share 0: not known
    SquareRayFlags misses;  ///< the square's rays that go beside the edge

    /// A place that stands for it.
    [[nodiscard]] SquareRay middle() const;
};
/// All of a square but a part with an edge that these rays go beside.
inline SquareRest rest_beside(const SquarePart& part, const SquareRayFlags& misses) {
    return {.share = 1.0 - part.share, .part = part.rest(), .misses = misses};
}

/// A square part of a pixel, or a ray that stands for a part.
struct CoverSquare {
    std::uint16_t pixel;           ///< in the tile, in rows of tile_size
    std::uint8_t level = 0;        ///< the side is 2^-level of the pixel's
    std::uint8_t least_level = 0;  ///< squares above it are divided in any case
    double col = 0.0, row = 0.0;   ///< of the middle, in pixels from the pixel's middle, downwards
    double side = 1.0;             ///< in pixels; 0: a ray
    double area = 1.0;             ///< of the part that it stands for, in pixels
    const SquareRest* rest = nullptr;  ///< else all of it is wanted
    MixedPixel* whole = nullptr;       ///< the pixel, if this is all of it
    /// The depth of the hit of the pixel's own ray, if this is all of the pixel; +inf: there is
    /// none.
    double hit = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool is_ray() const { return side == 0.0; }
    /// The part that is wanted: its share, and a place that stands for it.
    [[nodiscard]] double share() const { return rest != nullptr ? rest->share : 1.0; }
    [[nodiscard]] SquareRay middle() const {
        return rest != nullptr ? rest->middle() : square_middle;
    }
    /// A place of the square, as `col` and `row`.
    [[nodiscard]] double col_of(const SquareRay& place) const { return col + 0.5 * side * place.x; }
    [[nodiscard]] double row_of(const SquareRay& place) const { return row + 0.5 * side * place.y; }
    /// The quarter about the middle of which that ray goes.
    [[nodiscard]] CoverSquare quarter(const SquareRay& middle) const {
        return {.pixel = pixel,
                .level = static_cast<std::uint8_t>(level + 1U),
                .least_level = least_level,
                .col = col_of(middle),
                .row = row_of(middle),
                .side = 0.5 * side,
                .area = 0.25 * area};
    }
    /// A ray that stands for some of it.
    [[nodiscard]] CoverSquare ray(const SquareRay& place, double share) const {
        return {.pixel = pixel,
                .level = level,
                .col = col_of(place),
                .row = row_of(place),
                .side = 0.0,
                .area = share * area};
    }
};

}  // namespace zeroset
