// What the form of a front's next cell tells, and the step that follows from it; for a vector of
// fronts at once.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_FRONT_STEPS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_FRONT_STEPS_INL
#undef ZEROSET_FRONT_STEPS_INL
#else
#define ZEROSET_FRONT_STEPS_INL
#endif

#include "engine/antialias/cover_rules.hpp"
#include "engine/antialias/front_block.hpp"
#include "engine/antialias/numbers-inl.hpp"
#include "engine/trace/simd/vectors-inl.hpp"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The lengths and bounds that steer the search along beams of squares of one level.
struct FrontRules {
    double fair_width;  ///< times the distance from the eye: the longest cell that is not halved
    double half_width;  ///< so, half the width of a square; 0: rays
    double distance;    ///< of depth 0
    double margin;      ///< by which cells are longer than their slabs, at both ends
    double slack;       ///< of roots, for rounding
};

/// Forms of cells, slabs of squares' beams.
struct CellForm {
    V<double> c, along, aside, error;  ///< aside: of both directions across
    V<double> middle, radius;          ///< the slabs
    V<double> slope_hi, slope_neg_lo;  ///< of f along the rays
    M<double> continuous, nowhere, kinked;
};

/// Cells as their forms judge all of their rays.
struct CellVerdict {
    V<double> from, to;    ///< the slabs
    M<double> rejected;    ///< no ray has a root
    M<double> continuous;  ///< f is
    M<double> monotone;    ///< f rises on all rays, or falls: there is at most one root on each
    M<double> kinked;      ///< f may have a kink
    M<double> precise;     ///< the form's error is small beside its change across the square
    /// Where its linear part lets roots be, perhaps beyond the slab.
    V<double> root_from, root_to;
    V<double> turn;  ///< the width of the enclosure of normal . view, where roots end in the slab
    /// How much longer a cell may be: rejected, or precise, if f goes on as it does here.
    V<double> growth;
    V<double> fair;  ///< the longest cell that is not halved
};

/// FrontMarks of a vector of fronts.
class MarkWords {
public:
    using Words = hn::Vec<hn::RebindToUnsigned<Tag<double>>>;
    static constexpr hn::RebindToUnsigned<Tag<double>> tag{};
    static constexpr std::uint64_t state = 0xFF;
    static constexpr std::uint64_t continuous = std::uint64_t{1} << 8U;
    static constexpr std::uint64_t kinked = std::uint64_t{1} << 16U;
    static constexpr std::uint64_t stretched = std::uint64_t{1} << 24U;
    static constexpr std::uint64_t monotone = std::uint64_t{1} << 32U;
    static constexpr std::uint64_t one_cell = std::uint64_t{1} << 40U;
    static constexpr std::uint64_t cells = 0xFF * one_cell;
    static constexpr std::uint64_t calm = std::uint64_t{1} << 56U;

    explicit MarkWords(Words words) : words_(words) {}
    [[nodiscard]] HWY_INLINE M<double> has(std::uint64_t bit) const {
        return hn::RebindMask(d<double>, hn::TestBit(words_, hn::Set(tag, bit)));
    }
    /// Counts one more open cell; the first one where a stretch begins.
    HWY_INLINE void count_cell(M<double> lanes, M<double> begins) {
        words_ = hn::AndNot(in(begins, cells), words_);
        words_ = hn::Add(words_, in(lanes, one_cell));
    }
    /// Sets bits in these lanes, and clears them in others of `lanes`.
    HWY_INLINE void set(std::uint64_t bit, M<double> lanes, M<double> value) {
        cleared_ = hn::Or(cleared_, in(lanes, bit));
        added_ = hn::Or(added_, in(hn::And(lanes, value), bit));
    }
    HWY_INLINE void set_state(FrontMarks::State to, M<double> lanes) {
        cleared_ = hn::Or(cleared_, in(lanes, state));
        added_ = hn::Or(added_, in(lanes, static_cast<std::uint64_t>(to)));
    }
    /// The words with all that was set, which `has` does not know of.
    [[nodiscard]] HWY_INLINE Words changed() const {
        return hn::Or(hn::AndNot(cleared_, words_), added_);
    }

private:
    static HWY_INLINE Words in(M<double> lanes, std::uint64_t bits) {
        return hn::IfThenElseZero(hn::RebindMask(tag, lanes), hn::Set(tag, bits));
    }

