#pragma once

#include "papers/voxels/voxel_tracers.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace zeroset {

/// Millions of intersections of rays with voxels a second, as they were printed for a method.
struct PrintedVoxels {
    VoxelMethod method;
    std::string_view name;  ///< as the tracers here are called
    std::array<double, 3> millions;
};

/// A table of [Marmitt04], as data.
struct VoxelTable {
    std::string_view name;  ///< as it is typed
    std::string_view source, machine;
    std::string_view note;  ///< where what is measured here is not what was measured there
    RaysAtOnce rays;
    bool synthetic;  ///< voxels of marching cubes; else those of scenes
    std::array<std::string_view, 3> columns;
    std::span<const PrintedVoxels> rows;
};

std::span<const VoxelTable> voxel_tables();
/// nullptr when there is none of the name.
const VoxelTable* find_voxel_table(std::string_view name);

/// A scene in place of those of the paper: a volume that the program makes itself.
struct VoxelScene {
    std::string_view name, formula;
    double half_edge;  ///< of the clip box about the origin
};
std::span<const VoxelScene> voxel_scenes();

}  // namespace zeroset
