// The steps of single rays on their ways from hits to the light, for vectors of rays.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_RAY_STEPS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_RAY_STEPS_INL
#undef ZEROSET_RAY_STEPS_INL
#else
#define ZEROSET_RAY_STEPS_INL
#endif

#include "engine/kernel/form_cells.hpp"
#include "engine/light/cell_verdicts-inl.hpp"
#include "engine/real/lanes-inl.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A word as wide as the numbers.
template <class Real>
using RayWord = hn::TFromD<hn::RebindToUnsigned<Tag<Real>>>;

/// The state of a ray on its way to the light, as bits.
struct RayMarks {
    static constexpr unsigned left = 1;      ///< the hit is behind what is searched next
    static constexpr unsigned positive = 2;  ///< f, at the end of what is searched next
    static constexpr unsigned negative = 4;
    static constexpr unsigned root = 8;       ///< the hit is a root of the surface's own function
    static constexpr unsigned unproved = 16;  ///< a part of the ray could not be decided
};

/// Rays on their ways. Plain data, nothing of it set at first.
template <class Real>
struct LightRayBlock {
    static constexpr std::size_t capacity = 256;
    static_assert(capacity % batch_multiple == 0);

    using Column = Real[capacity];
    using Words = RayWord<Real>[capacity];

    alignas(64) Column u, v, s;
    alignas(64) Column from, to;  ///< depths between which the search goes on
    alignas(64) Column step;      ///< of the next cell, in front of `to`, or of the hit
    alignas(64) Words pixel, marks;

    /// Copies a ray.
    void repeat(std::size_t i, std::size_t at) {
        for (Real* const column : {u, v, s, from, to, step})
            column[at] = column[i];
        pixel[at] = pixel[i];
        marks[at] = marks[i];
    }
    /// Puts those of a vector of rays whose bits are set to `at`, which is not behind it; returns
    /// how many these are.
    HWY_INLINE std::size_t keep(std::size_t i, LaneBits bits, std::size_t at) {
        const M<Real> kept = mask_of(d<Real>, bits);
        const auto kept_words = hn::RebindMask(du<Real>, kept);
        for (Real* const column : {u, v, s, from, to, step})
            hn::StoreU(hn::Compress(hn::Load(d<Real>, column + i), kept), d<Real>, column + at);
        for (RayWord<Real>* const words : {pixel, marks})
            hn::StoreU(hn::Compress(hn::Load(du<Real>, words + i), kept_words), du<Real>,
                       words + at);
        return static_cast<std::size_t>(std::popcount(bits));
    }
};

template <class Real>
struct RayRules {
    Real margin;     ///< cells are longer than their part of the ray
    Real finest;     ///< a cell that is no longer is not divided
    Real bias;       ///< from a hit that its surface only touches the search begins so far away
    bool is_member;  ///< of a union: hits are where f is 0 or above
};

/// Whether the marks of each lane have a bit.
template <class Real>
HWY_INLINE M<Real> has(hn::Vec<hn::RebindToUnsigned<Tag<Real>>> marks, unsigned bit) {
    const auto bits = hn::Set(du<Real>, static_cast<RayWord<Real>>(bit));
    return hn::RebindMask(d<Real>, hn::TestBit(marks, bits));
}

/// Where the next cells end.
template <class Real>
HWY_INLINE V<Real> next_of(const LightRayBlock<Real>& rays, std::size_t i, M<Real> left) {
    const V<Real> to = hn::Load(d<Real>, rays.to + i);
    const V<Real> end = hn::IfThenElse(left, to, hn::Min(to, hn::Load(d<Real>, rays.s + i)));
    return hn::Max(hn::Load(d<Real>, rays.from + i),
                   hn::Sub(end, hn::Load(d<Real>, rays.step + i)));
}

/// Sets the next cells of a vector of rays. In upward rounding.
template <class Real, std::size_t capacity>
HWY_INLINE void place_cells(const LightRayBlock<Real>& rays, const RayRules<Real>& rules,
                            std::size_t i, FormCells<Real, capacity>& cells) {
    const auto marks = hn::Load(du<Real>, rays.marks + i);
    const V<Real> to = hn::Load(d<Real>, rays.to + i);
    const V<Real> next = next_of(rays, i, has<Real>(marks, RayMarks::left));
    const V<Real> half = hn::Set(d<Real>, Real{0.5});
    const V<Real> middle = hn::MulAdd(half, next, hn::Mul(half, to));
    const V<Real> radius = hn::Max(hn::Sub(to, middle), hn::Sub(middle, next));
    hn::StoreU(hn::Load(d<Real>, rays.u + i), d<Real>, &cells.u[i]);
    hn::StoreU(hn::Load(d<Real>, rays.v + i), d<Real>, &cells.v[i]);
    hn::StoreU(middle, d<Real>, &cells.s[i]);
    hn::StoreU(hn::Add(radius, hn::Set(d<Real>, rules.margin)), d<Real>, &cells.s_radius[i]);
}

