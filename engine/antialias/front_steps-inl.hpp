// The verdict of the form of a front's next cell, and the step that follows from it; for a vector
// of fronts at once.
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
#include "engine/real/lanes-inl.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The square root, to the digits of float.
HWY_INLINE V<double> root_of(V<double> square) {
    const hn::Rebind<float, Tag<double>> narrow;
    return hn::PromoteTo(d<double>, hn::Sqrt(hn::DemoteTo(narrow, square)));
}
HWY_INLINE V<float> root_of(V<float> square) { return hn::Sqrt(square); }

/// The lengths and bounds that steer the search along beams of squares of one level.
template <class Real>
struct FrontRules {
    Real fair_width;  ///< times the distance from the eye: the longest cell that is not halved
    Real half_width;  ///< times the distance from the eye: half the width of a square; 0: rays
    Real distance;    ///< from the eye, of depth 0
    Real margin;      ///< by which cells are longer than their slabs, at both ends

    /// How far roots may be off by rounding, in parts of their cells.
    static constexpr double slack = 16 * static_cast<double>(std::numeric_limits<Real>::epsilon());
    /// How far depths may be off by rounding, in parts of them: shorter lengths are not halved.
    static constexpr double unit = 4 * static_cast<double>(std::numeric_limits<Real>::epsilon());
    /// From here on 1 / x is not as precise as x.
    static constexpr Real steepest = std::numeric_limits<Real>::max() / 16;
};

/// Forms of cells, slabs of squares' beams.
template <class Real>
struct CellForm {
    V<Real> c, along, aside, error;  ///< aside: of both directions across
    V<Real> middle, radius;          ///< the slabs
    V<Real> slope_hi, slope_neg_lo;  ///< of f along the rays
    M<Real> continuous, nowhere, kinked;
};

/// Cells as their forms judge all of their rays.
template <class Real>
struct CellVerdict {
    V<Real> from, to;    ///< the slabs
    M<Real> rejected;    ///< no ray has a root
    M<Real> continuous;  ///< f is
    M<Real> monotone;    ///< f rises on all rays, or falls: there is at most one root on each
    M<Real> kinked;      ///< f may have a kink
    M<Real> precise;     ///< the form's error is small beside its change across the square
    M<Real> rough;       ///< the form is not even nearly precise
    /// Where its linear part lets roots be, perhaps beyond the slab.
    V<Real> root_from, root_to;
    V<Real> turn;  ///< the width of the enclosure of normal . view, where roots end in the slab
    /// How much longer a cell may be: rejected, or precise, if f goes on as it does here.
    V<Real> growth;
    V<Real> fair;    ///< the longest cell that is not halved
    V<Real> margin;  ///< by which the next cell reaches beyond the roots that it is to hold
};

/// FrontMarks of a vector of fronts.
template <class Real>
class MarkWords {
public:
    using Words = hn::Vec<hn::RebindToUnsigned<Tag<Real>>>;
    using Word = hn::TFromV<Words>;
    static constexpr hn::RebindToUnsigned<Tag<Real>> tag{};
    static constexpr Word state = 0xFF;
    static constexpr Word one_cell = Word{1} << 8U;
    static constexpr Word cells = 0xFF * one_cell;
    static constexpr Word continuous = Word{1} << 16U;
    static constexpr Word kinked = Word{1} << 17U;
    static constexpr Word stretched = Word{1} << 18U;
    static constexpr Word monotone = Word{1} << 19U;
    static constexpr Word calm = Word{1} << 20U;

