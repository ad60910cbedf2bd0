// Questions to a volume in vectors of doubles. Each function goes through the lanes of its arrays,
// a vector at a time; what is added, and in which order, is as in index_box.hpp and trilinear.hpp.

#include "engine/volume/lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/volume/lanes.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/real/double_vectors-inl.hpp"
#include "engine/volume/index_box.hpp"
#include "engine/volume/trilinear.hpp"

#include <hwy/highway.h>

#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

HWY_INLINE V size_of(V lo, V hi) { return maximum(hn::Abs(lo), hn::Abs(hi)); }
/// A bit for each lane.
HWY_INLINE std::uint32_t bits_of(M mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0];
}

void place_boxes(const IndexMap& map, const GridSize& size, BoxLanes& boxes) {
    boxes.inside = 0;
    for (std::size_t at = 0; at < boxes.count; at += width) {
        M inside = hn::Eq(hn::Zero(d), hn::Zero(d));
        for (std::size_t i = 0; i < 3; ++i) {
            V from = number(map.shift[i]);
            V to = from;
            V terms = hn::Abs(from);
            for (std::size_t c = 0; c < 3; ++c) {
                const double m = map.index_from_world[i][c];
                if (m == 0) continue;
                const V lo = hn::Load(d, boxes.lo[c] + at);
                const V hi = hn::Load(d, boxes.hi[c] + at);
                from = hn::Add(from, hn::Mul(number(m), m > 0 ? lo : hi));
                to = hn::Add(to, hn::Mul(number(m), m > 0 ? hi : lo));
                terms = hn::Add(terms, hn::Mul(hn::Abs(number(m)), size_of(lo, hi)));
            }
            const V error = hn::Mul(number(index_roundings * unit_of<double>), terms);
            from = hn::Sub(from, error);
            to = hn::Add(to, error);
            const double end = static_cast<double>(size[i]) - 1;
            inside = hn::And(inside, hn::And(hn::Ge(from, hn::Zero(d)), hn::Le(to, number(end))));
            from = minimum(maximum(from, hn::Zero(d)), number(end));
            to = minimum(maximum(to, hn::Zero(d)), number(end));
            const V last_cell = number(end - 1);
            const V first = minimum(hn::Floor(from), last_cell);
            const V last = minimum(maximum(hn::Sub(hn::Ceil(to), number(1)), first), last_cell);
            hn::Store(from, d, boxes.from[i] + at);
            hn::Store(to, d, boxes.to[i] + at);
            hn::Store(terms, d, boxes.terms[i] + at);
            hn::Store(first, d, boxes.first[i] + at);
            hn::Store(last, d, boxes.last[i] + at);
        }
        boxes.inside |= bits_of(inside) << at;
    }
}

/// The numbers at a part's corners where it is cut down along the axis to its shares.
template <std::size_t step>
HWY_INLINE void narrow(V (&values)[8], V from, V to) {
    for (std::size_t i = 0; i < 8; ++i) {
        if ((i & step) != 0) continue;
        const V a = values[i];
        const V b = values[i | step];
        values[i] = hn::MulAdd(a, hn::Sub(number(1), from), hn::Mul(b, from));
        values[i | step] = hn::MulAdd(a, hn::Sub(number(1), to), hn::Mul(b, to));
    }
}

struct Hull {
    V lo, hi;

    HWY_INLINE void add(V value) {
        lo = minimum(value, lo);
        hi = maximum(value, hi);
    }
};

template <std::size_t step>
HWY_INLINE void store_slopes(const V (&values)[8], V error, double* lo, double* hi) {
    const V first = hn::Sub(values[step], values[0]);
    Hull hull{.lo = first, .hi = first};
    for (std::size_t i = 1; i < 8; ++i) {
        if ((i & step) == 0) hull.add(hn::Sub(values[i | step], values[i]));
    }
    hn::Store(hn::Sub(hull.lo, error), d, lo);
    hn::Store(hn::Add(hull.hi, error), d, hi);
}

HWY_INLINE void copy(const V (&from)[8], V (&to)[8]) {
    for (std::size_t i = 0; i < 8; ++i)
        to[i] = from[i];
}