    Words words_;
    // Apart from the words, so that no change waits for another one.
    Words cleared_ = hn::Zero(tag);
    Words added_ = hn::Zero(tag);
};

/// How much longer than the cell before it a cell is at most, and how much shorter.
inline constexpr double most_growth = 4.0;
inline constexpr double least_growth = 0.125;

/// Where the next cells end.
HWY_INLINE V<double> next_of(const FrontBlock& fronts, std::size_t i) {
    const V<double> to = hn::Add(load(&fronts.at[i]), load(&fronts.step[i]));
    return hn::Min(to, load(&fronts.end[i]));
}

HWY_INLINE CellVerdict judge(const CellForm& form, const FrontRules& rules,
                             const FrontBlock& fronts, std::size_t i) {
    const V<double> one = number(1.0);
    const V<double> zero = hn::Zero(d<double>);
    const V<double> steepness = hn::Abs(form.along);
    const V<double> size = hn::Abs(form.c);
    const V<double> most = hn::Add(hn::Add(form.aside, form.error), steepness);
    const M<double> known = hn::IsFinite(form.error);
    CellVerdict verdict{};
    verdict.from = load(&fronts.at[i]);
    verdict.to = next_of(fronts, i);
    verdict.rejected = hn::Or(form.nowhere, hn::Gt(size, most));
    verdict.continuous = hn::And(known, form.continuous);
    verdict.monotone = hn::Or(hn::Lt(form.slope_hi, zero), hn::Lt(form.slope_neg_lo, zero));
    verdict.kinked = form.kinked;
    const V<double> most_error = hn::Mul(
        hn::IfThenElse(MarkWords(hn::LoadU(MarkWords::tag, &fronts.marks[i])).has(MarkWords::calm),
                       number(most_calm_cell_error), number(most_cell_error)),
        form.aside);
    verdict.precise = hn::And(known, hn::Le(form.error, most_error));
    verdict.fair = hn::Mul(number(rules.fair_width), hn::Add(number(rules.distance), verdict.from));
    // The error goes with the square of the length, or nearly so.
    const V<double> part = hn::Div(hn::IfThenElse(verdict.rejected, size, most_error),
                                   hn::IfThenElse(verdict.rejected, most, form.error));
    const hn::Rebind<float, Tag<double>> narrow;
    const V<double> root = hn::PromoteTo(d<double>, hn::Sqrt(hn::DemoteTo(narrow, part)));
    verdict.growth = hn::IfThenElse(verdict.rejected, part, hn::IfThenElse(known, root, one));
    // Where the linear part vanishes.
    const M<double> sloped = hn::And(known, hn::Ne(form.along, zero));
    const V<double> per_along = hn::Div(one, form.along);
    const V<double> at = hn::Neg(hn::Mul(form.c, per_along));
    const V<double> slack = number(rules.slack);
    const V<double> spare = hn::Add(
        hn::Mul(hn::Mul(hn::Add(form.aside, form.error), hn::Abs(per_along)), hn::Add(one, slack)),
        hn::Mul(slack, hn::Add(one, hn::Abs(at))));
    const auto depth_at = [&](V<double> t) {
        return hn::Add(form.middle, hn::Mul(form.radius, t));
    };
    verdict.root_from =
        hn::IfThenElse(sloped, depth_at(hn::Sub(at, spare)), hn::Neg(hn::Inf(d<double>)));
    verdict.root_to = hn::IfThenElse(sloped, depth_at(hn::Add(at, spare)), hn::Inf(d<double>));
    // The form's linear part is f's gradient, in parts of the cell's radii: along the ray, and
    // across.
    V<double> gradient = steepness;
    V<double> radii = form.radius;
    if (rules.half_width > 0.0) {
        const V<double> half =
            hn::Mul(number(rules.half_width), hn::Add(number(rules.distance), form.middle));
        gradient = hn::Max(hn::Mul(form.aside, radii), hn::Mul(steepness, half));
        radii = hn::Mul(radii, half);
    }
    verdict.turn = hn::Div(hn::Mul(hn::Add(form.slope_hi, form.slope_neg_lo), radii), gradient);
    return verdict;
}

