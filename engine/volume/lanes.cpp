// Questions to a volume in vectors of doubles. Each function goes through the lanes of its arrays,
// a vector at a time; what is added, and in which order, is as in index_box.hpp and trilinear.hpp.

#include "engine/volume/lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/volume/lanes.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/real/lane_carrier-inl.hpp"
#include "engine/volume/index_box.hpp"
#include "engine/volume/trilinear.hpp"

#include <hwy/highway.h>

#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

HWY_INLINE V<double> size_of(V<double> lo, V<double> hi) {
    return maximum(hn::Abs(lo), hn::Abs(hi));
}

void place_boxes(const IndexMap& map, const GridSize& size, BoxLanes& boxes) {
    boxes.inside = 0;
    for (std::size_t at = 0; at < boxes.count; at += lanes<double>) {
        M<double> inside = hn::Eq(hn::Zero(d<double>), hn::Zero(d<double>));
        for (std::size_t i = 0; i < 3; ++i) {
            V<double> from = number(map.shift[i]);
            V<double> to = from;
            V<double> terms = hn::Abs(from);
            for (std::size_t c = 0; c < 3; ++c) {
                const double m = map.index_from_world[i][c];
                if (m == 0) continue;
                const V<double> lo = hn::Load(d<double>, boxes.lo[c] + at);
                const V<double> hi = hn::Load(d<double>, boxes.hi[c] + at);
                from = hn::Add(from, hn::Mul(number(m), m > 0 ? lo : hi));
                to = hn::Add(to, hn::Mul(number(m), m > 0 ? hi : lo));
                terms = hn::Add(terms, hn::Mul(hn::Abs(number(m)), size_of(lo, hi)));
            }
            const V<double> error = hn::Mul(number(index_roundings * unit_of<double>), terms);
            from = hn::Sub(from, error);
            to = hn::Add(to, error);
            const double end = static_cast<double>(size[i]) - 1;
            inside = hn::And(inside,
                             hn::And(hn::Ge(from, hn::Zero(d<double>)), hn::Le(to, number(end))));
            from = minimum(maximum(from, hn::Zero(d<double>)), number(end));
            to = minimum(maximum(to, hn::Zero(d<double>)), number(end));
            const V<double> last_cell = number(end - 1);
            const V<double> first = minimum(hn::Floor(from), last_cell);
            const V<double> last =
                minimum(maximum(hn::Sub(hn::Ceil(to), number(1)), first), last_cell);
            hn::Store(from, d<double>, boxes.from[i] + at);
            hn::Store(to, d<double>, boxes.to[i] + at);
            hn::Store(terms, d<double>, boxes.terms[i] + at);
            hn::Store(first, d<double>, boxes.first[i] + at);
            hn::Store(last, d<double>, boxes.last[i] + at);
        }
        boxes.inside |= bits_of(d<double>, inside) << at;
    }
}

/// The numbers at a part's corners where it is cut down along the axis to its shares.
template <std::size_t step>
HWY_INLINE void narrow(V<double> (&values)[8], V<double> from, V<double> to) {
    for (std::size_t i = 0; i < 8; ++i) {
        if ((i & step) != 0) continue;
        const V<double> a = values[i];
        const V<double> b = values[i | step];
        values[i] = hn::MulAdd(a, hn::Sub(number(1), from), hn::Mul(b, from));
        values[i | step] = hn::MulAdd(a, hn::Sub(number(1), to), hn::Mul(b, to));
    }
}

struct Hull {
    V<double> lo, hi;

    HWY_INLINE void add(V<double> value) {
        lo = minimum(value, lo);
        hi = maximum(value, hi);
    }
};

template <std::size_t step>
HWY_INLINE void store_slopes(const V<double> (&values)[8], V<double> error, double* lo,
                             double* hi) {
    const V<double> first = hn::Sub(values[step], values[0]);
    Hull hull{.lo = first, .hi = first};
    for (std::size_t i = 1; i < 8; ++i) {
        if ((i & step) == 0) hull.add(hn::Sub(values[i | step], values[i]));
    }
    hn::Store(hn::Sub(hull.lo, error), d<double>, lo);
    hn::Store(hn::Add(hull.hi, error), d<double>, hi);
}

HWY_INLINE void copy(const V<double> (&from)[8], V<double> (&to)[8]) {
    for (std::size_t i = 0; i < 8; ++i)
        to[i] = from[i];
}

