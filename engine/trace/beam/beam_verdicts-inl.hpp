// The next cells of parts of rays, and what follows from their forms.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_VERDICTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_VERDICTS_INL
#undef ZEROSET_BEAM_VERDICTS_INL
#else
#define ZEROSET_BEAM_VERDICTS_INL
#endif

#include "engine/trace/beam/beam_cells-inl.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Conclusions from the forms of segments' next cells.
template <class Real>
struct Verdicts {
    /// The cells, as parts of the segments, and where in them f may vanish.
    std::vector<Real> begin, end, from, to;
    std::vector<Real> last;   ///< the ends of the segments
    std::vector<Real> guess;  ///< a guess of the root
    /// Where a switch may change, or not far from it.
    std::vector<Real> cut_from, cut_to;

    /// A bit for each segment of a vector.
    struct Bits {
        LaneBits rejected;   ///< there is no root in the cell
        LaneBits finished;   ///< rejected, and the segment ends with the cell
        LaneBits weak;       ///< the form says little: the natural interval extension is asked
        LaneBits monotone;   ///< f is continuous, with a slope that bends little
        LaneBits certain;    ///< if it is monotone, there is a root in the cell
        LaneBits contracts;  ///< a root may be in less than three fifths of the cell only
        LaneBits vanishes;   ///< f is surely 0 in all of the cell
        LaneBits cut;        ///< to be cut where a switch may change, see `cut_from`
    };
    std::vector<Bits> bits;

    explicit Verdicts(std::size_t capacity) : bits(capacity / lanes<Real>) {
        for (std::vector<Real>* column :
             {&begin, &end, &from, &to, &last, &guess, &cut_from, &cut_to})
            column->resize(capacity);
    }
    [[nodiscard]] bool bit(LaneBits Bits::* member, std::size_t i) const {
        return (bits[i / lanes<Real>].*member >> (i % lanes<Real>)&1U) != 0;
    }
    void set_bit(LaneBits Bits::* member, std::size_t i) {
        bits[i / lanes<Real>].*member |= LaneBits{1} << (i % lanes<Real>);
    }
    void reject(std::size_t i) { set_bit(&Bits::rejected, i); }
    /// A root is nowhere else in the cell than from `lo` to `hi`.
    void narrow(std::size_t i, Real lo, Real hi) {
        from[i] = std::max(from[i], lo);
        to[i] = std::min(to[i], hi);
        if (!(from[i] <= to[i])) return reject(i);
        guess[i] = std::clamp(guess[i], from[i], to[i]);
        constexpr auto much = static_cast<Real>(0.6);
        const bool contracts = to[i] - from[i] < much * (end[i] - begin[i]);
        if (contracts) set_bit(&Bits::contracts, i);
    }
};

/// The next cells of segments, and what their forms say.
template <class Real>
struct SegmentCells {
    CellPlaces<Real> places;
    Forms<Real> forms;
    Verdicts<Real> verdicts;

    explicit SegmentCells(std::size_t capacity) : verdicts(capacity) {
        places.resize(capacity);
        forms.resize(capacity);
    }
    /// Cell `at` becomes cell i of another list.
    void copy_cell(const SegmentCells& other, std::size_t i, std::size_t at) {
        places.u[at] = other.places.u[i];
        places.v[at] = other.places.v[i];
        places.s[at] = other.places.s[i];
        places.s_radius[at] = other.places.s_radius[i];
        verdicts.begin[at] = other.verdicts.begin[i];
        verdicts.end[at] = other.verdicts.end[i];
        verdicts.last[at] = other.verdicts.last[i];
    }
};

/// Where df/ds, which is from lo to -neg_hi, keeps its sign and bends little: Newton's method wants
/// both.
template <class Real>
M<Real> is_straight(V<Real> lo, V<Real> neg_hi) {
    constexpr Real most_bend = 16;  // slopes that differ by no more
    const V<Real> least = hn::Max(lo, neg_hi);
    const V<Real> most = hn::Neg(hn::Min(lo, neg_hi));
    return hn::And(hn::Gt(least, hn::Zero(d<Real>)),
                   hn::Le(most, hn::Mul(least, hn::Set(d<Real>, most_bend))));
}

