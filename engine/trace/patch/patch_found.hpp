#pragma once

#include "engine/trace/patch/patch_leaf.hpp"
#include "engine/trace/tile_hits.hpp"

namespace zeroset {

/// What leaves wrote down for the rays of a tile: `found`, and the depths in `reach`.
struct TileFound {
    const double* u;
    const double* v;
    const double* reach;
    const LeafFound* found;
    double look_distance;
    int cols, rows;
};

/// Puts the hits of Drawn and Proved rays into a tile's; those with a normal that is no number keep
/// that.
void put_found(const TileFound& tile, TileHits& hits);

}  // namespace zeroset