inline constexpr std::uint64_t most_open_cells = 8;  // a power of two
/// In fair lengths: cells whose forms are not precise are not longer.
inline constexpr double most_rough_lengths = 1.5;
/// Roots that lie in fewer fair lengths are looked for in one cell.
inline constexpr double most_fair_lengths = 8.0;

/// The step that each front takes, as masks: a lane is set in exactly one of them.
struct CellSteps {
    M<double> free;         ///< go on behind the cell
    M<double> free_behind;  ///< it ends a stretch
    M<double> root_behind;  ///< roots of all rays end a stretch
    M<double> halved;       ///< there may be several roots on a ray, of which the first is wanted
    M<double> narrowed;     ///< a long cell tells more of f beside the sheet than of the sheet
    M<double> rooted;       ///< it holds the first root of every ray
    M<double> shortened;    ///< the form is not precise
    M<double> lengthened;   ///< all rays seem to leave it with a root
    M<double> open;         ///< it is left as a part of a stretch
};

/// A little before the first place where the cell may hold a root: all of it that lies before this
/// is free. Not where rays enter the clip region, of which stretches begin outside.
HWY_INLINE V<double> before_roots_of(const FrontBlock& fronts, std::size_t i,
                                     const CellVerdict& cell, const FrontRules& rules) {
    const V<double> width = hn::Sub(cell.root_to, cell.root_from);
    const V<double> back = hn::MulAdd(number(1.0 / 32), width, number(rules.margin));
    const V<double> last = hn::MulAdd(number(0.9), hn::Sub(cell.to, cell.from), cell.from);
    const V<double> before = hn::Min(hn::Sub(cell.root_from, back), last);
    return hn::IfThenElse(hn::Ge(before, load(&fronts.inside_from[i])), hn::Max(cell.from, before),
                          cell.from);
}

HWY_INLINE CellSteps steps_of(const FrontBlock& fronts, std::size_t i, const CellVerdict& cell,
                              const MarkWords& marks, const FrontRules& rules) {
    const auto times = [](double factor, V<double> of) { return hn::Mul(number(factor), of); };
    const M<double> is_open = hn::Lt(load(&fronts.open_from[i]), hn::Inf(d<double>));
    const M<double> begins = hn::Gt(cell.root_from, cell.from);
    const M<double> ends = hn::Lt(cell.root_to, cell.to);
    const M<double> inside = hn::And(hn::Ge(cell.root_from, load(&fronts.inside_from[i])),
                                     hn::Le(cell.root_to, load(&fronts.inside_to[i])));
    const V<double> length = hn::Sub(cell.to, cell.from);
    const V<double> width = hn::Sub(cell.root_to, cell.root_from);
    CellSteps steps{};
    steps.free = hn::AndNot(is_open, cell.rejected);
    steps.free_behind = hn::And(is_open, cell.rejected);
    // Roots of all rays.
    const M<double> all =
        hn::AndNot(cell.rejected, hn::And(hn::And(cell.continuous, inside), hn::And(begins, ends)));
    steps.root_behind = hn::And(is_open, all);
    const M<double> first = hn::AndNot(is_open, all);
    steps.halved = hn::And(hn::AndNot(cell.monotone, first), hn::Gt(length, times(2.0, cell.fair)));
    const V<double> turn =
        hn::IfThenElse(cell.kinked, number(most_turn_of(true)), number(most_turn_of(false)));
    const M<double> coarse = hn::And(
        hn::Gt(cell.turn, turn), hn::Gt(length, times(3.0, hn::Add(width, number(rules.margin)))));
    steps.narrowed =
        hn::AndNot(marks.has(MarkWords::calm), hn::And(hn::AndNot(steps.halved, first), coarse));
    steps.rooted = hn::AndNot(hn::Or(steps.halved, steps.narrowed), first);
    // Of some, or none.
    const M<double> others = hn::Not(hn::Or(cell.rejected, all));
    steps.shortened = hn::And(hn::AndNot(cell.precise, others),
                              hn::Gt(length, times(most_rough_lengths, cell.fair)));
    const M<double> fits = hn::And(hn::Lt(cell.to, load(&fronts.end[i])),
                                   hn::Lt(width, times(most_fair_lengths, cell.fair)));
    // Nearly precise is enough for roots of all rays.
    const V<double> longest = hn::Mul(times(2.0, cell.growth), length);
    const M<double> too_long = hn::Gt(hn::Sub(cell.root_to, cell.from), longest);
    const M<double> leaves = hn::AndNot(hn::Or(ends, too_long), hn::And(begins, cell.precise));
    steps.lengthened = hn::And(hn::AndNot(steps.shortened, others),
                               hn::AndNot(marks.has(MarkWords::stretched), hn::And(leaves, fits)));
    steps.open = hn::AndNot(hn::Or(steps.shortened, steps.lengthened), others);
    return steps;
}

