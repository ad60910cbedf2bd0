// Ray voxelisation and BSP octant ordering [Stolte05, sec. 2.3, 2.4, fig. 1 and 3].
//   f_x-, f_x+   c_x (x - x_0) rounded downward, upward; of y and z likewise
//   izyx         bits of the axes on whose upper side of the mid-planes the ray starts
//
// The paper's array tx[4] with its selection by the sign of dx is not needed in the ray's axes:
// along each, the ray enters at the lower plane. Besides the sub-octants that the ray's start rules
// out, those are left out that lie beyond a mid-plane which the ray does not meet in the octant.
// Bounds downward are kept with the other sign, so that upward rounding does both. The ray's
// stretch in the octant itself is a fourth interval, which keeps what is before the eye, behind the
// region, and the errors of the octants around it out.
//
// Differs from the paper: outward rounding alone never misses an octant, but near the last levels
// it passes some that the ray only comes within rounding of. Those are decided exactly, so that the
// octants passed are those of the ray, at all levels; for rays that start at an eye inside the cube
// they may be more.

#include "papers/octree/ray_voxelisation.hpp"

#include <algorithm>

namespace zeroset {
namespace {

__extension__ using Wide = __float128;

/// The intervals of the lower and the upper half of an octant along each axis: -f- and f+.
struct HalfBounds {
    double neg_lo[2][3], hi[2][3];
};

/// The ray's bits of `izyx`: it rises along all axes, so that it never comes back to what lies
/// below the planes of these.
unsigned starts_behind(const OctreeRay& ray, const Octant& octant) {
    unsigned izyx = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double middle = octant.corner[axis] + 0.5 * octant.length;
        if (ray.start[axis] > middle) izyx |= 1U << axis;
    }
    return izyx;
}

/// Whether a ray on the grid passes a sub-octant with more than a point: in 113 bits, in which
/// nothing is rounded.
[[gnu::noinline]] bool passes_exactly(const OctreeRay& ray, const Octant& octant, unsigned index) {
    const Wide half = Wide{octant.length} / 2;
    Wide in = ray.from;
    Wide out = ray.to;
    for (int axis = 0; axis < 3; ++axis) {
        Wide lower = octant.corner[axis];
        if ((index >> axis & 1U) != 0) lower += half;
        in = std::max(in, ray.c[axis] * (lower - ray.start[axis]));
        out = std::min(out, ray.c[axis] * (lower + half - ray.start[axis]));
    }
    return in < out;
}

/// Whether bounds in double may overlap only because they are rounded, each twice.
bool may_be_rounding(double neg_in, double out) { return neg_in + out <= 0x1p-49 * out; }

/// `decides`: whether what rounding leaves open is decided exactly, where that can be.
void find_in_bsp_order(const OctreeRay& ray, const Octant& octant, const HalfBounds& bounds,
                       bool decides, SubOctants& passed) {
    passed.count = 0;
    // Octant elimination: the bits that an index surely has, and those that it surely has not.
    unsigned set = starts_behind(ray, octant);
    unsigned clear = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(octant.in < bounds.hi[0][axis])) set |= 1U << axis;
        if (!(-bounds.neg_lo[1][axis] < octant.out)) clear |= 1U << axis;
    }
    if ((set & clear) != 0) return;
    const unsigned free = 7U & ~(set | clear);
    unsigned i = 0;
    do {
        const unsigned index = set | i;
        const unsigned x = index & 1U;
        const unsigned y = index >> 1U & 1U;
        const unsigned z = index >> 2U;
        const double neg_in =
            std::min({bounds.neg_lo[x][0], bounds.neg_lo[y][1], bounds.neg_lo[z][2], -octant.in});
        const double out =
            std::min({bounds.hi[x][0], bounds.hi[y][1], bounds.hi[z][2], octant.out});
        const bool overlap = -neg_in < out;
        const bool open = overlap && decides && ray.on_grid && may_be_rounding(neg_in, out);
        if (open ? passes_exactly(ray, octant, index) : overlap) passed.add(index, -neg_in, out);
        i = (i - free) & free;  // the next one with some of these bits
    } while (i != 0);
}

}  // namespace

void RoundedVoxelisation::pass(const OctreeRay& ray, const Octant& octant, SubOctants& passed) {
    HalfBounds bounds;
    const double half = 0.5 * octant.length;
    for (int axis = 0; axis < 3; ++axis) {
        const double c = ray.c[axis];
        const double start = ray.start[axis];
        const double lower = octant.corner[axis];
        const double middle = lower + half;
        bounds.neg_lo[0][axis] = c * (start - lower);
        bounds.hi[0][axis] = c * (middle - start);
        bounds.neg_lo[1][axis] = c * (start - middle);
        bounds.hi[1][axis] = c * (lower + octant.length - start);
    }
    find_in_bsp_order(ray, octant, bounds, true, passed);
}

void UnroundedVoxelisation::pass(const OctreeRay& ray, const Octant& octant, SubOctants& passed) {
    HalfBounds bounds;
    const double half = 0.5 * octant.length;
    for (int axis = 0; axis < 3; ++axis) {
        const double c = ray.c[axis];
        const double start = ray.start[axis];
        const double lower = octant.corner[axis];
        const double at_middle = c * (lower + half - start);
        bounds.neg_lo[0][axis] = -(c * (lower - start));
        bounds.hi[0][axis] = at_middle;
        bounds.neg_lo[1][axis] = -at_middle;
        bounds.hi[1][axis] = c * (lower + octant.length - start);
    }
    find_in_bsp_order(ray, octant, bounds, false, passed);
}

}  // namespace zeroset
