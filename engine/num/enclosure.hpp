#pragma once

#include "engine/num/interval.hpp"

#include <optional>
#include <utility>

// The carrier of interval evaluation: a range, and what is known of the domain.

namespace zeroset {

/// Range, domain and continuity of a function over a box, for each lane. An absent mask is true.
template <class Real>
struct Enclosure {
    using Mask = decltype(std::declval<Real>() > std::declval<Real>());

    Interval<Real> range;              ///< encloses the values where the function is defined
    std::optional<Mask> somewhere{};   ///< false: undefined on the whole box
    std::optional<Mask> everywhere{};  ///< true: proved defined on the whole box
    std::optional<Mask> continuous{};  ///< true: proved continuous where it is defined
    /// Every value is at most gap->hi or at least -gap->neg_lo; no value lies between them, as
    /// beside a jump or a pole. Absent: nothing is known.
    std::optional<Interval<Real>> gap{};
};

/// Lanes in which all masks hold. Equal masks, as of shared operands, cost nothing.
template <class Mask>
std::optional<Mask> conjunction(const std::optional<Mask>& a, const std::optional<Mask>& b) {
    if (!a) return b;
    if (!b || identical(*a, *b)) return a;
    return both(*a, *b);
}
template <class Mask>
std::optional<Mask> conjunction(const std::optional<Mask>& a, const std::optional<Mask>& b,
                                const std::optional<Mask>& c) {
    return conjunction(a, conjunction(b, c));
}

/// Enclosure of g(operands...), where `g` is the enclosure of g alone on the operands' ranges.
template <class Real, class... Operands>
Enclosure<Real> composed(const Enclosure<Real>& g, const Operands&... operands) {
    return {.range = g.range,
            .somewhere = conjunction(g.somewhere, operands.somewhere...),
            .everywhere = conjunction(g.everywhere, operands.everywhere...),
            .continuous = conjunction(g.continuous, operands.continuous...),
            .gap = g.gap};
}

/// The more useful of two valid `gap`: `a` if it excludes some values, else `b`.
template <class Real>
std::optional<Interval<Real>> sharper(const std::optional<Interval<Real>>& a,
                                      const std::optional<Interval<Real>>& b) {
    if (!a || !b) return a ? a : b;
    return select(a->neg_lo + a->hi < like(a->hi, 0.0), *a, *b);
}

/// `gap` of v c from that of v and the interval c; the whole line where 0 is inside c.
template <class Real>
Interval<Real> multiply_gap(const Interval<Real>& gap, const Interval<Real>& c) {
    const auto falls = c.hi <= like(c.hi, 0.0);
    const Interval<Real> v = select(falls, -gap, gap);
    const Interval<Real> size = select(falls, -c, c);
    const Real size_lo = -size.neg_lo;
    const Interval<Real> product{v.neg_lo * select_negative(v.neg_lo, size_lo, size.hi),
                                 v.hi * select_negative(v.hi, size_lo, size.hi)};
    return select(size.neg_lo <= like(c.hi, 0.0), product, whole_line(c.hi));
}

/// A kernel's answer for the box: the range; or `gap`, both of whose members are then below 0,
/// where it excludes 0. Both members are -inf where f is defined nowhere.
template <class Real>
Interval<Real> answer(const Enclosure<Real>& f) {
    const Real zero = like(f.range.hi, 0.0);
    Interval<Real> result = f.range;
    if (f.gap) {
        const auto excludes_zero = both(f.gap->neg_lo < zero, f.gap->hi < zero);
        result = select(excludes_zero, *f.gap, result);
    }
    if (f.somewhere) {
        const Real nowhere = like(zero, -infinity);
        result = select(*f.somewhere, result, Interval<Real>{nowhere, nowhere});
    }
    return result;
}

}  // namespace zeroset
