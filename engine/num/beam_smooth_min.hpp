#pragma once

#include "engine/num/beam_functions.hpp"
#include "engine/num/smooth_min.hpp"

// Beam forms of the blend min(a, b) - h^2/4 = b + g(a - b) (engine/num/smooth_min.hpp), over any
// carrier, in upward rounding.

namespace zeroset {

/// Where the blend equals its first or its second operand, or may be replaced by it; never both.
template <class Mask>
struct BlendSides {
    Mask first, second;
};

template <class Real>
auto blend_sides(const Interval<Real>& difference) {
    const Real beyond = like(difference.hi, -1.0);
    const auto second = difference.neg_lo <= beyond;
    return BlendSides<std::remove_cvref_t<decltype(second)>>{difference.hi <= beyond, second};
}

/// -g(d), which is >= 0, rounded upward.
template <class Real>
Real blend_fall(const Real& d) {
    const Real zero = like(d, 0.0);
    const Real height = maximum(like(d, 1.0) - magnitude(d), zero);
    return maximum(-d, zero) + like(d, 0.25) * height * height;
}

/// Share of a in the blend: (1 - d)/2 cut to [0, 1], with d = a - b.
template <class Real>
Real blend_share(const Real& d) {
    const Real half = like(d, 0.5);
    return maximum(minimum(half - half * d, like(d, 1.0)), like(d, 0.0));
}

/// Linear enclosure of the blend: g(d) = alpha d + rest.
template <class Real>
struct BlendLine {
    Real alpha;           ///< in [0, 1]
    Interval<Real> rest;  ///< over the range of d
};

/// Line for g over `range`. For any alpha in [0, 1], g(d) - alpha d is at most -alpha (1 - alpha)
/// and least at an end of the range. Where the range lies within [-1, 1] and alpha is g'(c) for the
/// middle c, it is at most (d - c)^2 / 4 below that maximum.
template <class Real>
BlendLine<Real> blend_line(const Beam<Real>& difference, const Interval<Real>& range) {
    const Real one = like(range.hi, 1.0);
    const Real zero = like(range.hi, 0.0);
    const Real quarter = like(range.hi, 0.25);
    const Real lo = -range.neg_lo;
    const Real fall_lo = blend_fall(lo);
    const Real fall_hi = blend_fall(range.hi);
    const auto inside = both(range.neg_lo <= one, range.hi <= one);
    const Real secant = (fall_lo - fall_hi) / (range.hi + range.neg_lo);
    const Real alpha = select(inside, blend_share(difference.f.c),
                              maximum(minimum(secant, one), zero));  // 1 where NaN
    const Real& d = difference.spread();
    const Real most_below =
        select(inside, fused(alpha, one - alpha, quarter * d * d),
               larger_bound(fused(alpha, lo, fall_lo), fused(alpha, range.hi, fall_hi)));
    return {alpha, {most_below, alpha * (alpha - one)}};
}

/// Form of the smooth minimum of a and b; `difference` is a - b.
template <class Real, class Mask>
Beam<Real> smooth_min(const Beam<Real>& a, const Beam<Real>& b, const Beam<Real>& difference,
                      const BlendSides<Mask>& sides) {
    const auto [alpha, rest] = blend_line(difference, difference.range());
    const Affine<Real> shift = centred(rest);
    Affine<Real> line = scaled(a.f, alpha) + scaled(b.f, like(alpha, 1.0) - alpha);
    line.c = line.c + shift.c;
    line.e = line.e + shift.e;
    // In a chain of blends, the errors of lines add up; the ends of the ranges do not.
    const Interval<Real> range = smooth_min(a.range(), b.range());
    const Real deviation = zeroset::deviation(line);
    const auto better = deviation + deviation <= range.neg_lo + range.hi;  // false where NaN
    const Affine<Real> form = form_or_interval(better, line, range);
    const Real size = larger_bound(a.size, b.size) + like(alpha, 1.0);
    const Beam<Real> blend{form, fused(like(alpha, 4.0), size, larger_bound(a.r, b.r)), size};
    return select(sides.first, a, select(sides.second, b, blend));
}

/// Form of the share of a in the blend, g'(a - b).
template <class Real>
Beam<Real> blend_share(const Beam<Real>& difference) {
    const Interval<Real> d = difference.range();
    const Real half = like(d.hi, 0.5);
    const Real zero = like(d.hi, 0.0);
    const Real one = like(d.hi, 1.0);
    // Encloses the share for d in [lo, hi]: from (1 - hi)/2 to (1 - lo)/2.
    const auto enclosed = [&](const Real& lo, const Real& hi) {
        return Interval<Real>{maximum(minimum(half * hi - half, zero), -one), blend_share(lo)};
    };
    const Interval<Real> slope = enclosed(-d.neg_lo, d.hi);
    const auto inside = both(d.neg_lo <= one, d.hi <= one);
    const Interval<Real> bend{half, select(inside, -half, zero)};
    const FunctionBounds<Real> g{
        .range = slope,
        .slope = slope,
        .curvature = bend,
        .at_middle = slope,
        .slope_at_middle = enclosed(difference.f.c, difference.f.c),
        .rounding_ulp = 4.0,
    };
    return slope_of_curve(difference, g);
}

}  // namespace zeroset
