#include "engine/trace/ways/surface_ways.hpp"

#include "engine/trace/blobs/blob_way.hpp"
#include "engine/trace/patch/patch_way.hpp"
#include "engine/trace/voxels/voxel_way.hpp"

#include <algorithm>
#include <array>

namespace zeroset {

const SurfaceWay& way_of(const Kernel& surface) {
    static const SurfaceWay formulas;
    static const VoxelWay voxels;
    static const BlobWay blobs;
    static const PatchWay patches;
    static const std::array<const SurfaceWay*, 4> all{&patches, &voxels, &blobs, &formulas};
    return **std::ranges::find_if(all, [&](const SurfaceWay* way) { return way->is_of(surface); });
}

}  // namespace zeroset
