#pragma once

#include "engine/antialias/cover_sample.hpp"
#include "engine/antialias/half_square.hpp"
#include "engine/antialias/square_rays.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace zeroset {

/// Finds what pixels show, part by part [Florez08, sec. 5.5.2], and adds samples to `out`. A part
/// of a pixel that no sample stands for shows the background. Takes those from `pixels` that one
/// smooth sheet covers after all: their own hits stand for them. Ends early when the frames' limit
/// is over: then nothing is said of some pixels. In upward rounding.
void find_cover(std::span<const TraceFrame> surfaces, const Tile& tile,
                std::vector<MixedPixel>& pixels, std::vector<CoverSample>& out, Counters& counters);

/// Narrows `limits`, those of Tile for whole pixels, by a surface's hits: behind a sheet that
/// covers all of a pixel nothing of it is seen. Behind a hit of its ray alone something may be,
/// beside it. In upward rounding.
void narrow_limits(const TraceFrame& surface, const Tile& tile, const TileHits& hits,
                   std::vector<float>& limits);

/// The rest of a square beside an edge.
struct SquareRest {
    double share;           ///< of the square
    SquarePart part;        ///< of share 0: not known
    SquareRayFlags misses;  ///< the square's rays that go beside the edge

    /// A place in the rest that stands for it.
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
