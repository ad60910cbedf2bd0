#pragma once

#include "engine/trace/surface_way.hpp"

namespace zeroset {

/// Plain isosurfaces of volumes, trilinear or cubic splines: first roots of tiles, voxel by voxel.
/// Tiles that ask for what only beams know are left to the beams.
class VoxelWay final : public SurfaceWay {
public:
    [[nodiscard]] bool is_of(const Kernel& surface) const override;
    bool trace_tile(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                    Counters& counters) const override;
};

}  // namespace zeroset
