#include "engine/trace/patch/patch_outline.hpp"

#include "engine/real/unbounded.hpp"
#include "engine/trace/patch/patch_tree.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// More than rounding may shift a ray, in pixels.
constexpr double spare_pixel = 0x1p-10;
/// The most columns a row of an edge: nearly level edges say no more than the rectangle.
constexpr double steepest = 64.0;

/// The first pixel from `from` to `end` whose centre is not before a place, and the one behind the
/// last that is not after it.
int first_pixel(double place, int from, int end) {
    const double pixel = place + (1.0 - spare_pixel);
    return static_cast<int>(std::clamp<double>(pixel, from, end));
}
int end_pixel(double place, int from, int end) {
    const double pixel = place + (1.0 + spare_pixel);
    return static_cast<int>(std::clamp<double>(pixel, from, end));
}

}  // namespace

PatchSight without_growth(const PatchSight& sight) {
    PatchSight part = sight;
    part.kp *= form_inner;
    part.kq *= form_inner;
    return part;
}

PatchOutline::PatchOutline(const PatchSight& sight, double distance, const PixelGrid& grid)
    : grid_(grid), per_pixel_(1.0 / grid.pixel) {
    first_.fill({.col = -unbounded, .by_row = 0.0});
    end_.fill({.col = unbounded, .by_row = 0.0});
    const glm::dvec3 spread = sight.spread();
    // W is at least this: rounded downward.
    const double least = -(spread.z - sight.c.z - distance) * (1.0 - 0x1p-40);
    is_known_ = least > 0.0 && spread.x + spread.y + spread.z < unbounded;
    if (!is_known_) return;
    const double middle = distance + sight.c.z;
    u_ = sight.c.x / middle;
    v_ = sight.c.y / middle;
    struct Form {
        double p, q, rest;

        [[nodiscard]] double size() const { return std::abs(p) + std::abs(q) + rest; }
    };
    // The linear forms of a - u0 W and b - v0 W.
    const auto form_of = [&](int axis, double at) {
        const double size = std::abs(sight.c[axis]) + spread[axis] +
                            std::abs(at) * (distance + std::abs(sight.c.z) + spread.z);
        return Form{.p = sight.kp[axis] - at * sight.kp.z,
                    .q = sight.kq[axis] - at * sight.kq.z,
                    .rest = sight.e[axis] + std::abs(at) * sight.e.z + sight_rounding * size};
    };
    const Form a = form_of(0, u_);
    const Form b = form_of(1, v_);
    // Bound the part by a rectangle.
    const double per_least = 1.0 / least * (1.0 + 0x1p-40);
    u_radius_ = a.size() * per_least;
    v_radius_ = b.size() * per_least;
    // Bound it by parallels to the form's edges, unless these are nearly level.
    const auto set = [&](std::size_t i, double a_by, double b_by) {
        if (!(std::abs(a_by) < steepest * std::abs(b_by))) return;
        const double slope = -a_by / b_by;
        const Form both{.p = a.p + slope * b.p,
                        .q = a.q + slope * b.q,
                        .rest = a.rest + std::abs(slope) * b.rest};
        set_edges(i, slope, both.size() * per_least);
    };
    set(0, a.p, b.p);
    set(1, a.q, b.q);
}

void PatchOutline::set_edges(std::size_t i, double slope, double radius) {
    const double col = (u_ - grid_.u - slope * (grid_.v - v_)) * per_pixel_;
    const double cols = radius * per_pixel_;
    first_[i] = {.col = col - cols + (1.0 - spare_pixel), .by_row = slope};
    end_[i] = {.col = col + cols + (1.0 + spare_pixel), .by_row = slope};
}

TileRect PatchOutline::within(const TileRect& rect) const {
    if (!is_known_) return rect;
    const double col = (u_ - grid_.u) * per_pixel_;
    const double row = (grid_.v - v_) * per_pixel_;
    const double cols = u_radius_ * per_pixel_;
    const double rows = v_radius_ * per_pixel_;
    return {.col = first_pixel(col - cols, rect.col, rect.end_col),
            .row = first_pixel(row - rows, rect.row, rect.end_row),
            .end_col = end_pixel(col + cols, rect.col, rect.end_col),
            .end_row = end_pixel(row + rows, rect.row, rect.end_row)};
}

}  // namespace zeroset
