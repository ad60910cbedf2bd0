#pragma once

#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"
#include "papers/octree/octant.hpp"
#include "papers/octree/octree_space.hpp"

#include <glm/glm.hpp>

#include <optional>

namespace zeroset {

/// A ray in implicit form [Stolte05, eq. 3]:
///   c_x (x - x_0) = c_y (y - y_0) = c_z (z - z_0),   c_x = sign(dx) |dy| |dz|, ...
/// and each of the three is the parameter T = t |dx dy dz|. Its numbers are the ray: they are that
/// of the pixel to some 2^-50 of the distances of eye and box (TileHits allows 2^-48), and nothing
/// that follows from them is rounded inward. All in the ray's axes, which are the world's but for
/// the directions of those along which it falls; so c > 0.
struct OctreeRay {
    glm::dvec3 start;           ///< (x_0, y_0, z_0)
    glm::dvec3 c;               ///< |c_x|, |c_y|, |c_z|
    unsigned sign_dir;          ///< bits of the axes that are turned
    int k;                      ///< the dominant axis: the least of c
    bool on_grid;               ///< starts where differences to planes have at most 54 bits
    double from, to;            ///< T in which the ray may be in the region; from >= 0
    double sure_from, sure_to;  ///< where it surely is
    double limit;               ///< T behind which nothing is wanted

    [[nodiscard]] bool is_turned(int axis) const { return (sign_dir >> axis & 1U) != 0; }
    /// T in a length along the dominant axis.
    [[nodiscard]] double step(double length) const { return c[k] * length; }
    /// The cube of all octants. In upward rounding.
    [[nodiscard]] Octant root(const OctreeSpace& space) const;
    /// The point at T, in the world.
    [[nodiscard]] glm::dvec3 point(double parameter) const;
};

/// A box in the world, with its ends as kernels take them.
struct RayBox {
    glm::dvec3 neg_lo, hi;
};

/// A box that holds the ray from T = from to T = to. In upward rounding.
RayBox box_on_ray(const OctreeRay& ray, double from, double to);
/// The part of an octant in the clip box. In upward rounding.
RayBox box_of_octant(const OctreeRay& ray, const Octant& octant, const Box& clip);
/// Puts a box into the columns of RangeBoxes as number i. In upward rounding.
template <class Real, std::size_t capacity>
void store_box(const RayBox& box, Real (&ends)[6][capacity], std::size_t i) {
    for (int axis = 0; axis < 3; ++axis) {
        ends[axis][i] = static_cast<Real>(box.neg_lo[axis]);
        ends[axis + 3][i] = static_cast<Real>(box.hi[axis]);
    }
}
/// The intersection of two boxes that have points in common but for roundings.
RayBox both(const RayBox& a, const RayBox& b);

/// The ray of a pixel of a tile; nothing where it does not meet the region. In upward rounding.
std::optional<OctreeRay> octree_ray(const TraceFrame& frame, const Tile& tile, const TileRays& rays,
                                    const OctreeSpace& space, int col, int row);

}  // namespace zeroset