/// The part of a cell that may hold roots. At walls of the clip region this is the whole cell, as
/// stretches of its rays that begin and end at walls tell more.
struct RootPart {
    V<double> from, to;
};
HWY_INLINE RootPart root_part_of(const FrontBlock& fronts, std::size_t i, const CellVerdict& cell) {
    const V<double> begin = hn::Min(cell.from, load(&fronts.open_from[i]));
    const M<double> at_walls = hn::Or(hn::Lt(begin, load(&fronts.inside_from[i])),
                                      hn::Gt(cell.to, load(&fronts.inside_to[i])));
    const V<double> width = hn::Sub(cell.root_to, cell.root_from);
    const V<double> from = hn::Min(hn::Max(cell.from, cell.root_from), cell.to);
    const V<double> to = hn::MulAdd(number(0.25), width, cell.root_to);
    return {.from = hn::IfThenElse(at_walls, cell.from, from),
            .to = hn::IfThenElse(at_walls, cell.to, hn::Min(hn::Max(from, to), cell.to))};
}

/// Stretches that end with their cells, and where.
struct Closed {
    M<double> lanes;
    V<double> to;
};
/// Sets the marks of stretches and roots; returns which stretches end.
HWY_INLINE Closed mark_open(FrontBlock& fronts, std::size_t i, const CellVerdict& cell,
                            const CellSteps& steps, MarkWords& marks) {
    const V<double> open_from = load(&fronts.open_from[i]);
    const M<double> is_open = hn::Lt(open_from, hn::Inf(d<double>));
    const M<double> begins = hn::AndNot(is_open, steps.open);
    const RootPart part = root_part_of(fronts, i, cell);
    store(hn::IfThenElse(begins, part.from, open_from), &fronts.open_from[i]);
    marks.count_cell(steps.open, begins);
    marks.set(MarkWords::continuous, steps.open,
              hn::And(cell.continuous, hn::Or(begins, marks.has(MarkWords::continuous))));
    const M<double> kinked = hn::Or(cell.kinked, hn::AndNot(begins, marks.has(MarkWords::kinked)));
    marks.set(MarkWords::kinked, hn::Or(steps.open, steps.root_behind), kinked);
    const V<double> end = load(&fronts.end[i]);
    const M<double> last = hn::Or(hn::Ge(cell.to, end), hn::Lt(part.to, cell.to));
    const M<double> full = marks.has(most_open_cells * MarkWords::one_cell);
    return {.lanes = hn::And(steps.open, hn::Or(full, last)), .to = part.to};
}