HWY_INLINE void enclose_part(CellParts& parts, std::size_t at) {
    V corners[8];
    for (std::size_t i = 0; i < 8; ++i)
        corners[i] = hn::Load(d, parts.corners[i] + at);
    V from[3];
    V to[3];
    for (std::size_t i = 0; i < 3; ++i) {
        from[i] = hn::Load(d, parts.from[i] + at);
        to[i] = hn::Load(d, parts.to[i] + at);
    }
    Hull samples{.lo = corners[0], .hi = corners[0]};
    V sizes = hn::Abs(corners[0]);
    for (std::size_t i = 1; i < 8; ++i) {
        samples.add(corners[i]);
        sizes = hn::Add(sizes, hn::Abs(corners[i]));
    }
    // The sum tells of holes: comparisons with what is no number pass it over.
    const M whole = hn::Le(sizes, number(std::numeric_limits<double>::max()));
    const V largest = size_of(samples.lo, samples.hi);
    hn::Store(hn::IfThenElse(whole, largest, sizes), d, parts.largest + at);
    const V error = hn::Mul(number(mixing_roundings * unit_of<double>), largest);
    V values[8];
    copy(corners, values);
    narrow<4>(values, from[2], to[2]);
    V in_z[8];
    copy(values, in_z);
    narrow<2>(values, from[1], to[1]);
    store_slopes<1>(values, error, parts.slope_lo[0] + at, parts.slope_hi[0] + at);
    narrow<1>(values, from[0], to[0]);
    Hull mixed{.lo = values[0], .hi = values[0]};
    for (std::size_t i = 1; i < 8; ++i)
        mixed.add(values[i]);
    hn::Store(hn::Sub(maximum(mixed.lo, samples.lo), error), d, parts.lo + at);
    hn::Store(hn::Add(minimum(mixed.hi, samples.hi), error), d, parts.hi + at);
    narrow<1>(in_z, from[0], to[0]);
    store_slopes<2>(in_z, error, parts.slope_lo[1] + at, parts.slope_hi[1] + at);
    narrow<1>(corners, from[0], to[0]);
    narrow<2>(corners, from[1], to[1]);
    store_slopes<4>(corners, error, parts.slope_lo[2] + at, parts.slope_hi[2] + at);
}

void enclose_parts(CellParts& parts) {
    for (std::size_t at = 0; at < parts.count; at += width)
        enclose_part(parts, at);
}

/// A sum of two doubles, the second one below the last place of the first. The rounding mode costs
/// no more than some last places of the second.
struct Two {
    V hi, lo;
};
HWY_INLINE Two sum_of(V a, V b) {
    const V s = hn::Add(a, b);
    const V part = hn::Sub(s, a);
    return {.hi = s, .lo = hn::Add(hn::Sub(a, hn::Sub(s, part)), hn::Sub(b, part))};
}
HWY_INLINE Two renewed(V hi, V lo) {
    const V s = hn::Add(hi, lo);
    return {.hi = s, .lo = hn::Add(hn::Sub(hi, s), lo)};
}
HWY_INLINE Two operator+(Two a, Two b) {
    const Two s = sum_of(a.hi, b.hi);
    return renewed(s.hi, hn::Add(s.lo, hn::Add(a.lo, b.lo)));
}
HWY_INLINE Two operator-(Two a, Two b) { return a + Two{.hi = hn::Neg(b.hi), .lo = hn::Neg(b.lo)}; }
HWY_INLINE Two product_of(V a, V b) {
    const V p = hn::Mul(a, b);
    return {.hi = p, .lo = hn::MulSub(a, b, p)};
}
HWY_INLINE Two operator*(Two a, Two b) {
    const Two p = product_of(a.hi, b.hi);
    return renewed(p.hi, hn::MulAdd(a.hi, b.lo, hn::MulAdd(a.lo, b.hi, p.lo)));
}
/// Two in place of a number, and a number in place of Two.
HWY_INLINE Two widened(Two /*kind*/, V x) { return {.hi = x, .lo = hn::Zero(d)}; }
HWY_INLINE V widened(V /*kind*/, V x) { return x; }
HWY_INLINE V narrowed(Two x) { return x.hi; }
HWY_INLINE V narrowed(V x) { return x; }
HWY_INLINE V rest_of(Two x) { return x.lo; }
HWY_INLINE V rest_of(V /*x*/) { return hn::Zero(d); }
HWY_INLINE Two with_rest(Two /*kind*/, V hi, V lo) { return {.hi = hi, .lo = lo}; }
HWY_INLINE V with_rest(V /*kind*/, V hi, V /*lo*/) { return hi; }
HWY_INLINE Two plus(Two a, Two b) { return a + b; }
HWY_INLINE V plus(V a, V b) { return hn::Add(a, b); }
HWY_INLINE Two minus(Two a, Two b) { return a - b; }
HWY_INLINE V minus(V a, V b) { return hn::Sub(a, b); }
HWY_INLINE Two times(Two a, Two b) { return a * b; }
HWY_INLINE V times(V a, V b) { return hn::Mul(a, b); }
HWY_INLINE Two exact_product(Two /*kind*/, V a, V b) { return product_of(a, b); }
HWY_INLINE V exact_product(V /*kind*/, V a, V b) { return hn::Mul(a, b); }

