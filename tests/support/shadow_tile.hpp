#pragma once

#include "engine/light/shade.hpp"
#include "engine/light/shadow.hpp"
#include "engine/real/rounding.hpp"
#include "engine/render/tracers.hpp"
#include "engine/trace/hit_gradients.hpp"
#include "engine/trace/nearest.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

// A tile of a picture with what is proved of the shadows on it.

namespace zeroset::test {

struct ShadowTile {
    std::vector<TileHits> hits;  ///< of each surface
    ShadowBits shadows;
};

/// `frames`: one for each surface of a scene.
inline ShadowTile shadow_tile(const std::vector<TraceFrame>& frames, const Tile& tile,
                              ShadowWay way = ShadowWay::Beams) {
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
    result.shadows =
        find_shadows(frames, key_light(frames.front().view), {}, tile, lit.layers(), counters, way);
    return result;
}

inline bool has_bit(const TileBits& bits, std::size_t pixel) {
    return (bits[pixel / tile_size] >> pixel % tile_size & 1U) != 0;
}

}  // namespace zeroset::test
