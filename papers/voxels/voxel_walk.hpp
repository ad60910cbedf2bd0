#pragma once

#include "engine/trace/ray_lines.hpp"
#include "engine/trace/voxels/isosurface.hpp"
#include "papers/voxels/voxel_ray.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace zeroset {

/// A ray on its way through the voxels of a grid: the point at depth s is origin + s direction in
/// indices of samples.
struct WalkingRay {
    std::array<double, 3> origin, direction, per_direction;
    double s = 0, end = 0;             ///< where it is, and where it ends
    double voxel_from = 0;             ///< s where it entered the voxel that was found last
    std::array<std::int32_t, 3> at{};  ///< the voxel that it is in
    int level = 0;                     ///< of the brick to be looked at; below 0: the voxel itself
    std::uint32_t looks = 0;           ///< bricks and voxels that were looked at
};

/// The voxels of an isosurface that rays go through, front to back: those with corners on both
/// sides of the level. Bricks of the pyramid that do not hold it are passed at once.
class VoxelWalk {
public:
    /// For samples of any type; the volume must outlive it.
    static std::unique_ptr<const VoxelWalk> make(const Isosurface& surface);
    VoxelWalk(const VoxelWalk&) = delete;
    VoxelWalk& operator=(const VoxelWalk&) = delete;
    virtual ~VoxelWalk() = default;

    /// Whether the line meets the grid; the ray is then at the grid's first voxel.
    bool begin(const RayLine& line, WalkingRay& ray) const;
    /// The next voxel of the ray; false: there is none left.
    virtual bool next(WalkingRay& ray, VoxelRay& voxel) const = 0;

protected:
    VoxelWalk(const VolumeData& data, int levels);

    /// Goes on to the next brick of 1 << shift cells; returns the place of the face between.
    std::int32_t leave(WalkingRay& ray, int shift) const;

    [[nodiscard]] int top_level() const { return levels_ - 1; }

private:
    IndexMap map_;
    std::array<std::int32_t, 3> last_cell_{};
    int levels_;
};

}  // namespace zeroset
