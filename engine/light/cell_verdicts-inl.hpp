// Verdicts on cells of the ways from hits to the light: of beams one by one, of single rays in
// vectors of them. Included once for each instruction set, after Highway.

#if defined(ZEROSET_CELL_VERDICTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_CELL_VERDICTS_INL
#undef ZEROSET_CELL_VERDICTS_INL
#else
#define ZEROSET_CELL_VERDICTS_INL
#endif

#include "engine/kernel/form_cells.hpp"
#include "engine/real/lanes-inl.hpp"

#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// One cell, or a vector of cells, that are judged at once: their numbers, and what is true of
/// them.
template <class Real>
struct OneCell {
    using Number = Real;
    using Truth = bool;

    static Number zero() { return 0; }
    static Number abs(Number a) { return std::abs(a); }
    static Number sum(Number a, Number b) { return a + b; }
    static Number difference(Number a, Number b) { return a - b; }
    static Truth is_above(Number a, Number b) { return a > b; }
    static Truth both(Truth a, Truth b) { return a && b; }
    static Truth either(Truth a, Truth b) { return a || b; }
    static Truth without(Truth a, Truth b) { return a && !b; }
    static Number number_at(const Real* from) { return *from; }
    template <class Word>
    static Truth truth_at(const Word* from) {
        return *from != 0;
    }
};
template <class Real>
struct VectorOfCells {
    using Number = V<Real>;
    using Truth = M<Real>;

    static HWY_INLINE Number zero() { return hn::Zero(d<Real>); }
    static HWY_INLINE Number abs(Number a) { return hn::Abs(a); }
    static HWY_INLINE Number sum(Number a, Number b) { return hn::Add(a, b); }
    static HWY_INLINE Number difference(Number a, Number b) { return hn::Sub(a, b); }
    static HWY_INLINE Truth is_above(Number a, Number b) { return hn::Gt(a, b); }
    static HWY_INLINE Truth both(Truth a, Truth b) { return hn::And(a, b); }
    static HWY_INLINE Truth either(Truth a, Truth b) { return hn::Or(a, b); }
    static HWY_INLINE Truth without(Truth a, Truth b) { return hn::AndNot(b, a); }
    static HWY_INLINE Number number_at(const Real* from) { return hn::LoadU(d<Real>, from); }
    template <class Word>
    static HWY_INLINE Truth truth_at(const Word* from) {
        return mask_at(d<Real>, from);
    }
};

/// f on a cell, at the place t in [-1, 1] from its end towards the light to the other: within
/// `aside` of c + along t.
template <class Cells>
struct CellLine {
    typename Cells::Number c, along, aside;
    typename Cells::Truth falls, rises;  ///< f surely falls, or rises, with depth
    typename Cells::Truth continuous, nowhere;
};

/// The line of cell i, and of those behind it, of beams that are as wide as the cells' frustum.
template <class Cells, class Real, std::size_t capacity>
HWY_INLINE CellLine<Cells> line_of(const FormCells<Real, capacity>& cells, std::size_t i) {
    const auto number = [i](const auto& column) { return Cells::number_at(&column[i]); };
    return {.c = number(cells.c),
            .along = number(cells.k[2]),
            .aside = Cells::sum(
                Cells::sum(Cells::abs(number(cells.k[0])), Cells::abs(number(cells.k[1]))),
                number(cells.e)),
            .falls = Cells::is_above(Cells::zero(), number(cells.slope_hi)),
            .rises = Cells::is_above(Cells::zero(), number(cells.slope_neg_lo)),
            .continuous = Cells::truth_at(&cells.continuous[i]),
            .nowhere = Cells::truth_at(&cells.nowhere[i])};
}

/// Where the hits of a cell's ray are, and what is known of f there. In the cell they are roots, or
/// f is 0 or above at them (of members of unions), or they are neither; behind it, as the light
/// sees it, f may have a sign at its end away from the light.
template <class Cells>
struct HitsOfCell {
    typename Cells::Truth behind;
    typename Cells::Truth left_falling;  ///< in it, if f falls with depth, it leaves 0 at the hits
    typename Cells::Truth left_rising;   ///< in it, if f rises
    typename Cells::Truth above, below;  ///< behind it: f > 0, or f < 0
};

/// Whether a cell proves its rays free or dark; one of them, or neither.
template <class Cells>
struct ShadeVerdict {
    typename Cells::Truth free;                ///< no root but the hits
    typename Cells::Truth dark;                ///< a root on all rays
    typename Cells::Truth positive, negative;  ///< f at the end towards the light, of a free cell
};

/// In upward rounding.
template <class Cells>
HWY_INLINE ShadeVerdict<Cells> verdict_of(const CellLine<Cells>& f, const HitsOfCell<Cells>& hits) {
    using Truth = typename Cells::Truth;
    const auto both = [](Truth a, Truth b) { return Cells::both(a, b); };
    const auto either = [](Truth a, Truth b) { return Cells::either(a, b); };
    const auto without = [](Truth a, Truth b) { return Cells::without(a, b); };
    const auto steepness = Cells::abs(f.along);
    const auto size = Cells::abs(f.c);
    // Where f is not continuous, the form is of another function with its zeros, not its signs.
    const Truth rejected =
        without(Cells::is_above(size, Cells::sum(steepness, f.aside)), f.nowhere);
    const Truth has_sign = both(rejected, f.continuous);
    const Truth undecided = without(f.continuous, either(f.nowhere, rejected));
    // Depths fall towards the light: f goes away from 0 there, from the hits, or from where its
    // sign is known.
    const Truth rises_only = without(f.rises, f.falls);
    const Truth away =
        both(hits.behind, either(both(f.falls, hits.above), both(rises_only, hits.below)));
    const Truth leaves =
        either(both(f.falls, hits.left_falling), both(rises_only, hits.left_rising));
    const Truth sloped = both(undecided, either(away, leaves));
    const Truth is_positive = Cells::is_above(f.c, Cells::zero());
    // Towards the light f is below 0, or above, against its sign behind; or it has both signs.
    const auto sum_is_below = [&](auto a, auto b) {
        return Cells::is_above(Cells::zero(), Cells::sum(Cells::difference(a, b), f.aside));
    };
    const Truth turned = either(both(hits.above, sum_is_below(f.c, f.along)),
                                both(hits.below, sum_is_below(f.along, f.c)));
    const Truth opposite = Cells::is_above(steepness, Cells::sum(size, f.aside));
    return {.free = either(f.nowhere, either(rejected, sloped)),
            .dark = without(both(both(undecided, hits.behind), either(turned, opposite)), sloped),
            .positive = either(both(has_sign, is_positive), both(sloped, f.falls)),
            .negative = either(without(has_sign, is_positive), without(sloped, f.falls))};
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