HWY_INLINE void enclose_part(CellParts& parts, std::size_t at) {
    V<double> corners[8];
    for (std::size_t i = 0; i < 8; ++i)
        corners[i] = hn::Load(d<double>, parts.corners[i] + at);
    V<double> from[3];
    V<double> to[3];
    for (std::size_t i = 0; i < 3; ++i) {
        from[i] = hn::Load(d<double>, parts.from[i] + at);
        to[i] = hn::Load(d<double>, parts.to[i] + at);
    }
    Hull samples{.lo = corners[0], .hi = corners[0]};
    V<double> sizes = hn::Abs(corners[0]);
    for (std::size_t i = 1; i < 8; ++i) {
        samples.add(corners[i]);
        sizes = hn::Add(sizes, hn::Abs(corners[i]));
    }
    // The sum tells of holes: comparisons with what is no number pass it over.
    const M<double> whole = hn::Le(sizes, number(std::numeric_limits<double>::max()));
    const V<double> largest = size_of(samples.lo, samples.hi);
    hn::Store(hn::IfThenElse(whole, largest, sizes), d<double>, parts.largest + at);
    const V<double> error = hn::Mul(number(mixing_roundings * unit_of<double>), largest);
    V<double> values[8];
    copy(corners, values);
    narrow<4>(values, from[2], to[2]);
    V<double> in_z[8];
    copy(values, in_z);
    narrow<2>(values, from[1], to[1]);
    store_slopes<1>(values, error, parts.slope_lo[0] + at, parts.slope_hi[0] + at);
    narrow<1>(values, from[0], to[0]);
    Hull mixed{.lo = values[0], .hi = values[0]};
    for (std::size_t i = 1; i < 8; ++i)
        mixed.add(values[i]);
    hn::Store(hn::Sub(maximum(mixed.lo, samples.lo), error), d<double>, parts.lo + at);
    hn::Store(hn::Add(minimum(mixed.hi, samples.hi), error), d<double>, parts.hi + at);
    narrow<1>(in_z, from[0], to[0]);
    store_slopes<2>(in_z, error, parts.slope_lo[1] + at, parts.slope_hi[1] + at);
    narrow<1>(corners, from[0], to[0]);
    narrow<2>(corners, from[1], to[1]);
    store_slopes<4>(corners, error, parts.slope_lo[2] + at, parts.slope_hi[2] + at);
}

void enclose_parts(CellParts& parts) {
    for (std::size_t at = 0; at < parts.count; at += lanes<double>)
        enclose_part(parts, at);
}

/// A sum of two doubles, the second one below the last place of the first. The rounding mode costs
/// no more than some last places of the second.
struct Two {
    V<double> hi, lo;
};
HWY_INLINE Two sum_of(V<double> a, V<double> b) {
    const V<double> s = hn::Add(a, b);
    const V<double> part = hn::Sub(s, a);
    return {.hi = s, .lo = hn::Add(hn::Sub(a, hn::Sub(s, part)), hn::Sub(b, part))};
}
HWY_INLINE Two renewed(V<double> hi, V<double> lo) {
    const V<double> s = hn::Add(hi, lo);
    return {.hi = s, .lo = hn::Add(hn::Sub(hi, s), lo)};
}
HWY_INLINE Two operator+(Two a, Two b) {
    const Two s = sum_of(a.hi, b.hi);
    return renewed(s.hi, hn::Add(s.lo, hn::Add(a.lo, b.lo)));
}
HWY_INLINE Two operator-(Two a, Two b) { return a + Two{.hi = hn::Neg(b.hi), .lo = hn::Neg(b.lo)}; }
HWY_INLINE Two product_of(V<double> a, V<double> b) {
    const V<double> p = hn::Mul(a, b);
    return {.hi = p, .lo = hn::MulSub(a, b, p)};
}
HWY_INLINE Two operator*(Two a, Two b) {
    const Two p = product_of(a.hi, b.hi);
    return renewed(p.hi, hn::MulAdd(a.hi, b.lo, hn::MulAdd(a.lo, b.hi, p.lo)));
}
/// Two in place of a number, and a number in place of Two.
HWY_INLINE Two widened(Two /*kind*/, V<double> x) { return {.hi = x, .lo = hn::Zero(d<double>)}; }
HWY_INLINE V<double> widened(V<double> /*kind*/, V<double> x) { return x; }
HWY_INLINE V<double> narrowed(Two x) { return x.hi; }
HWY_INLINE V<double> narrowed(V<double> x) { return x; }
HWY_INLINE V<double> rest_of(Two x) { return x.lo; }
HWY_INLINE V<double> rest_of(V<double> /*x*/) { return hn::Zero(d<double>); }
HWY_INLINE Two with_rest(Two /*kind*/, V<double> hi, V<double> lo) { return {.hi = hi, .lo = lo}; }
HWY_INLINE V<double> with_rest(V<double> /*kind*/, V<double> hi, V<double> /*lo*/) { return hi; }
HWY_INLINE Two plus(Two a, Two b) { return a + b; }
HWY_INLINE V<double> plus(V<double> a, V<double> b) { return hn::Add(a, b); }
HWY_INLINE Two minus(Two a, Two b) { return a - b; }
HWY_INLINE V<double> minus(V<double> a, V<double> b) { return hn::Sub(a, b); }
HWY_INLINE Two times(Two a, Two b) { return a * b; }
HWY_INLINE V<double> times(V<double> a, V<double> b) { return hn::Mul(a, b); }
HWY_INLINE Two exact_product(Two /*kind*/, V<double> a, V<double> b) { return product_of(a, b); }
HWY_INLINE V<double> exact_product(V<double> /*kind*/, V<double> a, V<double> b) {
    return hn::Mul(a, b);
}

