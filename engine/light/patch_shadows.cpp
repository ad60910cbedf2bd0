#include "engine/light/patch_shadows.hpp"

#include "engine/trace/patch/patch_tracer.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace zeroset {
namespace {

/// One item for each pixel of a tile.
struct PatchRoom {
    std::vector<double> u, v, to;
    std::vector<PatchBlock> blocks;
};

}  // namespace

void find_patch_shadows(const ShadowSearch& search, ShadowBits& found, Counters& counters) {
    thread_local PatchRoom room;
    room.u.assign(LightPlaces::pixels, 0.0);
    room.v.assign(LightPlaces::pixels, 0.0);
    room.to.assign(LightPlaces::pixels, -std::numeric_limits<double>::infinity());
    room.blocks.assign(LightPlaces::pixels, PatchBlock::None);
    const double per_distance = 1.0 / search.rays.distance();
    for (std::size_t i = 0; i < LightPlaces::pixels; ++i) {
        if (!is_set(search.open, i)) continue;
        room.u[i] = static_cast<double>(search.places.u[i]) * per_distance;
        room.v[i] = static_cast<double>(search.places.v[i]) * per_distance;
        room.to[i] = static_cast<double>(search.places.s[i]) - search.bias - search.places.error;
    }
    find_patch_blocks(search.light, search.rays, room.u, room.v, room.to, room.blocks, counters);
    for (std::size_t i = 0; i < LightPlaces::pixels; ++i) {
        const std::uint64_t hit = std::uint64_t{1} << i % tile_size;
        if (room.blocks[i] == PatchBlock::Proved) found.prove_dark(i / tile_size, hit);
        if (room.blocks[i] == PatchBlock::Unknown) found.doubt(i / tile_size, hit);
    }
}

}  // namespace zeroset
