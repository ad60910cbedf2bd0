#pragma once

#include "papers/compare/compared_row.hpp"
#include "papers/compare/printed_tables.hpp"
#include "papers/voxels/proved_root.hpp"
#include "papers/voxels/voxel_ray.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace zeroset {

/// How often a method is right on rays in voxels, by the roots that are proved.
struct VoxelCounts {
    std::size_t voxels = 0;
    std::size_t roots = 0;    ///< with a first root that is proved
    std::size_t unknown = 0;  ///< of which nothing is proved; the counts below leave them out
    std::size_t missed = 0;   ///< a root is proved, none is found
    std::size_t added = 0;    ///< proved to be without a root, one is found
    std::size_t moved = 0;    ///< found farther than moved_by from the first root

    /// Counts a voxel in which the method finds `t`.
    void add(const VoxelRay& ray, const ProvedRoot& proved, double t);
};
inline constexpr double moved_by = 0.01;  ///< of a voxel's edge

/// The seven voxels of marching cubes with `rays` rays each, in lists of `at_once`: corners are 0
/// or 1, the level is 0.5. The same each time.
std::vector<VoxelRays> synthetic_voxels(std::size_t rays, std::size_t at_once);

/// A method's figures: what it finds, and how fast.
struct VoxelRow {
    std::string scene;
    const PrintedVoxels* printed = nullptr;
    double least = 0, most = 0, mean = 0;  ///< millions of intersections a second
    VoxelCounts counts;
};

/// Times a method on lists of voxels, each of them some times over, and counts what it finds.
/// `proved`: of all voxels in their order.
VoxelRow measured_voxels(const VoxelTable& table, const PrintedVoxels& printed,
                         std::span<const VoxelRays> voxels, std::span<const ProvedRoot> proved);

/// The proved roots of all voxels.
std::vector<ProvedRoot> proved_roots(std::span<const VoxelRays> voxels);

std::string voxel_heading_text(const VoxelTable& table);
std::string voxel_row_text(const VoxelTable& table, const VoxelRow& row);
/// Frames of the table's scenes by its methods and by beams, as lines with their titles.
std::string voxel_frames_text(const std::vector<ComparedRow>& frames);
nlohmann::ordered_json json_of(const VoxelTable& table, const std::vector<VoxelRow>& rows,
                               const std::vector<ComparedRow>& frames);

}  // namespace zeroset