/// Takes what is known of the fronts' next cells; returns which fronts go on no more.
HWY_INLINE M<double> step(FrontBlock& fronts, std::size_t i, const CellVerdict& cell,
                          const FrontRules& rules) {
    MarkWords marks(hn::LoadU(MarkWords::tag, &fronts.marks[i]));
    const CellSteps steps = steps_of(fronts, i, cell, marks, rules);
    const M<double> is_open = hn::Lt(load(&fronts.open_from[i]), hn::Inf(d<double>));
    const V<double> length = hn::Sub(cell.to, cell.from);
    const V<double> width = hn::Sub(cell.root_to, cell.root_from);
    const V<double> margin = number(rules.margin);
    const auto where = [](M<double> lanes, V<double> yes, V<double> no) {
        return hn::IfThenElse(lanes, yes, no);
    };

    const Closed closed = mark_open(fronts, i, cell, steps, marks);
    marks.set(MarkWords::stretched, hn::Or(hn::Or(steps.free, steps.open), steps.lengthened),
              steps.lengthened);
    marks.set(MarkWords::monotone, steps.rooted, cell.monotone);
    marks.set(MarkWords::kinked, steps.rooted, cell.kinked);

    // Where the search goes on.
    const V<double> quarter = hn::Add(hn::Mul(number(0.25), width), margin);
    const V<double> before = before_roots_of(fronts, i, cell, rules);
    const V<double> near =
        where(steps.narrowed, hn::Max(cell.from, hn::Sub(cell.root_from, quarter)), before);
    V<double> at = where(hn::Or(steps.free, steps.open), cell.to, cell.from);
    const M<double> shorter_or_longer = hn::Or(steps.shortened, steps.lengthened);
    const M<double> tried_again = hn::Or(hn::Or(steps.halved, steps.narrowed), shorter_or_longer);
    at = where(hn::AndNot(is_open, tried_again), near, where(steps.rooted, cell.root_from, at));
    // How far.
    const V<double> longer = hn::Min(hn::Max(cell.growth, number(1.0)), number(most_growth));
    const V<double> precise = hn::Mul(number(0.95), cell.growth);
    const V<double> shorter = hn::Min(hn::Max(precise, number(least_growth)), number(0.6));
    const V<double> past_roots = hn::Sub(hn::Add(cell.root_to, quarter), near);
    V<double> next = load(&fronts.step[i]);
    next = where(steps.free, hn::Mul(longer, length), next);
    next = where(steps.halved, hn::Mul(number(0.5), length), next);
    next = where(steps.narrowed, past_roots, next);
    next = where(steps.shortened, hn::Max(hn::Mul(shorter, length), cell.fair), next);
    next = where(steps.lengthened, past_roots, next);
    // Roots, and stretches that end; so far before the roots that the next cell holds them, too.
    const M<double> edged = hn::Or(closed.lanes, hn::Or(steps.free_behind, steps.root_behind));
    const V<double> before_roots =
        hn::Max(cell.from, hn::Sub(cell.root_from, hn::Add(width, margin)));
    V<double> to = load(&fronts.to[i]);
    to = where(steps.rooted, cell.root_to, to);
    to = where(closed.lanes, closed.to, to);
    to = where(steps.free_behind, cell.from, to);
    to = where(steps.root_behind, before_roots, to);
    at = where(edged, load(&fronts.open_from[i]), at);

    const V<double> end = load(&fronts.end[i]);
    const M<double> gone = hn::And(steps.free, hn::Ge(at, end));
    marks.set_state(FrontMarks::State::Gone, gone);
    marks.set_state(FrontMarks::State::Rooted, steps.rooted);
    marks.set_state(FrontMarks::State::Edged, edged);
    store(at, &fronts.at[i]);
    store(to, &fronts.to[i]);
    store(next, &fronts.step[i]);
    store(where(steps.rooted, cell.turn, load(&fronts.turn[i])), &fronts.turn[i]);
    hn::StoreU(marks.changed(), MarkWords::tag, &fronts.marks[i]);
    return hn::Or(gone, hn::Or(steps.rooted, edged));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