template <class Wide>
void place_points_in(const IndexMap& map, const GridSize& size, PointLanes& points) {
    const Wide kind = widened(Wide{}, hn::Zero(d<double>));
    points.inside = 0;
    for (std::size_t at = 0; at < points.count; at += lanes<double>) {
        M<double> inside = hn::Eq(hn::Zero(d<double>), hn::Zero(d<double>));
        for (std::size_t i = 0; i < 3; ++i) {
            Wide index = widened(kind, number(map.shift[i]));
            for (std::size_t c = 0; c < 3; ++c) {
                const double m = map.index_from_world[i][c];
                if (m == 0) continue;
                index = plus(
                    index, exact_product(kind, number(m), hn::Load(d<double>, points.at[c] + at)));
            }
            const double end = static_cast<double>(size[i]) - 1;
            const V<double> place = narrowed(index);
            inside = hn::And(
                inside, hn::And(hn::Gt(place, hn::Zero(d<double>)), hn::Lt(place, number(end))));
            V<double> cell =
                minimum(hn::Floor(maximum(place, hn::Zero(d<double>))), number(end - 1));
            // A little below a whole number
            const M<double> below =
                hn::And(hn::Eq(cell, place), hn::Lt(rest_of(index), hn::Zero(d<double>)));
            cell = hn::IfThenElse(below, hn::Sub(cell, number(1)), cell);
            const Wide share = minus(index, widened(kind, cell));
            hn::Store(cell, d<double>, points.cell[i] + at);
            hn::Store(narrowed(share), d<double>, points.share[i] + at);
            hn::Store(rest_of(share), d<double>, points.share_rest[i] + at);
        }
        points.inside |= bits_of(d<double>, inside) << at;
    }
}

void place_points(const IndexMap& map, const GridSize& size, Digits digits, PointLanes& points) {
    if (digits == Digits::Double) return place_points_in<V<double>>(map, size, points);
#if HWY_NATIVE_FMA
    place_points_in<Two>(map, size, points);
#else
    points.inside = 0;
#endif
}

template <class Wide>
HWY_INLINE Wide mix(Wide a, Wide b, Wide share) {
    return plus(a, times(minus(b, a), share));
}

HWY_INLINE V<double> mix_plain(V<double> a, V<double> b, V<double> share) {
    return hn::MulAdd(hn::Sub(b, a), share, a);
}

