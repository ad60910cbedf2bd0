#pragma once

#include "engine/light/lit_tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace zeroset {

/// Where the hits of a tile are in the view of a light with parallel rays: from the point looked
/// at, to the right, up and along the rays, in world units. Arrays hold one item a pixel, in rows
/// of tile_size.
struct LightPlaces {
    static constexpr std::size_t pixels = std::size_t{tile_size} * tile_size;

    /// With room for a whole vector after the last pixel.
    using Numbers = std::array<float, pixels + 16>;

    alignas(64) Numbers u, v, s;
    /// About how s changes on the surface with u, and with v; no steeper than `steepest`.
    alignas(64) Numbers by_u, by_v;
    double error = 0.0;  ///< a hit is no farther from its place, in u, v or s
    TileBits outside{};  ///< hits that are seen from where f is above 0, among those of find_places

    static constexpr float steepest = 16.0F;
};

/// A square of pixels of a tile.
struct Square {
    std::uint8_t col, row, side;

    /// The square's bits in each of its rows.
    [[nodiscard]] std::uint64_t bits() const {
        return (~std::uint64_t{0} >> (tile_size - side)) << col;
    }
    [[nodiscard]] std::array<Square, 4> quarters() const {
        const auto half = static_cast<std::uint8_t>(side / 2);
        const auto right = static_cast<std::uint8_t>(col + half);
        const auto below = static_cast<std::uint8_t>(row + half);
        return {Square{.col = col, .row = row, .side = half},
                Square{.col = right, .row = row, .side = half},
                Square{.col = col, .row = below, .side = half},
                Square{.col = right, .row = below, .side = half}};
    }
};

/// The least and the greatest of some numbers; of none: +inf and -inf.
struct PlaceRange {
    float least = std::numeric_limits<float>::infinity();
    float greatest = -std::numeric_limits<float>::infinity();

    [[nodiscard]] float size() const { return greatest - least; }
    [[nodiscard]] double middle() const {
        return static_cast<double>(0.5F * least + 0.5F * greatest);
    }
    /// The distance of the ends from the middle; in upward rounding no less.
    [[nodiscard]] double radius() const {
        return std::max(static_cast<double>(greatest) - middle(),
                        middle() - static_cast<double>(least));
    }
    void widen(const PlaceRange& by) {
        least = std::min(least, by.least);
        greatest = std::max(greatest, by.greatest);
    }
};

/// The ranges of some places; h is s - by_u u - by_v v.
struct PlaceBounds {
    PlaceRange u, v, s, h;
};

/// The bounds of the places whose bits are set, in a square of a side of 8 at most.
PlaceBounds bounds_of(const LightPlaces& places, const TileBits& bits, const Square& square,
                      float by_u, float by_v);

/// A box in the light's view.
struct LightBox {
    double u[2], v[2], s[2];
};

/// The places among `bits` that may be in the box.
TileBits places_in(const LightPlaces& places, const TileBits& bits, const LightBox& box);

/// Adds the places of a surface's hits, and finds which of these hits show the light the side that
/// they show the eye. In upward rounding.
TileBits find_places(const TraceFrame& frame, const ViewFrame& light, const Tile& tile,
                     const TileHits& hits, LightPlaces& places);

}  // namespace zeroset
