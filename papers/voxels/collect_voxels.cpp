#include "papers/voxels/collect_voxels.hpp"

#include "engine/trace/ray_lines.hpp"
#include "engine/trace/tile_grid.hpp"
#include "engine/trace/voxels/isosurface.hpp"
#include "papers/voxels/proved_root.hpp"
#include "papers/voxels/voxel_walk.hpp"

#include <limits>

namespace zeroset {

std::vector<VoxelRays> collect_voxels(const TraceFrame& frame, std::size_t at_once) {
    std::vector<VoxelRays> all;
    const auto surface = isosurface(frame.kernel, frame.scene);
    if (!surface) return all;
    const auto walk = VoxelWalk::make(*surface);
    const TileGrid grid(frame.image.width, frame.image.height);
    RayLines lines;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const Tile tile = grid.tile(i);
        lines.begin(frame, tile, TileRays(frame, tile), std::numeric_limits<float>::digits);
        for (const std::uint32_t pixel : lines.pixels()) {
            WalkingRay ray;
            VoxelRay voxel;
            if (!walk->begin(lines.of(pixel), ray)) continue;
            while (walk->next(ray, voxel)) {
                if (all.empty() || all.back().count() == at_once) all.emplace_back();
                all.back().add(voxel);
                if (proved_first_root(voxel).kind == ProvedRoot::Kind::Root) break;
            }
        }
    }
    for (VoxelRays& rays : all)
        rays.pad();
    return all;
}

}  // namespace zeroset