/// Judges the cells of a vector, from cell i on. `finest`: segments are not made shorter.
template <class Real>
void judge_vector(SegmentCells<Real>& cells, std::size_t i, Real finest) {
    const Forms<Real>& forms = cells.forms;
    Verdicts<Real>& verdicts = cells.verdicts;
    constexpr auto three_fifths = static_cast<Real>(0.6);
    const auto load = [&](const std::vector<Real>& column) {
        return hn::LoadU(d<Real>, column.data() + i);
    };
    const auto mask = [&](const std::vector<ContinuityMask<Real>>& masks) {
        return mask_at(d<Real>, masks.data() + i);
    };
    const auto zero = hn::Zero(d<Real>);
    const auto c = load(forms.c);
    const auto k = load(forms.k[2]);
    const auto e = load(forms.e);
    const auto s = load(cells.places.s);
    const auto s_radius = load(cells.places.s_radius);
    const auto begin = load(verdicts.begin);
    const auto end = load(verdicts.end);
    // Where the linear part, widened by its error and the roundings here, may vanish.
    const auto sloped = hn::Gt(hn::Abs(k), zero);
    const auto inverse = hn::IfThenElseZero(sloped, hn::Div(s_radius, k));
    const auto middle = hn::NegMulAdd(c, inverse, s);
    const auto size = hn::Add(hn::Add(hn::Abs(s), hn::Abs(middle)), s_radius);
    const auto radius = hn::MulAdd(size, hn::Set(d<Real>, 8 * std::numeric_limits<Real>::epsilon()),
                                   hn::Mul(e, hn::Abs(inverse)));
    const auto lo = hn::Sub(middle, radius);
    const auto hi = hn::Add(middle, radius);
    const auto bounded = hn::And(sloped, hn::Le(lo, hi));  // false where NaN
    const auto from = hn::IfThenElse(bounded, hn::Max(begin, lo), begin);
    const auto to = hn::IfThenElse(bounded, hn::Min(end, hi), end);
    // Reject where the form excludes 0, f is nowhere defined, or no place is left.
    const auto far = hn::Gt(hn::Abs(c), hn::Add(hn::Abs(k), e));
    const auto rejected = hn::Or(hn::Or(far, mask(forms.nowhere)), hn::Gt(from, to));
    // Ask the natural interval extension where the form says little, or cannot get much better.
    const auto continuous = mask(forms.continuous);
    const auto known = hn::Le(e, hn::Set(d<Real>, std::numeric_limits<Real>::max()));
    const auto flat = hn::Eq(hn::Add(hn::Abs(c), hn::Abs(k)), zero);
    const auto length = hn::Sub(end, begin);
    const auto short_already = hn::Le(length, hn::Set(d<Real>, finest));
    const auto weak = hn::Or(flat, hn::Or(hn::Not(hn::And(continuous, known)), short_already));
    // Use Newton's method where df/ds keeps its sign and bends little.
    const auto rising = hn::Neg(load(forms.slope_neg_lo));
    const auto falling = hn::Neg(load(forms.slope_hi));
    const auto monotone = hn::And(continuous, is_straight<Real>(rising, falling));
    // Tell where there is a root: the linear part with its error vanishes within the cell.
    const auto certain = hn::And(bounded, hn::And(hn::Gt(lo, begin), hn::Lt(hi, end)));
    const auto contracts =
        hn::Lt(hn::Sub(to, from), hn::Mul(length, hn::Set(d<Real>, three_fifths)));
    const auto finished = hn::And(rejected, hn::Ge(end, load(verdicts.last)));
    hn::StoreU(from, d<Real>, verdicts.from.data() + i);
    hn::StoreU(to, d<Real>, verdicts.to.data() + i);
    hn::StoreU(hn::Min(hn::Max(middle, from), to), d<Real>, verdicts.guess.data() + i);
    verdicts.bits[i / lanes<Real>] = {.rejected = bits_of(d<Real>, rejected),
                                      .finished = bits_of(d<Real>, finished),
                                      .weak = bits_of(d<Real>, weak),
                                      .monotone = bits_of(d<Real>, monotone),
                                      .certain = bits_of(d<Real>, certain),
                                      .contracts = bits_of(d<Real>, contracts),
                                      .vanishes = 0,
                                      .cut = 0};
}

/// Judges `count` cells.
template <class Real>
void judge(SegmentCells<Real>& cells, std::size_t count, Real finest) {
    for (std::size_t i = 0; i < count; i += lanes<Real>)
        judge_vector(cells, i, finest);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
