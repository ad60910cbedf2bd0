#pragma once

#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"
#include "engine/view/pixel_ray.hpp"

#include <cmath>
#include <cstddef>

namespace zeroset {

/// Fills in the gradients of those of `hits.points` that are still hits: in double, of the branch
/// of f that vanishes there, against the ray where f falls along it. Where the gradient vanishes or
/// is none, it is that of a point nearby, or of differences; against the ray where the search was
/// stopped.
void find_gradients(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters);

/// Calls `take(pixel, ray, distance)` for each hit of a tile, row by row: the index of its pixel in
/// rows of tile_size, its ray, and where on that it is.
template <class Take>
void for_each_hit(const TraceFrame& frame, const Tile& tile, const TileHits& hits,
                  const Take& take) {
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col) {
            const auto pixel = static_cast<std::size_t>(row * tile_size + col);
            const auto distance = static_cast<double>(hits.depth[pixel]);
            if (!std::isfinite(distance)) continue;
            take(pixel, pixel_ray(frame.view, tile.place(col, row), frame.image), distance);
        }
    }
}

}  // namespace zeroset