/// The hits of a vector of rays with these marks.
template <class Real>
HWY_INLINE HitsOfCell<VectorOfCells<Real>> hits_with(hn::Vec<hn::RebindToUnsigned<Tag<Real>>> marks,
                                                     bool is_member) {
    const M<Real> left = has<Real>(marks, RayMarks::left);
    const M<Real> at_root = hn::AndNot(left, has<Real>(marks, RayMarks::root));
    const M<Real> none = hn::AndNot(left, left);
    return {.behind = left,
            .left_falling = at_root,
            .left_rising = is_member ? none : at_root,
            .above = has<Real>(marks, RayMarks::positive),
            .below = has<Real>(marks, RayMarks::negative)};
}

/// Rays that ended, as bits: all, those of which there is something to tell, the dark ones.
struct RayEnds {
    LaneBits ended, told, dark;
};

/// Takes a vector of rays on by what their cells tell. In upward rounding.
template <class Real, std::size_t capacity>
HWY_INLINE RayEnds take_cells(LightRayBlock<Real>& rays, const RayRules<Real>& rules, std::size_t i,
                              const FormCells<Real, capacity>& cells) {
    // Halves of shorter cells might not be shorter in these numbers.
    constexpr Real least = 64 * std::numeric_limits<Real>::epsilon();
    const auto tag = du<Real>;
    const auto number = [](Real value) { return hn::Set(d<Real>, value); };
    const auto marks = hn::Load(tag, rays.marks + i);
    const auto f = line_of<VectorOfCells<Real>>(cells, i);
    const auto verdict = verdict_of(f, hits_with<Real>(marks, rules.is_member));
    const M<Real> left = has<Real>(marks, RayMarks::left);
    const V<Real> to = hn::Load(d<Real>, rays.to + i);
    const V<Real> step = hn::Load(d<Real>, rays.step + i);
    const V<Real> next = next_of(rays, i, left);
    const V<Real> length = hn::IfThenElse(left, hn::Sub(to, next), step);
    const V<Real> finest = hn::Max(number(rules.finest), hn::Mul(number(least), hn::Abs(to)));
    const M<Real> open = hn::Not(hn::Or(verdict.free, verdict.dark));
    const M<Real> halved = hn::And(open, hn::Gt(length, finest));
    const M<Real> passed = hn::AndNot(halved, open);
    // A root at the hit itself may be the hit.
    const M<Real> at_hit = hn::AndNot(left, hn::And(passed, has<Real>(marks, RayMarks::root)));
    const M<Real> seems_dark = hn::And(hn::AndNot(at_hit, passed), f.continuous);
    const M<Real> dark = hn::Or(verdict.dark, seems_dark);
    const M<Real> unproved = hn::Or(passed, has<Real>(marks, RayMarks::unproved));
    const M<Real> goes_on = hn::Not(hn::Or(halved, dark));

    const V<Real> s = hn::Load(d<Real>, rays.s + i);
    const V<Real> bias = number(rules.bias);
    const V<Real> on_to = hn::IfThenElse(at_hit, hn::Sub(s, bias), next);
    const V<Real> on_step = hn::IfThenElse(at_hit, bias, hn::Add(step, step));
    const V<Real> half = hn::Mul(number(Real{0.5}), length);
    hn::Store(hn::IfThenElse(goes_on, on_to, to), d<Real>, rays.to + i);
    hn::Store(hn::IfThenElse(goes_on, on_step, half), d<Real>, rays.step + i);
    const auto bits = [&](M<Real> lanes_set, unsigned bit) {
        return hn::IfThenElseZero(hn::RebindMask(tag, lanes_set),
                                  hn::Set(tag, static_cast<RayWord<Real>>(bit)));
    };
    const auto kept = hn::And(marks, hn::Set(tag, static_cast<RayWord<Real>>(RayMarks::root)));
    const auto signs = hn::Or(bits(verdict.positive, RayMarks::positive),
                              bits(verdict.negative, RayMarks::negative));
    const auto gone_on = hn::Or(hn::Or(kept, signs), bits(goes_on, RayMarks::left));
    const auto proof = bits(unproved, RayMarks::unproved);
    const auto of_rest = hn::IfThenElse(hn::RebindMask(tag, goes_on), gone_on, marks);
    hn::Store(hn::Or(of_rest, proof), tag, rays.marks + i);

    const M<Real> arrived = hn::AndNot(hn::Lt(hn::Load(d<Real>, rays.from + i), on_to), goes_on);
    const M<Real> ended = hn::Or(dark, arrived);
    return {.ended = bits_of(d<Real>, ended),
            .told = bits_of(d<Real>, hn::Or(dark, hn::And(arrived, unproved))),
            .dark = bits_of(d<Real>, dark)};
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
