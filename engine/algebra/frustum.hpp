#pragma once

#include "engine/algebra/beam_algebra.hpp"
#include "engine/kernel/kernel.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

// Cells of a frustum as beam forms of x, y and z, over any carrier; and what a kernel hands on of
// the form of f. The interpreter and the JIT share it.

namespace zeroset {

/// The numbers of a FrustumOf<Real> in a carrier, read one by one with `read(index)`.
template <class Lanes>
struct FrustumLanes {
    std::array<Lanes, 3> base, right, up, forward;
    Lanes distance;
    std::array<Lanes, 3> by_u, by_v;  ///< right and up times the cells' radii
    std::array<Lanes, 3> across;      ///< |by_u| + |by_v|
    std::array<Lanes, 3> size, direction_size;
};

template <class Lanes>
FrustumLanes<Lanes> frustum_lanes(auto read) {
    using Layout = FrustumOf<char>;
    const auto three = [&](std::size_t offset) {
        return std::array<Lanes, 3>{read(offset), read(offset + 1), read(offset + 2)};
    };
    const auto times = [](const std::array<Lanes, 3>& a, const Lanes& b) {
        return std::array<Lanes, 3>{a[0] * b, a[1] * b, a[2] * b};
    };
    const auto right = three(offsetof(Layout, right));
    const auto up = three(offsetof(Layout, up));
    const auto by_u = times(right, read(offsetof(Layout, u_radius)));
    const auto by_v = times(up, read(offsetof(Layout, v_radius)));
    const auto across = [&](std::size_t i) { return magnitude(by_u[i]) + magnitude(by_v[i]); };
    return {three(offsetof(Layout, base)),
            right,
            up,
            three(offsetof(Layout, forward)),
            read(offsetof(Layout, distance)),
            by_u,
            by_v,
            {across(0), across(1), across(2)},
            three(offsetof(Layout, size)),
            three(offsetof(Layout, direction_size))};
}

/// The middles and half lengths of cells.
template <class Lanes>
struct CellLanes {
    Lanes u, v, s, s_radius;
};

/// The coordinates of a RaysOf are off by less than so many units of their terms' sizes: one for
/// its numbers, three for sums, in code that rounds products together with the sums.
template <class Lanes>
double ray_roundings(const Lanes& /*kind*/) {
    return 4.0;
}

/// Coordinate i over cells, and its slope along the rays. The roundings of u, v and of the few
/// operations here are below four units of `size` together: of the terms' sizes at these depths.
template <class Lanes>
BeamValue<Lanes> coordinate(const FrustumLanes<Lanes>& view, const CellLanes<Lanes>& cell,
                            std::size_t i) {
    const Lanes units = like(cell.u, ray_roundings(cell.u));
    const Lanes across = cell.u * view.right[i] + cell.v * view.up[i];
    const Lanes direction = view.forward[i] + across;
    const Lanes from_eye = view.distance + cell.s;
    const Lanes middle = view.base[i] + view.distance * across + cell.s * direction;
    const Affine<Lanes> x{
        middle,
        {from_eye * view.by_u[i], from_eye * view.by_v[i], direction * cell.s_radius},
        view.across[i] * cell.s_radius};
    const Lanes size = view.size[i] + (magnitude(cell.s) + cell.s_radius) * view.direction_size[i];
    const Affine<Lanes> slope{
        direction, {view.by_u[i], view.by_v[i], std::nullopt}, like(cell.u, 0.0)};
    return {Beam<Lanes>{x, size * units, size},
            slope_beam(Beam<Lanes>{slope, view.direction_size[i] * units, view.direction_size[i]})};
}

/// A coordinate over cells without width: a form in the depth alone, in fewer operations.
template <class Lanes>
BeamValue<Lanes> coordinate_on_rays(const FrustumLanes<Lanes>& view, const CellLanes<Lanes>& cell,
                                    std::size_t i) {
    BeamValue<Lanes> x = coordinate(view, cell, i);
    const Lanes zero = like(cell.u, 0.0);
    x.f.f.k = {std::nullopt, std::nullopt, x.f.f.k[2]};
    x.f.f.e = zero;
    x.slope->f = {x.slope->f.c, {}, x.slope->f.e};
    return x;
}

/// A constant subexpression: what value kernels take for it, and how far from that it may be.
/// `Real` is the carrier's number, `splat` makes one of the other.
template <class Lanes, class Real>
BeamValue<Lanes> constant_form(const Facts& facts, Real /*kind*/, auto splat) {
    const Real middle = facts.constant_point<Real>();
    const Interval<double>& box = *facts.constant;
    const double error =
        std::max(box.hi - static_cast<double>(middle), box.neg_lo + static_cast<double>(middle));
    const Real e = error > 0 ? upper_end(Real{}, error * (1.0 + 0x1p-50)) : Real{0};
    const double bound = std::max(box.neg_lo, box.hi);
    // Kernels in double take `facts.middle`: the bounds may be many of its units away.
    const double off = std::max(box.hi - facts.middle, box.neg_lo + facts.middle) * (1.0 + 0x1p-50);
    const Real r = upper_end(Real{}, std::max(bound, off * 0x1p52));
    const Real size = upper_end(Real{}, bound);
    return {Beam<Lanes>{{splat(middle), {}, splat(e)}, splat(r), splat(size)}};
}

/// w or a parameter.
template <class Lanes>
BeamValue<Lanes> uniform_form(const Interval<Lanes>& box) {
    return {interval_form(box, maximum(box.neg_lo, box.hi))};
}

/// The results of a FormBatchOf, in vectors.
template <class Lanes>
struct FormResult {
    using Mask = typename Enclosure<Lanes>::Mask;

    Lanes c;
    std::array<Lanes, 3> k;
    Lanes e, r;
    Interval<Lanes> slope;
    std::optional<Mask> continuous, somewhere;
};

template <class Lanes>
FormResult<Lanes> form_result(const BeamValue<Lanes>& f) {
    const Beam<Lanes>& form = f.zeros ? *f.zeros : f.f;
    const Lanes& c = form.f.c;
    const Lanes zero = like(c, 0.0);
    const Lanes far = like(c, format_of(c).largest_finite);
    // Finite in each member; false where one is NaN.
    const auto known = form.spread() + magnitude(c) <= far;
    FormResult<Lanes> result{select(known, c, zero),
                             {zero, zero, zero},
                             select(known, form.f.e + form.r * form_rounding(c), like(c, infinity)),
                             form.r,
                             {zero, zero},
                             conjunction(f.everywhere, f.continuous),
                             f.somewhere};
    for (std::size_t i = 0; i < 3; ++i) {
        if (form.f.k[i]) result.k[i] = select(known, *form.f.k[i], zero);
    }
    if (f.slope) result.slope = f.slope->range();
    return result;
}

}  // namespace zeroset
