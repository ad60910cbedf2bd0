#pragma once

#include "engine/trace/voxels/level_grid.hpp"
#include "engine/trace/voxels/ray_block.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// Calls `look(cells, layers)` for the slabs of a grid, front to back along a bundle of rays, in
/// which the pyramid of minima and maxima does not exclude the level: of at most four layers, or
/// more where the rays are in too many bricks. Ends where it returns false.
template <class Sample, std::size_t support, class Look>
void walk_block(const LevelGrid<Sample, support>& grid, const RayBlock& block, const Look& look) {
    const std::int32_t step = block.step();
    const std::int32_t end = block.last_layer();
    std::int32_t layer = block.first_layer();
    int level = grid.top_level();
    while ((end - layer) * step >= 0) {
        const int shift = LevelGrid<Sample, support>::lowest_shift + level;
        const std::int32_t first = layer >> shift << shift;
        const std::int32_t last = first + (std::int32_t{1} << shift) - 1;
        const LayerRange layers = step > 0 ? LayerRange{.low = layer, .high = std::min(last, end)}
                                           : LayerRange{.low = std::max(first, end), .high = layer};
        const CellRectangle cells = block.cells(layers.low, layers.high);
        if (!cells.empty() && level > 0 &&
            grid.bricks_may_hold(level, cells, layers, block.axes())) {
            --level;
            continue;
        }
        if (!cells.empty() && level == 0) {
            const CellRectangle held = grid.in_bricks(cells, layers, block.axes());
            if (!held.empty() && !look(held, layers)) return;
        }
        layer = step > 0 ? layers.high + 1 : layers.low - 1;
        // Look at a larger brick where the rays have left one.
        const std::int32_t face = step > 0 ? layer : layer + 1;
        if ((face & ((std::int32_t{2} << shift) - 1)) == 0 && level < grid.top_level()) ++level;
    }
}

}  // namespace zeroset