template <class Wide>
void place_points_in(const IndexMap& map, const GridSize& size, PointLanes& points) {
    const Wide kind = widened(Wide{}, hn::Zero(d));
    points.inside = 0;
    for (std::size_t at = 0; at < points.count; at += width) {
        M inside = hn::Eq(hn::Zero(d), hn::Zero(d));
        for (std::size_t i = 0; i < 3; ++i) {
            Wide index = widened(kind, number(map.shift[i]));
            for (std::size_t c = 0; c < 3; ++c) {
                const double m = map.index_from_world[i][c];
                if (m == 0) continue;
                index = plus(index, exact_product(kind, number(m), hn::Load(d, points.at[c] + at)));
            }
            const double end = static_cast<double>(size[i]) - 1;
            const V place = narrowed(index);
            inside =
                hn::And(inside, hn::And(hn::Gt(place, hn::Zero(d)), hn::Lt(place, number(end))));
            V cell = minimum(hn::Floor(maximum(place, hn::Zero(d))), number(end - 1));
            // A little below a whole number
            const M below = hn::And(hn::Eq(cell, place), hn::Lt(rest_of(index), hn::Zero(d)));
            cell = hn::IfThenElse(below, hn::Sub(cell, number(1)), cell);
            const Wide share = minus(index, widened(kind, cell));
            hn::Store(cell, d, points.cell[i] + at);
            hn::Store(narrowed(share), d, points.share[i] + at);
            hn::Store(rest_of(share), d, points.share_rest[i] + at);
        }
        points.inside |= bits_of(inside) << at;
    }
}

void place_points(const IndexMap& map, const GridSize& size, Digits digits, PointLanes& points) {
    if (digits == Digits::Double) return place_points_in<V>(map, size, points);
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

HWY_INLINE V mix_plain(V a, V b, V share) { return hn::MulAdd(hn::Sub(b, a), share, a); }

/// Slopes in the world, in double: their last places do not matter.
HWY_INLINE void store_world_slopes(const IndexMap& map, const V (&corners)[8], const V (&share)[3],
                                   std::size_t at, PointLanes& points) {
    const auto by = [&](std::size_t edge) { return hn::Sub(corners[edge + 1], corners[edge]); };
    const auto on = [&](std::size_t edge) {
        return mix_plain(corners[edge], corners[edge + 1], share[0]);
    };
    const V on_0 = on(0);
    const V on_1 = on(2);
    const V on_2 = on(4);
    const V on_3 = on(6);
    const V slope[3] = {
        mix_plain(mix_plain(by(0), by(2), share[1]), mix_plain(by(4), by(6), share[1]), share[2]),
        mix_plain(hn::Sub(on_1, on_0), hn::Sub(on_3, on_2), share[2]),
        hn::Sub(mix_plain(on_2, on_3, share[1]), mix_plain(on_0, on_1, share[1]))};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        V sum = hn::Zero(d);
        for (std::size_t i = 0; i < 3; ++i) {
            const double m = map.index_from_world[i][axis];
            if (m != 0) sum = hn::MulAdd(number(m), slope[i], sum);
        }
        hn::Store(sum, d, points.slope[axis] + at);
    }
}

