#pragma once

#include "engine/num/interval.hpp"

#include <optional>
#include <utility>

// The carrier of interval evaluation: a range, and what is known of the domain.

namespace zeroset {

/// What is known of a function over a box, for each lane. An absent mask is true.
template <class Real>
struct Enclosure {
    using Mask = decltype(std::declval<Real>() > std::declval<Real>());

    Interval<Real> range;              ///< encloses the values where the function is defined
    std::optional<Mask> somewhere{};   ///< false: undefined on the whole box
    std::optional<Mask> everywhere{};  ///< true: proved defined on the whole box
    std::optional<Mask> continuous{};  ///< true: proved continuous where it is defined
};

/// Where all hold. Equal masks, as of shared operands, cost nothing.
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

/// g(operands...) from what g alone does on their ranges.
template <class Real, class... Operands>
Enclosure<Real> composed(const Enclosure<Real>& g, const Operands&... operands) {
    return {g.range, conjunction(g.somewhere, operands.somewhere...),
            conjunction(g.everywhere, operands.everywhere...),
            conjunction(g.continuous, operands.continuous...)};
}

}  // namespace zeroset
