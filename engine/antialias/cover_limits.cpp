#include "engine/antialias/cover_limits.hpp"

#include "engine/real/scalar.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace zeroset {

void narrow_limits(const TraceFrame& surface, const Tile& tile, const TileHits& hits,
                   std::vector<float>& limits) {
    const PixelCover& cover = hits.cover;
    if (!cover.known || !cover.is_marked()) return;
    const TileRays rays(surface, tile);
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col) {
            const auto at = static_cast<std::size_t>(row * tile_size + col);
            const float to = cover.to[at];
            if (!(to < std::numeric_limits<float>::infinity()) || !(to < cover.other_from[at]))
                continue;
            const double distance =
                rays.distance_at(static_cast<double>(to), rays.u(col), rays.v(row));
            limits[at] = std::min(limits[at], float_above(distance));
        }
    }
}

}  // namespace zeroset
