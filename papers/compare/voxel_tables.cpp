#include "papers/compare/voxel_tables.hpp"

#include <algorithm>

namespace zeroset {
namespace {

// Each row: method, name, three figures. NOLINTBEGIN(modernize-use-designated-initializers)

// Least, most, mean
constexpr std::array marmitt_table_1{
    PrintedVoxels{VoxelMethod::Midpoint, "midpoint", {1.28, 33.3, 26.88}},
    PrintedVoxels{VoxelMethod::Linear, "linear", {0.46, 7.54, 6.84}},
    PrintedVoxels{VoxelMethod::Neubauer, "neubauer", {0.56, 3.18, 3.04}},
    PrintedVoxels{VoxelMethod::Schwarze, "schwarze", {0.44, 3.26, 3.03}},
    PrintedVoxels{VoxelMethod::Marmitt, "marmitt", {0.57, 3.23, 2.92}},
};
constexpr std::array marmitt_table_2{
    PrintedVoxels{VoxelMethod::Midpoint, "midpoint", {2.59, 98.41, 85.48}},
    PrintedVoxels{VoxelMethod::Linear, "linear", {1.17, 13.93, 13.35}},
    PrintedVoxels{VoxelMethod::Neubauer, "neubauer", {0.19, 8.01, 3.04}},
    PrintedVoxels{VoxelMethod::Schwarze, "schwarze", {0.24, 2.20, 1.98}},
    PrintedVoxels{VoxelMethod::Marmitt, "marmitt", {0.85, 4.80, 4.35}},
};
// Bonsai, aneurism, engine
constexpr std::array marmitt_table_3{
    PrintedVoxels{VoxelMethod::Midpoint, "midpoint", {26.21, 26.18, 26.22}},
    PrintedVoxels{VoxelMethod::Linear, "linear", {6.65, 6.65, 6.68}},
    PrintedVoxels{VoxelMethod::Neubauer, "neubauer", {2.93, 2.94, 2.94}},
    PrintedVoxels{VoxelMethod::Schwarze, "schwarze", {1.60, 1.56, 1.48}},
    PrintedVoxels{VoxelMethod::Marmitt, "marmitt", {2.76, 2.80, 2.73}},
};
constexpr std::array marmitt_table_4{
    PrintedVoxels{VoxelMethod::Midpoint, "midpoint", {87.71, 87.12, 87.13}},
    PrintedVoxels{VoxelMethod::Linear, "linear", {13.68, 13.66, 13.67}},
    PrintedVoxels{VoxelMethod::Neubauer, "neubauer", {7.65, 7.60, 6.94}},
    PrintedVoxels{VoxelMethod::Schwarze, "schwarze", {1.49, 1.39, 1.44}},
    PrintedVoxels{VoxelMethod::Marmitt, "marmitt", {4.37, 4.56, 4.39}},
};
// NOLINTEND(modernize-use-designated-initializers)

constexpr std::string_view opteron = "AMD Opteron 1.8 GHz";
constexpr std::string_view synthetic_note =
    "which seven configurations of marching cubes and which views is not printed: a corner, an "
    "edge, two corners across a face and across the cube, three corners, a face, and every other "
    "corner, with rays between random points of two faces";
constexpr std::string_view scenes_note =
    "the bonsai, the aneurism and the engine are scans that do not come with the program: volumes "
    "that it makes itself are in their place, so that speeds compare, not scenes";

constexpr std::array<std::string_view, 3> speeds{"min", "max", "avg"};
constexpr std::array<std::string_view, 3> scans{"bonsai", "aneurism", "engine"};

constexpr std::array voxels{
    VoxelTable{.name = "marmitt-table-1",
               .source = "Marmitt et al. 2004, table 1",
               .machine = opteron,
               .note = synthetic_note,
               .rays = RaysAtOnce::One,
               .synthetic = true,
               .columns = speeds,
               .rows = marmitt_table_1},
    VoxelTable{.name = "marmitt-table-2",
               .source = "Marmitt et al. 2004, table 2, SIMD",
               .machine = opteron,
               .note = synthetic_note,
               .rays = RaysAtOnce::Packet,
               .synthetic = true,
               .columns = speeds,
               .rows = marmitt_table_2},
    VoxelTable{.name = "marmitt-table-3",
               .source = "Marmitt et al. 2004, table 3",
               .machine = opteron,
               .note = scenes_note,
               .rays = RaysAtOnce::One,
               .synthetic = false,
               .columns = scans,
               .rows = marmitt_table_3},
    VoxelTable{.name = "marmitt-table-4",
               .source = "Marmitt et al. 2004, table 4, SIMD",
               .machine = opteron,
               .note = scenes_note,
               .rays = RaysAtOnce::Packet,
               .synthetic = false,
               .columns = scans,
               .rows = marmitt_table_4},
};

constexpr std::array scenes{
    VoxelScene{.name = "marschner_lobb",
               .formula = "scan = volume(\"@marschner_lobb\"); scan(x, y, z) = 0.5",
               .half_edge = 1.0},
    VoxelScene{.name = "bone",
               .formula = "scan = volume(\"@bone\"); scan(x, y, z) = 0.5",
               .half_edge = 1.0},
    VoxelScene{.name = "orbital",
               .formula = "scan = volume(\"@orbital\"); scan(x, y, z) = 0.3",
               .half_edge = 28.0},
    VoxelScene{.name = "atoms",
               .formula = "scan = volume(\"@atoms\"); scan(x, y, z) = 0.5",
               .half_edge = 5.0},
};

}  // namespace

std::span<const VoxelTable> voxel_tables() { return voxels; }

const VoxelTable* find_voxel_table(std::string_view name) {
    const auto found = std::ranges::find(voxels, name, &VoxelTable::name);
    return found == voxels.end() ? nullptr : &*found;
}

std::span<const VoxelScene> voxel_scenes() { return scenes; }

}  // namespace zeroset
