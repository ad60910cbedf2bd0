#pragma once

#include "engine/light/shade.hpp"
#include "engine/light/shadow.hpp"
#include "engine/real/rounding.hpp"
#include "engine/render/tracers.hpp"
#include "engine/trace/hit_gradients.hpp"
#include "engine/trace/nearest.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// A tile of a picture with what is proved of the shadows on it.

namespace zeroset::test {

struct ShadowTile {
    std::vector<TileHits> hits;  ///< of each surface
    ShadowBits shadows;
    std::uint64_t cells = 0;  ///< evaluated for the shadows
};

/// The centres of a tile's pixels as places of their own, with which shadows are found by single
/// rays.
struct CentrePlaces {
    std::array<float, tile_pixels> col{}, row{};
    RayPlaces places{.col = col.data(), .row = row.data()};

    CentrePlaces() {
        for (std::size_t at = 0; at < tile_pixels; ++at) {
            col[at] = static_cast<float>(at % tile_size);
            row[at] = static_cast<float>(at / tile_size);
        }
    }
    CentrePlaces(const CentrePlaces&) = delete;
    CentrePlaces& operator=(const CentrePlaces&) = delete;
    ~CentrePlaces() = default;
};

/// `frames`: one for each surface of a scene; `singly`: shadows by single rays.
inline ShadowTile shadow_tile(const std::vector<TraceFrame>& frames, const Tile& tile,
                              bool singly = false) {
    const UpwardRegisters upward;
    ShadowTile result;
    result.hits.resize(frames.size());
    Counters counters;
    NearestSurfaces nearest;
    nearest.clear();
    for (std::size_t i = 0; i < frames.size(); ++i) {
        find_tracer("beams")->trace_tile(frames[i], tile, result.hits[i], counters);
        find_gradients(frames[i], tile, result.hits[i], counters);
        nearest.add(result.hits[i], static_cast<std::uint8_t>(i));
    }
    for (std::size_t i = 0; i < frames.size(); ++i)
        nearest.keep_nearest(result.hits[i], static_cast<std::uint8_t>(i));
    LitTile lit;
    lit.begin(result.hits);
    const CentrePlaces centres;
    Tile asked = tile;
    if (singly) asked.places = &centres.places;
    counters = {};
    result.shadows =
        find_shadows(frames, key_light(frames.front().view), {}, asked, lit.layers(), counters);
    result.cells = counters.form + counters.range;
    return result;
}

inline bool has_bit(const TileBits& bits, std::size_t pixel) {
    return (bits[pixel / tile_size] >> pixel % tile_size & 1U) != 0;
}

}  // namespace zeroset::test