template <class Wide>
void mix_points_in(const IndexMap& map, bool with_slopes, PointLanes& points) {
    const Wide kind = widened(Wide{}, hn::Zero(d));
    for (std::size_t at = 0; at < points.count; at += width) {
        V corners[8];
        for (std::size_t i = 0; i < 8; ++i)
            corners[i] = hn::Load(d, points.corners[i] + at);
        V share[3];
        Wide wide_share[3];
        for (std::size_t i = 0; i < 3; ++i) {
            share[i] = hn::Load(d, points.share[i] + at);
            wide_share[i] = with_rest(kind, share[i], hn::Load(d, points.share_rest[i] + at));
        }
        const auto on = [&](std::size_t edge) {
            return mix(widened(kind, corners[edge]), widened(kind, corners[edge + 1]),
                       wide_share[0]);
        };
        const Wide below = mix(on(0), on(2), wide_share[1]);
        const Wide above = mix(on(4), on(6), wide_share[1]);
        hn::Store(narrowed(mix(below, above, wide_share[2])), d, points.value + at);
        if (with_slopes) store_world_slopes(map, corners, share, at, points);
    }
}

void mix_points(const IndexMap& map, Digits digits, bool with_slopes, PointLanes& points) {
    if (digits == Digits::Double) return mix_points_in<V>(map, with_slopes, points);
    mix_points_in<Two>(map, with_slopes, points);
}

/// Stores bounds from above.
HWY_INLINE void store_above(V bound, double* out) { hn::Store(bound, d, out); }
HWY_INLINE void store_above(V bound, float* out) {
    const hn::Rebind<float, D> floats;
    const auto rounded = hn::DemoteTo(floats, bound);
    // Two units of the last place more in any rounding mode, where it was rounded down
    const auto more =
        hn::MulAdd(hn::Abs(rounded), hn::Set(floats, 0x1p-22F), hn::Set(floats, 0x1p-148F));
    const M below = hn::Lt(hn::PromoteTo(d, rounded), bound);
    const V raised = hn::PromoteTo(d, hn::Add(rounded, more));
    hn::StoreU(hn::DemoteTo(floats, hn::IfThenElse(below, raised, hn::PromoteTo(d, rounded))),
               floats, out);
}

/// Bounds of the slope along an axis of the world.
HWY_INLINE Hull world_slope(const IndexMap& map, const V (&lo)[3], const V (&hi)[3],
                            std::size_t axis) {
    Hull sum{.lo = hn::Zero(d), .hi = hn::Zero(d)};
    for (std::size_t i = 0; i < 3; ++i) {
        const double m = map.index_from_world[i][axis];
        if (m == 0) continue;
        const V a = hn::Mul(number(m), m > 0 ? lo[i] : hi[i]);
        const V b = hn::Mul(number(m), m > 0 ? hi[i] : lo[i]);
        const Hull added{.lo = hn::Add(sum.lo, a), .hi = hn::Add(sum.hi, b)};
        const V error = hn::Mul(number(4 * unit_of<double>),
                                hn::Add(size_of(added.lo, added.hi), size_of(a, b)));
        sum = {.lo = hn::Sub(added.lo, error), .hi = hn::Add(added.hi, error)};
    }
    return sum;
}

template <class Real>
void make_forms_in(const IndexMap& map, const BoxLanes& boxes, const PointLanes& middles,
                   double unit, const FormLanes& forms, FormColumns<Real>& columns) {
    for (std::size_t at = 0; at < boxes.count; at += width) {
        const auto put = [&](std::size_t column, V bound) {
            store_above(bound, columns.column[column] + at);
        };
        const V lo = hn::Load(d, forms.lo + at);
        const V hi = hn::Load(d, forms.hi + at);
        const V largest = hn::Load(d, forms.largest + at);
        V slope_lo[3];
        V slope_hi[3];
        V rounding = largest;
        V index_error = hn::Zero(d);
        for (std::size_t i = 0; i < 3; ++i) {
            slope_lo[i] = hn::Load(d, forms.slope_lo[i] + at);
            slope_hi[i] = hn::Load(d, forms.slope_hi[i] + at);
            const V moved =
                hn::Mul(hn::Load(d, boxes.terms[i] + at), size_of(slope_lo[i], slope_hi[i]));
            rounding = hn::Add(rounding, moved);
            index_error = hn::Add(index_error, moved);
        }
        put(FieldForm::range, hn::Neg(lo));
        put(FieldForm::range + 1, hi);
        const V value = hn::Load(d, middles.value + at);
        const V error = hn::Add(hn::Mul(number(mixing_roundings), largest),
                                hn::Mul(number(index_roundings), index_error));
        const V wide = hn::Add(hn::Mul(number(2 * unit), error),
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
