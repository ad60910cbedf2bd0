#pragma once

#include "engine/trace/tile_hits.hpp"

#include <cstdint>
#include <vector>

namespace zeroset {

/// Which surface is nearest to the eye on each pixel of a tile, when all that were added are
/// compared by depth; of equal depths the surface added first. Depths are middles of brackets, and
/// where brackets overlap the middles decide.
class NearestSurfaces {
public:
    NearestSurfaces();
    /// Empties it: a tile without surfaces.
    void clear();
    void add(const TileHits& hits, std::uint8_t surface);
    /// Distances beyond which nothing changes the answer any more (see Tile::limits).
    [[nodiscard]] const float* limits() const { return depth_.data(); }
    /// Takes out of what was added as `surface` the hits on pixels where another one is nearer, and
    /// the certificates of those that have an unsettled cell of any surface in front of them.
    void keep_nearest(TileHits& hits, std::uint8_t surface) const;

private:
    // One item a pixel, as in Tile::limits.
    std::vector<float> depth_;      ///< of the nearest hit; +inf: none
    std::vector<float> unsettled_;  ///< of the first unsettled cell of any surface; +inf: none
    std::vector<std::uint8_t> surface_;
};

}  // namespace zeroset
