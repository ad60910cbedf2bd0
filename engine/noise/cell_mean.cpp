#include "engine/noise/cell_mean.hpp"

#include "engine/real/bounds_product.hpp"

#include <algorithm>

namespace zeroset {
namespace {

ValueBounds hull_of(double a, double b) { return {.lo = std::min(a, b), .hi = std::max(a, b)}; }

/// Whether a derivative is taken along an axis of which the corner is at the far side.
bool is_gone(std::size_t corner, const FadeOrders& orders) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (orders[axis] > 0 && (corner >> axis & 1U) != 0) return true;
    }
    return false;
}

}  // namespace

FadeRange::FadeRange(double from, double to) {
    const Fade first(from);
    const Fade last(to);
    value = hull_of(first.value, last.value);
    slope = hull_of(first.slope, last.slope);
    bend = hull_of(first.bend, last.bend);
    // The slope is greatest in the middle, the second derivative at (3 - sqrt(3))/6 and least at
    // (3 + sqrt(3))/6.
    constexpr double top_of_bend = 0.2113248654051871;
    constexpr double near = 1e-15;
    constexpr double largest_bend = 5.773502691896259;
    if (from <= 0.5 && to >= 0.5) slope.hi = 1.875;
    if (from <= top_of_bend + near && to >= top_of_bend - near) bend.hi = largest_bend;
    if (from <= 1 - top_of_bend + near && to >= 1 - top_of_bend - near) bend.lo = -largest_bend;
}

/// The ranges of the linear functions; along axes of derivatives those of the differences of the
/// functions at both sides.
auto MeanOver::ranges(const NoiseCell& cell, const FadeOrders& orders) const -> Ends {
    NoiseCell lines = cell;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (orders[axis] == 0) continue;
        const std::size_t step = std::size_t{1} << axis;
        for (std::size_t c = 0; c < 8; ++c) {
            if ((c & step) != 0) continue;
            lines.number[c] = lines.number[c | step] - lines.number[c];
            for (Corners& slopes : lines.gradient)
                slopes[c] = slopes[c | step] - slopes[c];
        }
    }
    Ends ends{.lo = lines.number, .hi = lines.number};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const ValueBounds& share = part_.shares[axis];
        for (std::size_t c = 0; c < 8; ++c) {
            const double slope = lines.gradient[axis][c];
            const double low = slope * share.lo;
            const double high = slope * share.hi;
            ends.lo[c] += std::min(low, high);
            ends.hi[c] += std::max(low, high);
        }
    }
    return ends;
}

ValueBounds MeanOver::mean(Ends ends, const FadeOrders& orders) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (orders[axis] > 0) continue;
        const std::size_t step = std::size_t{1} << axis;
        const ValueBounds& s = part_.fades[axis].value;
        for (Corners* const numbers : {&ends.lo, &ends.hi}) {
            for (std::size_t c = 0; c < 8; ++c) {
                if ((c & step) != 0) continue;
                const double a = (*numbers)[c];
                const double b = (*numbers)[c | step];
                (*numbers)[c] = a + s.lo * (b - a);
                (*numbers)[c | step] = a + s.hi * (b - a);
            }
        }
    }
    ValueBounds hull{.lo = ends.lo[0], .hi = ends.hi[0]};
    for (std::size_t c = 1; c < 8; ++c) {
        if (!is_gone(c, orders)) hull.add({.lo = ends.lo[c], .hi = ends.hi[c]});
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const FadeRange& fade = part_.fades[axis];
        if (orders[axis] > 0) hull = product_of(hull, orders[axis] == 1 ? fade.slope : fade.bend);
    }
    return hull;
}

ValueBounds MeanOver::of_functions(const FadeOrders& orders) const {
    return mean(ranges(cell_, orders), orders);
}

ValueBounds MeanOver::of_slopes(std::size_t axis, const FadeOrders& orders) const {
    return mean(ranges({.number = cell_.gradient[axis]}, orders), orders);
}

}  // namespace zeroset
