#pragma once

#include "engine/light/lit_tile.hpp"
#include "engine/trace/trace_frame.hpp"

#include <span>

namespace zeroset {

/// Makes light of the hits of a tile: `hits[i]` are those of surface i, with their gradients; no
/// pixel is hit in two. With `shadows` it finds which hits the key light does not reach, until
/// `limit` is over. In upward rounding.
void light_tile(std::span<const TraceFrame> surfaces, bool shadows, const TimeLimit& limit,
                const Tile& tile, std::span<const TileHits> hits, LitTile& out, Counters& counters);

}  // namespace zeroset