    explicit MarkWords(Words words) : words_(words) {}
    [[nodiscard]] HWY_INLINE M<Real> has(Word bit) const {
        return hn::RebindMask(d<Real>, hn::TestBit(words_, hn::Set(tag, bit)));
    }
    /// Counts one more open cell; the first one where a stretch begins.
    HWY_INLINE void count_cell(M<Real> lanes, M<Real> begins) {
        words_ = hn::AndNot(in(begins, cells), words_);
        words_ = hn::Add(words_, in(lanes, one_cell));
    }
    /// Sets bits in these lanes, and clears them in others of `lanes`.
    HWY_INLINE void set(Word bit, M<Real> lanes, M<Real> value) {
        cleared_ = hn::Or(cleared_, in(lanes, bit));
        added_ = hn::Or(added_, in(hn::And(lanes, value), bit));
    }
    HWY_INLINE void set_state(FrontMarks::State to, M<Real> lanes) {
        cleared_ = hn::Or(cleared_, in(lanes, state));
        added_ = hn::Or(added_, in(lanes, static_cast<Word>(to)));
    }
    /// The words with all that was set, which `has` does not know of.
    [[nodiscard]] HWY_INLINE Words changed() const {
        return hn::Or(hn::AndNot(cleared_, words_), added_);
    }

private:
    static HWY_INLINE Words in(M<Real> lanes, Word bits) {
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
/// The error of a form in most_cell_error from which on its cell is shortened: one that is nearly
/// precise tells almost as much as the next one would.
inline constexpr double rough_errors = 1.5;
/// How much shorter the next cell at least is.
inline constexpr double most_shortened = 0.75;

/// Where the next cells end.
template <class Real>
HWY_INLINE V<Real> next_of(const FrontBlock<Real>& fronts, std::size_t i) {
    const V<Real> to = hn::Add(load(&fronts.at[i]), load(&fronts.step[i]));
    return hn::Min(to, load(&fronts.end[i]));
}

template <class Real>
HWY_INLINE CellVerdict<Real> judge(const CellForm<Real>& form, const FrontRules<Real>& rules,
                                   const FrontBlock<Real>& fronts, std::size_t i) {
    const V<Real> one = number<Real>(1.0);
    const V<Real> zero = hn::Zero(d<Real>);
    const V<Real> steepness = hn::Abs(form.along);
    const V<Real> size = hn::Abs(form.c);
    const V<Real> most = hn::Add(hn::Add(form.aside, form.error), steepness);
    const M<Real> known = hn::IsFinite(form.error);
    CellVerdict<Real> verdict{};
    verdict.from = load(&fronts.at[i]);
    verdict.to = next_of(fronts, i);
    verdict.rejected = hn::Or(form.nowhere, hn::Gt(size, most));
    verdict.continuous = hn::And(known, form.continuous);
    verdict.monotone = hn::Or(hn::Lt(form.slope_hi, zero), hn::Lt(form.slope_neg_lo, zero));
    verdict.kinked = form.kinked;
    // Compare the form's error with its change across the square.
    const V<Real> most_error =
        hn::Mul(hn::IfThenElse(MarkWords<Real>(hn::LoadU(MarkWords<Real>::tag, &fronts.marks[i]))
                                   .has(MarkWords<Real>::calm),
                               number<Real>(most_calm_cell_error), number<Real>(most_cell_error)),
                form.aside);
    verdict.precise = hn::And(known, hn::Le(form.error, most_error));
    const V<Real> rough_error = hn::Mul(number<Real>(rough_errors), most_error);
    verdict.rough = hn::Not(hn::And(known, hn::Le(form.error, rough_error)));
    // Set the lengths that steer the next cell.
    verdict.margin = hn::MulAdd(number<Real>(FrontRules<Real>::unit), hn::Abs(verdict.from),
                                number<Real>(rules.margin));
    verdict.fair = hn::Max(hn::Mul(number<Real>(rules.fair_width),
                                   hn::Add(number<Real>(rules.distance), verdict.from)),
                           verdict.margin);
    // The error goes with the square of the length, or nearly so.
    const V<Real> part = hn::Div(hn::IfThenElse(verdict.rejected, size, most_error),
                                 hn::IfThenElse(verdict.rejected, most, form.error));
    verdict.growth =
        hn::IfThenElse(verdict.rejected, part, hn::IfThenElse(known, root_of(part), one));
    // Where the linear part vanishes. The slack is more than what the quotients and products may
    // be off by; sums are rounded outward.
    const V<Real> per_along = hn::Div(one, form.along);
    const V<Real> at = hn::Neg(hn::Mul(form.c, per_along));
    const V<Real> slack = number<Real>(FrontRules<Real>::slack);
    const V<Real> spare = hn::Add(
        hn::Mul(hn::Mul(hn::Add(form.aside, form.error), hn::Abs(per_along)), hn::Add(one, slack)),
        hn::Mul(slack, hn::Add(one, hn::Abs(at))));
    const M<Real> sloped =
        hn::And(hn::IsFinite(spare), hn::Lt(steepness, number<Real>(FrontRules<Real>::steepest)));
    const V<Real> before = hn::MulSub(form.radius, hn::Sub(spare, at), form.middle);
    const V<Real> behind = hn::MulAdd(form.radius, hn::Add(spare, at), form.middle);
    verdict.root_from = hn::IfThenElse(sloped, hn::Neg(before), hn::Neg(hn::Inf(d<Real>)));
    verdict.root_to = hn::IfThenElse(sloped, behind, hn::Inf(d<Real>));
    // The form's linear part is f's gradient, in parts of the cell's radii: along the ray, and
    // across.
    V<Real> per_slope = hn::Mul(form.radius, hn::Abs(per_along));
    if (rules.half_width > Real{0}) {
        const V<Real> half = hn::Mul(number<Real>(rules.half_width),
                                     hn::Add(number<Real>(rules.distance), form.middle));
        per_slope = hn::Min(per_slope, hn::Div(half, form.aside));
    }
    verdict.turn = hn::Mul(hn::Add(form.slope_hi, form.slope_neg_lo), per_slope);
    return verdict;
}

inline constexpr std::uint8_t most_open_cells = 8;  // a power of two
/// The longest cell with a rough form, in fair lengths.
inline constexpr double most_rough_lengths = 2.0;
/// Roots that lie in fewer fair lengths are looked for in one cell.
inline constexpr double most_fair_lengths = 8.0;

/// The step that each front takes, as masks: a lane is set in exactly one of them.
template <class Real>
struct CellSteps {
    M<Real> free;         ///< go on behind the cell
    M<Real> free_behind;  ///< it ends a stretch
    M<Real> root_behind;  ///< roots of all rays end a stretch
    M<Real> halved;       ///< there may be several roots on a ray, of which the first is wanted
    M<Real> narrowed;     ///< a long cell tells more of f beside the sheet than of the sheet
    M<Real> rooted;       ///< it holds the first root of every ray
    M<Real> shortened;    ///< the form is rough
    M<Real> lengthened;   ///< all rays seem to leave it with a root
    M<Real> open;         ///< it is left as a part of a stretch
};

/// A depth a little before the first place where the cell may hold a root: the cell is free up to
/// there. Its begin where rays enter the clip region: their stretches begin outside.
template <class Real>
HWY_INLINE V<Real> before_roots_of(const FrontBlock<Real>& fronts, std::size_t i,
                                   const CellVerdict<Real>& cell) {
    const V<Real> width = hn::Sub(cell.root_to, cell.root_from);
    const V<Real> back = hn::MulAdd(number<Real>(1.0 / 32), width, cell.margin);
    const V<Real> last = hn::MulAdd(number<Real>(0.9), hn::Sub(cell.to, cell.from), cell.from);
    const V<Real> before = hn::Min(hn::Sub(cell.root_from, back), last);
    return hn::IfThenElse(hn::Ge(before, load(&fronts.inside_from[i])), hn::Max(cell.from, before),
                          cell.from);
}

template <class Real>
HWY_INLINE CellSteps<Real> steps_of(const FrontBlock<Real>& fronts, std::size_t i,
                                    const CellVerdict<Real>& cell, const MarkWords<Real>& marks) {
    const auto times = [](double factor, V<Real> of) { return hn::Mul(number<Real>(factor), of); };
    const M<Real> is_open = hn::Lt(load(&fronts.open_from[i]), hn::Inf(d<Real>));
    const M<Real> begins = hn::Gt(cell.root_from, cell.from);
    const M<Real> ends = hn::Lt(cell.root_to, cell.to);
    const M<Real> inside = hn::And(hn::Ge(cell.root_from, load(&fronts.inside_from[i])),
                                   hn::Le(cell.root_to, load(&fronts.inside_to[i])));
    const V<Real> length = hn::Sub(cell.to, cell.from);
    const V<Real> width = hn::Sub(cell.root_to, cell.root_from);
    CellSteps<Real> steps{};
    steps.free = hn::AndNot(is_open, cell.rejected);
    steps.free_behind = hn::And(is_open, cell.rejected);
    // Find the cells that hold roots of all rays: behind a stretch, halved, narrowed or rooted.
    const M<Real> all =
        hn::AndNot(cell.rejected, hn::And(hn::And(cell.continuous, inside), hn::And(begins, ends)));
    steps.root_behind = hn::And(is_open, all);
    const M<Real> first = hn::AndNot(is_open, all);
    steps.halved = hn::And(hn::AndNot(cell.monotone, first), hn::Gt(length, times(2.0, cell.fair)));
    const V<Real> turn = hn::IfThenElse(cell.kinked, number<Real>(most_turn_of(true)),
                                        number<Real>(most_turn_of(false)));
    const M<Real> coarse =
        hn::And(hn::Gt(cell.turn, turn), hn::Gt(length, times(3.0, hn::Add(width, cell.margin))));
    steps.narrowed = hn::AndNot(marks.has(MarkWords<Real>::calm),
                                hn::And(hn::AndNot(steps.halved, first), coarse));
    steps.rooted = hn::AndNot(hn::Or(steps.halved, steps.narrowed), first);
    // Shorten or lengthen cells with roots of some rays, or of none, or leave them open.
    const M<Real> others = hn::Not(hn::Or(cell.rejected, all));
    steps.shortened =
        hn::And(hn::And(cell.rough, others), hn::Gt(length, times(most_rough_lengths, cell.fair)));
    const M<Real> fits = hn::And(hn::Lt(cell.to, load(&fronts.end[i])),
                                 hn::Lt(width, times(most_fair_lengths, cell.fair)));
    // Nearly precise is enough for roots of all rays.
    const V<Real> longest = hn::Mul(times(2.0, cell.growth), length);
    const M<Real> too_long = hn::Gt(hn::Sub(cell.root_to, cell.from), longest);
    const M<Real> leaves = hn::AndNot(hn::Or(ends, too_long), hn::And(begins, cell.precise));
    steps.lengthened =
        hn::And(hn::AndNot(steps.shortened, others),
                hn::AndNot(marks.has(MarkWords<Real>::stretched), hn::And(leaves, fits)));
    steps.open = hn::AndNot(hn::Or(steps.shortened, steps.lengthened), others);
    return steps;
}

/// The part of a cell that may hold roots. At walls of the clip region this is the whole cell, as
/// stretches of its rays that begin and end at walls tell more.
template <class Real>
struct RootPart {
    V<Real> from, to;
};
template <class Real>
HWY_INLINE RootPart<Real> root_part_of(const FrontBlock<Real>& fronts, std::size_t i,
                                       const CellVerdict<Real>& cell) {
    const V<Real> begin = hn::Min(cell.from, load(&fronts.open_from[i]));
    const M<Real> at_walls = hn::Or(hn::Lt(begin, load(&fronts.inside_from[i])),
                                    hn::Gt(cell.to, load(&fronts.inside_to[i])));
    const V<Real> width = hn::Sub(cell.root_to, cell.root_from);
    const V<Real> from = hn::Min(hn::Max(cell.from, cell.root_from), cell.to);
    // Behind where the cell begins, or the search would stay there.
    const V<Real> onward = hn::Max(from, hn::Add(cell.from, cell.margin));
    const V<Real> to = hn::Max(onward, hn::MulAdd(number<Real>(0.25), width, cell.root_to));
    return {.from = hn::IfThenElse(at_walls, cell.from, from),
            .to = hn::IfThenElse(at_walls, cell.to, hn::Min(to, cell.to))};
}

/// Stretches that end with their cells, and where.
template <class Real>
struct Closed {
    M<Real> lanes;
    V<Real> to;
};
/// Sets the marks of stretches and roots; returns which stretches end.
template <class Real>
HWY_INLINE Closed<Real> mark_open(FrontBlock<Real>& fronts, std::size_t i,
                                  const CellVerdict<Real>& cell, const CellSteps<Real>& steps,
                                  MarkWords<Real>& marks) {
    const V<Real> open_from = load(&fronts.open_from[i]);
    const M<Real> is_open = hn::Lt(open_from, hn::Inf(d<Real>));
    const M<Real> begins = hn::AndNot(is_open, steps.open);
    const RootPart<Real> part = root_part_of(fronts, i, cell);
    store(hn::IfThenElse(begins, part.from, open_from), &fronts.open_from[i]);
    marks.count_cell(steps.open, begins);
    marks.set(MarkWords<Real>::continuous, steps.open,
              hn::And(cell.continuous, hn::Or(begins, marks.has(MarkWords<Real>::continuous))));
    const M<Real> kinked =
        hn::Or(cell.kinked, hn::AndNot(begins, marks.has(MarkWords<Real>::kinked)));
    marks.set(MarkWords<Real>::kinked, hn::Or(steps.open, steps.root_behind), kinked);
    const V<Real> end = load(&fronts.end[i]);
    const M<Real> last = hn::Or(hn::Ge(cell.to, end), hn::Lt(part.to, cell.to));
    const M<Real> full = marks.has(MarkWords<Real>::one_cell * most_open_cells);
    return {.lanes = hn::And(steps.open, hn::Or(full, last)), .to = part.to};
}

/// Takes what is known of the fronts' next cells; returns which fronts go on no more.
template <class Real>
HWY_INLINE M<Real> step(FrontBlock<Real>& fronts, std::size_t i, const CellVerdict<Real>& cell) {
    MarkWords<Real> marks(hn::LoadU(MarkWords<Real>::tag, &fronts.marks[i]));
    const CellSteps<Real> steps = steps_of(fronts, i, cell, marks);
    const M<Real> is_open = hn::Lt(load(&fronts.open_from[i]), hn::Inf(d<Real>));
    const V<Real> length = hn::Sub(cell.to, cell.from);
    const V<Real> width = hn::Sub(cell.root_to, cell.root_from);
    const auto where = [](M<Real> lanes, V<Real> yes, V<Real> no) {
        return hn::IfThenElse(lanes, yes, no);
    };

    const Closed<Real> closed = mark_open(fronts, i, cell, steps, marks);
    marks.set(MarkWords<Real>::stretched, hn::Or(hn::Or(steps.free, steps.open), steps.lengthened),
              steps.lengthened);
    marks.set(MarkWords<Real>::monotone, steps.rooted, cell.monotone);
    marks.set(MarkWords<Real>::kinked, steps.rooted, cell.kinked);

    // Find where the search goes on.
    const V<Real> quarter = hn::Add(hn::Mul(number<Real>(0.25), width), cell.margin);
    const V<Real> before = before_roots_of(fronts, i, cell);
    const V<Real> near =
        where(steps.narrowed, hn::Max(cell.from, hn::Sub(cell.root_from, quarter)), before);
    V<Real> at = where(hn::Or(steps.free, steps.open), cell.to, cell.from);
    const M<Real> shorter_or_longer = hn::Or(steps.shortened, steps.lengthened);
    const M<Real> tried_again = hn::Or(hn::Or(steps.halved, steps.narrowed), shorter_or_longer);
    at = where(hn::AndNot(is_open, tried_again), near, where(steps.rooted, cell.root_from, at));
    // Choose how long the next cell is.
    const V<Real> longer =
        hn::Min(hn::Max(cell.growth, number<Real>(1.0)), number<Real>(most_growth));
    const V<Real> precise = hn::Mul(number<Real>(0.95), cell.growth);
    const V<Real> shorter =
        hn::Min(hn::Max(precise, number<Real>(least_growth)), number<Real>(most_shortened));
    const V<Real> past_roots = hn::Sub(hn::Add(cell.root_to, quarter), near);
    V<Real> next = load(&fronts.step[i]);
    next = where(steps.free, hn::Mul(longer, length), next);
    next = where(steps.halved, hn::Mul(number<Real>(0.5), length), next);
    next = where(steps.narrowed, past_roots, next);
    next = where(steps.shortened, hn::Max(hn::Mul(shorter, length), cell.fair), next);
    next = where(steps.lengthened, past_roots, next);
    // Roots, and stretches that end; so far before the roots that the next cell holds them, too.
    const M<Real> edged = hn::Or(closed.lanes, hn::Or(steps.free_behind, steps.root_behind));
    const V<Real> before_roots =
        hn::Max(cell.from, hn::Sub(cell.root_from, hn::Add(width, cell.margin)));
    V<Real> to = load(&fronts.to[i]);
    to = where(steps.rooted, cell.root_to, to);
    to = where(closed.lanes, closed.to, to);
    to = where(steps.free_behind, cell.from, to);
    to = where(steps.root_behind, before_roots, to);
    at = where(edged, load(&fronts.open_from[i]), at);

    const V<Real> end = load(&fronts.end[i]);
    const M<Real> gone = hn::And(steps.free, hn::Ge(at, end));
    marks.set_state(FrontMarks::State::Gone, gone);
    marks.set_state(FrontMarks::State::Rooted, steps.rooted);
    marks.set_state(FrontMarks::State::Edged, edged);
    store(at, &fronts.at[i]);
    store(to, &fronts.to[i]);
    store(next, &fronts.step[i]);
    store(where(steps.rooted, cell.turn, load(&fronts.turn[i])), &fronts.turn[i]);
    hn::StoreU(marks.changed(), MarkWords<Real>::tag, &fronts.marks[i]);
    return hn::Or(gone, hn::Or(steps.rooted, edged));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