/// Slopes in the world, in double: their last places do not matter.
HWY_INLINE void store_world_slopes(const IndexMap& map, const V<double> (&corners)[8],
                                   const V<double> (&share)[3], std::size_t at,
                                   PointLanes& points) {
    const auto by = [&](std::size_t edge) { return hn::Sub(corners[edge + 1], corners[edge]); };
    const auto on = [&](std::size_t edge) {
        return mix_plain(corners[edge], corners[edge + 1], share[0]);
    };
    const V<double> on_0 = on(0);
    const V<double> on_1 = on(2);
    const V<double> on_2 = on(4);
    const V<double> on_3 = on(6);
    const V<double> slope[3] = {
        mix_plain(mix_plain(by(0), by(2), share[1]), mix_plain(by(4), by(6), share[1]), share[2]),
        mix_plain(hn::Sub(on_1, on_0), hn::Sub(on_3, on_2), share[2]),
        hn::Sub(mix_plain(on_2, on_3, share[1]), mix_plain(on_0, on_1, share[1]))};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        V<double> sum = hn::Zero(d<double>);
        for (std::size_t i = 0; i < 3; ++i) {
            const double m = map.index_from_world[i][axis];
            if (m != 0) sum = hn::MulAdd(number(m), slope[i], sum);
        }
        hn::Store(sum, d<double>, points.slope[axis] + at);
    }
}

template <class Wide>
void mix_points_in(const IndexMap& map, bool with_slopes, PointLanes& points) {
    const Wide kind = widened(Wide{}, hn::Zero(d<double>));
    for (std::size_t at = 0; at < points.count; at += lanes<double>) {
        V<double> corners[8];
        for (std::size_t i = 0; i < 8; ++i)
            corners[i] = hn::Load(d<double>, points.corners[i] + at);
        V<double> share[3];
        Wide wide_share[3];
        for (std::size_t i = 0; i < 3; ++i) {
            share[i] = hn::Load(d<double>, points.share[i] + at);
            wide_share[i] =
                with_rest(kind, share[i], hn::Load(d<double>, points.share_rest[i] + at));
        }
        const auto on = [&](std::size_t edge) {
            return mix(widened(kind, corners[edge]), widened(kind, corners[edge + 1]),
                       wide_share[0]);
        };
        const Wide below = mix(on(0), on(2), wide_share[1]);
        const Wide above = mix(on(4), on(6), wide_share[1]);
        hn::Store(narrowed(mix(below, above, wide_share[2])), d<double>, points.value + at);
        if (with_slopes) store_world_slopes(map, corners, share, at, points);
    }
}

void mix_points(const IndexMap& map, Digits digits, bool with_slopes, PointLanes& points) {
    if (digits == Digits::Double) return mix_points_in<V<double>>(map, with_slopes, points);
    mix_points_in<Two>(map, with_slopes, points);
}

/// Stores bounds from above.
HWY_INLINE void store_above(V<double> bound, double* out) { hn::Store(bound, d<double>, out); }
HWY_INLINE void store_above(V<double> bound, float* out) {
    const hn::Rebind<float, Tag<double>> floats;
    const auto rounded = hn::DemoteTo(floats, bound);
    // Two units of the last place more in any rounding mode, where it was rounded down
    const auto more =
        hn::MulAdd(hn::Abs(rounded), hn::Set(floats, 0x1p-22F), hn::Set(floats, 0x1p-148F));
    const M<double> below = hn::Lt(hn::PromoteTo(d<double>, rounded), bound);
    const V<double> raised = hn::PromoteTo(d<double>, hn::Add(rounded, more));
    hn::StoreU(
        hn::DemoteTo(floats, hn::IfThenElse(below, raised, hn::PromoteTo(d<double>, rounded))),
        floats, out);
}

/// Bounds of the slope along an axis of the world.
HWY_INLINE Hull world_slope(const IndexMap& map, const V<double> (&lo)[3], const V<double> (&hi)[3],
                            std::size_t axis) {
    Hull sum{.lo = hn::Zero(d<double>), .hi = hn::Zero(d<double>)};
    for (std::size_t i = 0; i < 3; ++i) {
        const double m = map.index_from_world[i][axis];
        if (m == 0) continue;
        const V<double> a = hn::Mul(number(m), m > 0 ? lo[i] : hi[i]);
        const V<double> b = hn::Mul(number(m), m > 0 ? hi[i] : lo[i]);
        const Hull added{.lo = hn::Add(sum.lo, a), .hi = hn::Add(sum.hi, b)};
        const V<double> error = hn::Mul(number(4 * unit_of<double>),
                                        hn::Add(size_of(added.lo, added.hi), size_of(a, b)));
        sum = {.lo = hn::Sub(added.lo, error), .hi = hn::Add(added.hi, error)};
    }
    return sum;
}

