#include "engine/antialias/edge_fit.hpp"
#include "engine/antialias/half_square.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

/// How far the fit may be off, in parts of its change across the square.
constexpr double most_error = 1.0 / 64;
/// How the thread may bend and taper: changes along it, in parts of those across.
constexpr double most_change = 1.0 / 16;

/// value + by_x x + by_y y + xx x^2 + xy x y + yy y^2
struct Quadratic {
    double value, by_x, by_y, xx, xy, yy;

    [[nodiscard]] double at(const SquareRay& p) const {
        return value + by_x * p.x + by_y * p.y + xx * p.x * p.x + xy * p.x * p.y + yy * p.y * p.y;
    }
};

/// The heights' quadratic function, by their slopes: rays are left top, right top, left bottom and
/// right bottom, a half of the side apart from the middle, 0.
Quadratic quadratic_of(SquareStretches rays, double half_side) {
    const auto by_x = [&](std::size_t i) { return half_side * rays[i].by_col; };
    const auto by_y = [&](std::size_t i) { return half_side * rays[i].by_row; };
    const double x_by_x = 0.5 * (by_x(2) - by_x(1) + by_x(4) - by_x(3));
    const double y_by_y = 0.5 * (by_y(3) - by_y(1) + by_y(4) - by_y(2));
    const double x_by_y = 0.5 * (by_x(3) - by_x(1) + by_x(4) - by_x(2));
    const double y_by_x = 0.5 * (by_y(2) - by_y(1) + by_y(4) - by_y(3));
    return {.value = rays[0].least,
            .by_x = by_x(0),
            .by_y = by_y(0),
            .xx = 0.5 * x_by_x,
            .xy = 0.5 * (x_by_y + y_by_x),
            .yy = 0.5 * y_by_y};
}

}  // namespace

double Thread::share(double with_half_width) const {
    const LinearOnSquare across{.value = -offset, .by_x = normal.x, .by_y = normal.y};
    LinearOnSquare before = across;
    LinearOnSquare behind = across;
    before.value -= with_half_width;
    behind.value += with_half_width;
    return part_below_zero(before).share - part_below_zero(behind).share;
}

SquareRay Thread::middle() const {
    return {.x = std::clamp(offset * normal.x, -1.0, 1.0),
            .y = std::clamp(offset * normal.y, -1.0, 1.0)};
}

std::optional<Thread> fit_thread(SquareStretches stretches, double half_side, double thinnest) {
    const bool all_inner =
        std::ranges::all_of(stretches, [](const RayStretch& ray) { return ray.inner; });
    if (!all_inner) return std::nullopt;
    const Quadratic h = quadratic_of(stretches, half_side);
    // The principal axes: `across` is the larger curvature, along the normal.
    const double mean = 0.5 * (h.xx + h.yy);
    const double spread = std::hypot(0.5 * (h.xx - h.yy), 0.5 * h.xy);
    const double across = mean + spread;
    const double along = mean - spread;
    if (!(across > 0.0) || !(std::abs(along) <= most_change * across)) return std::nullopt;
    const double angle = 0.5 * std::atan2(h.xy, h.xx - h.yy);
    const SquareRay normal{.x = std::cos(angle), .y = std::sin(angle)};
    const double slope = h.by_x * normal.x + h.by_y * normal.y;
    const double taper = h.by_y * normal.x - h.by_x * normal.y;
    const double offset = -0.5 * slope / across;
    const double least = h.value + 0.5 * offset * slope;
    // Farther away it is no thread of this square.
    if (!(std::abs(offset) <= 2.0) || !(std::abs(taper) <= most_change * across))
        return std::nullopt;
    double error = 0.0;
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        const double off = std::abs(h.at(square_rays[i]) - stretches[i].least);
        if (!(off <= most_error * across)) return std::nullopt;
        error = std::max(error, off);
    }
    const double square = -least / across;
    const double surely_none = -thinnest * thinnest;
    const bool empty = square < surely_none;
    // Where there may be one by twice the error that is seen, the fit does not tell.
    if (empty && !(square + 2.0 * error / across < surely_none)) return std::nullopt;
    return Thread{.normal = normal,
                  .offset = offset,
                  .half_width = square > thinnest * thinnest ? std::sqrt(square) : 0.0,
                  .empty = empty};
}

}  // namespace zeroset
