// Gargantini's traversal [Gargantini93], as [Stolte05, sec. 2.6] describes it: from where the ray
// enters an octant and leaves it, the ray's intersections with the three mid-planes by eq. 1; those
// that lie between, sorted, end the ray's stretches in its sub-octants, at most four. The parameter
// is T = t |dx dy dz| here, too: eq. 1 is x = x_0 + T / c_x.

#include "papers/octree/ray_voxelisation.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace zeroset {
namespace {

struct Crossing {
    double at;      ///< T
    unsigned axis;  ///< its bit
};

}  // namespace

void GargantiniTraversal::pass(const OctreeRay& ray, const Octant& octant, SubOctants& passed) {
    std::array<Crossing, 3> crossings{};
    std::size_t count = 0;
    unsigned index = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double middle = octant.corner[axis] + 0.5 * octant.length;
        const double d = 1.0 / ray.c[axis];
        // Where the entry lies behind a plane, by rounding at least, the plane is not crossed.
        if (ray.start[axis] + octant.in * d >= middle) {
            index |= 1U << axis;
            continue;
        }
        const double at = (middle - ray.start[axis]) / d;
        if (octant.in < at && at < octant.out) crossings[count++] = {.at = at, .axis = 1U << axis};
    }
    std::sort(crossings.begin(), crossings.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
    passed.count = 0;
    double in = octant.in;
    for (std::size_t i = 0; i < count; ++i) {
        if (in < crossings[i].at) passed.add(index, in, crossings[i].at);
        in = crossings[i].at;
        index |= crossings[i].axis;
    }
    passed.add(index, in, octant.out);
}

}  // namespace zeroset