template <class Real>
void make_forms_in(const IndexMap& map, const BoxLanes& boxes, const PointLanes& middles,
                   double unit, const FormLanes& forms, FormColumns<Real>& columns) {
    for (std::size_t at = 0; at < boxes.count; at += lanes<double>) {
        const auto put = [&](std::size_t column, V<double> bound) {
            store_above(bound, columns.column[column] + at);
        };
        const V<double> lo = hn::Load(d<double>, forms.lo + at);
        const V<double> hi = hn::Load(d<double>, forms.hi + at);
        const V<double> largest = hn::Load(d<double>, forms.largest + at);
        V<double> slope_lo[3];
        V<double> slope_hi[3];
        V<double> rounding = largest;
        V<double> index_error = hn::Zero(d<double>);
        for (std::size_t i = 0; i < 3; ++i) {
            slope_lo[i] = hn::Load(d<double>, forms.slope_lo[i] + at);
            slope_hi[i] = hn::Load(d<double>, forms.slope_hi[i] + at);
            const V<double> moved = hn::Mul(hn::Load(d<double>, boxes.terms[i] + at),
                                            size_of(slope_lo[i], slope_hi[i]));
            rounding = hn::Add(rounding, moved);
            index_error = hn::Add(index_error, moved);
        }
        put(FieldForm::range, hn::Neg(lo));
        put(FieldForm::range + 1, hi);
        const V<double> value = hn::Load(d<double>, middles.value + at);
        const V<double> error = hn::Add(hn::Mul(number(mixing_roundings), largest),
                                        hn::Mul(number(index_roundings), index_error));
        const V<double> wide = hn::Add(hn::Mul(number(2 * unit), error),
                                       hn::Mul(number(2 * unit_of<double>), hn::Abs(value)));
        put(FieldForm::at_middle, hn::Sub(wide, value));
        put(FieldForm::at_middle + 1, hn::Add(value, wide));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Hull slope = world_slope(map, slope_lo, slope_hi, axis);
            put(FieldForm::slopes + 2 * axis, hn::Neg(slope.lo));
            put(FieldForm::slopes + 2 * axis + 1, slope.hi);
        }
        put(FieldForm::rounding,
            hn::Add(hn::Mul(number(2), size_of(lo, hi)), hn::Mul(number(wide_share), rounding)));
        for (const std::size_t mask :
             {FieldForm::somewhere, FieldForm::everywhere, FieldForm::continuous})
            put(mask, number(1));
    }
}

void make_forms_float(const IndexMap& map, const BoxLanes& boxes, const PointLanes& middles,
                      double unit, const FormLanes& forms, FormColumns<float>& columns) {
    make_forms_in(map, boxes, middles, unit, forms, columns);
}
void make_forms_double(const IndexMap& map, const BoxLanes& boxes, const PointLanes& middles,
                       double unit, const FormLanes& forms, FormColumns<double>& columns) {
    make_forms_in(map, boxes, middles, unit, forms, columns);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(place_boxes);
HWY_EXPORT(enclose_parts);
HWY_EXPORT(place_points);
HWY_EXPORT(mix_points);
HWY_EXPORT(make_forms_float);
HWY_EXPORT(make_forms_double);

}  // namespace

void place_boxes(const IndexMap& map, const GridSize& size, BoxLanes& boxes) {
    HWY_DYNAMIC_DISPATCH(place_boxes)(map, size, boxes);
}
void enclose_parts(CellParts& parts) { HWY_DYNAMIC_DISPATCH(enclose_parts)(parts); }
void place_points(const IndexMap& map, const GridSize& size, Digits digits, PointLanes& points) {
    HWY_DYNAMIC_DISPATCH(place_points)(map, size, digits, points);
}
void mix_points(const IndexMap& map, Digits digits, bool with_slopes, PointLanes& points) {
    HWY_DYNAMIC_DISPATCH(mix_points)(map, digits, with_slopes, points);
}
void make_forms(const IndexMap& map, const BoxLanes& boxes, const PointLanes& middles, double unit,
                const FormLanes& forms, FormColumns<float>& columns) {
    HWY_DYNAMIC_DISPATCH(make_forms_float)(map, boxes, middles, unit, forms, columns);
}
void make_forms(const IndexMap& map, const BoxLanes& boxes, const PointLanes& middles, double unit,
                const FormLanes& forms, FormColumns<double>& columns) {
    HWY_DYNAMIC_DISPATCH(make_forms_double)(map, boxes, middles, unit, forms, columns);
}

}  // namespace zeroset

#endif
