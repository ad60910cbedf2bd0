// Rays of pixels in implicit form [Stolte05, sec. 2.4].
//
// Differs from the paper:
// - A ray that starts outside of the cube starts just before it instead, at a point of a grid on
//   which all octants lie, down to the 51st level. So the differences in c_x (x - x_0) are exact,
//   and each bound is rounded once, by the product.
// - A component of the direction that is 0 would make two of the c 0, and with them all that the
//   form says of the others. It is taken for 2^-60 of the largest one.

#include "papers/octree/octree_ray.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

glm::dvec3 turned(const glm::dvec3& vector, unsigned sign_dir) {
    glm::dvec3 result = vector;
    for (int axis = 0; axis < 3; ++axis) {
        if ((sign_dir >> axis & 1U) != 0) result[axis] = -result[axis];
    }
    return result;
}

/// The ray as the view has it: origin + t direction, t the distance along the view.
struct ViewRay {
    glm::dvec3 origin, direction;

    [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// A point of the grid just before the cube; nothing where the eye is nearer.
std::optional<glm::dvec3> start_before(const ViewRay& ray, bool has_eye, double enters_at,
                                       const OctreeSpace& space) {
    constexpr double before = 0x1p-8;
    constexpr double grid = 0x1p-51;
    const double t = enters_at - before * space.edge;
    if (has_eye && !(t > 0)) return std::nullopt;
    const double unit = grid * space.edge;
    return unit * glm::floor(ray.at(t) / unit + 0.5);
}

/// Where a ray is searched, as t: `inside` what is shown, and not behind `limit`; and whether it
/// has a beginning at t = 0.
struct RayReach {
    DepthRange inside;
    double limit;
    bool has_beginning;
};

/// The implicit form of a ray from where it begins, or from before the cube.
std::optional<OctreeRay> implicit_form(const ViewRay& seen, const RayReach& reach,
                                       const TraceFrame& frame, const OctreeSpace& space) {
    const DepthRange& inside = reach.inside;
    const glm::dvec3 size = glm::abs(seen.direction);
    const double longest = std::max({size.x, size.y, size.z});
    const glm::dvec3 d = glm::max(size, glm::dvec3(0x1p-60 * longest));
    OctreeRay ray{};
    for (int axis = 0; axis < 3; ++axis) {
        if (seen.direction[axis] < 0) ray.sign_dir |= 1U << axis;
        if (d[axis] > d[ray.k]) ray.k = axis;
    }
    const auto before = start_before(seen, reach.has_beginning, inside.enter_lo, space);
    ray.on_grid = before.has_value();
    ray.start = turned(before.value_or(seen.origin), ray.sign_dir);
    ray.c = {d.y * d.z, d.z * d.x, d.x * d.y};
    // T by the dominant axis, where the region begins and ends.
    const double spare = 4.0 * place_error(frame);
    const auto parameter = [&](double t, double shift) {
        const double place = turned(seen.at(t), ray.sign_dir)[ray.k];
        return ray.c[ray.k] * (place - ray.start[ray.k] + shift);
    };
    ray.from = std::max(0.0, parameter(inside.enter_lo, -spare));
    ray.to = parameter(inside.exit_hi, spare);
    ray.sure_from = std::isfinite(inside.enter_hi) ? parameter(inside.enter_hi, spare) : unbounded;
    ray.sure_to = std::isfinite(inside.exit_lo) ? parameter(inside.exit_lo, -spare) : -unbounded;
    ray.limit = std::isfinite(reach.limit) ? parameter(reach.limit, spare) : reach.limit;
    if (!(ray.from < ray.to)) return std::nullopt;
    return ray;
}

}  // namespace

Octant OctreeRay::root(const OctreeSpace& space) const {
    const glm::dvec3 upper = -(space.corner + space.edge);
    Octant cube{.corner = space.corner, .length = space.edge, .in = from, .out = to};
    for (int axis = 0; axis < 3; ++axis) {
        if (is_turned(axis)) cube.corner[axis] = upper[axis];
    }
    return cube;
}

glm::dvec3 OctreeRay::point(double parameter) const {
    return turned(start + parameter / c, sign_dir);
}

RayBox box_on_ray(const OctreeRay& ray, double from, double to) {
    RayBox box{};
    for (int axis = 0; axis < 3; ++axis) {
        const double hi = ray.start[axis] + to / ray.c[axis];
        const double neg_lo = -ray.start[axis] + -from / ray.c[axis];
        box.neg_lo[axis] = ray.is_turned(axis) ? hi : neg_lo;
        box.hi[axis] = ray.is_turned(axis) ? neg_lo : hi;
    }
    return box;
}

RayBox box_of_octant(const OctreeRay& ray, const Octant& octant, const Box& clip) {
    RayBox box{};
    for (int axis = 0; axis < 3; ++axis) {
        const double hi = octant.corner[axis] + octant.length;
        const double neg_lo = -octant.corner[axis];
        box.neg_lo[axis] = ray.is_turned(axis) ? hi : neg_lo;
        box.hi[axis] = ray.is_turned(axis) ? neg_lo : hi;
    }
    return both(box, {.neg_lo = -clip.lo, .hi = clip.hi});
}

RayBox both(const RayBox& a, const RayBox& b) {
    const glm::dvec3 neg_lo = glm::min(a.neg_lo, b.neg_lo);
    return {.neg_lo = neg_lo, .hi = glm::max(glm::min(a.hi, b.hi), -neg_lo)};
}

std::optional<OctreeRay> octree_ray(const TraceFrame& frame, const Tile& tile, const TileRays& rays,
                                    const OctreeSpace& space, int col, int row) {
    const ViewFrame& view = frame.view;
    const PixelPoint at = tile.place(col, row);
    const PixelPoint first = pixel_centre(tile.col, tile.row);
    const DepthRange depths =
        rays.depths(rays.u(at.col - first.col), rays.v(at.row - first.row), 0.0, 0.0);
    if (depths.empty()) return std::nullopt;
    const double away = view.look_distance;
    return implicit_form(
        {.origin = view.origin(at, frame.image), .direction = view.direction(at, frame.image)},
        {.inside = {.enter_lo = away + depths.enter_lo,
                    .enter_hi = away + depths.enter_hi,
                    .exit_lo = away + depths.exit_lo,
                    .exit_hi = away + depths.exit_hi},
         .limit = away + rays.limit(static_cast<std::size_t>(row * tile_size + col)),
         .has_beginning = !view.parallel()},
        frame, space);
}

}  // namespace zeroset
