#pragma once

#include "engine/algebra/beam_algebra.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/real/block.hpp"
#include "engine/tape/tape.hpp"

#include <cstdint>
#include <new>
#include <optional>

// Choices over blocks of cells: how they fall, and forms of what they come to.

namespace zeroset {

/// The cells where the condition holds; all where it is absent.
inline unsigned bits_of(const std::optional<BlockMask>& mask) { return mask ? mask->bits : ~0U; }

inline ChoiceBits choice_bits(unsigned first, unsigned second) {
    return {.first = static_cast<std::uint16_t>(first),
            .second = static_cast<std::uint16_t>(second)};
}

inline ChoiceBits joined(const ChoiceBits& a, const ChoiceBits& b) {
    return choice_bits(unsigned{a.first} | b.first, unsigned{a.second} | b.second);
}

/// Where one operand of min or max may stand for both, as in the band of values that matter: one
/// above it leaves min to the other one, one below it max.
template <class Lanes>
[[gnu::flatten]] ChoiceBits choice_by_band(Op op, const BeamValue<Lanes>& a,
                                           const BeamValue<Lanes>& b, const Band& band) {
    const bool max = op == Op::Max;
    const double end = max ? -band.lo : band.hi;  // rounded upward where it is made a float
    if (end == infinity) return {};
    const auto left_out = [&](const BeamValue<Lanes>& x) {
        const Interval<Lanes> range = x.f.range();
        const BlockMask apart = (max ? -range.hi : -range.neg_lo) > like(range.hi, end);
        return apart.bits & bits_of(x.everywhere);
    };
    return choice_bits(left_out(b), left_out(a));
}

/// Where `if` or `where` is one of its alternatives: the condition must be defined.
template <class Lanes>
ChoiceBits choice_by_condition(Op op, const BeamValue<Lanes>& condition) {
    const unsigned defined = bits_of(condition.everywhere);
    const Interval<Lanes> range = condition.f.range();
    const unsigned holds = no(may_fail(range)).bits & defined;
    return choice_bits(holds, op == Op::If ? no(may_hold(range)).bits & defined : 0U);
}

/// Where `and` or `or` is one of its operands, as the other one is known to be true or false: that
/// must be defined, too.
template <class Lanes>
ChoiceBits choice_by_logic(Op op, const BeamValue<Lanes>& a, const BeamValue<Lanes>& b) {
    const Interval<Lanes> first = a.f.range();
    const Interval<Lanes> second = b.f.range();
    const unsigned a_holds = no(may_fail(first)).bits;
    const unsigned a_fails = no(may_hold(first)).bits;
    const unsigned b_holds = no(may_fail(second)).bits;
    const unsigned b_fails = no(may_hold(second)).bits;
    const bool all = op == Op::And;
    return choice_bits((all ? a_fails | b_holds : a_holds | b_fails) & bits_of(b.everywhere),
                       (all ? b_fails | a_holds : b_holds | a_fails) & bits_of(a.everywhere));
}

/// Where min, max or the smooth minimum is one of its operands, from the range of a - b: the other
/// one must be defined, too.
template <class Lanes>
ChoiceBits choice_by_size(Op op, const Interval<Lanes>& difference, const BeamValue<Lanes>& a,
                          const BeamValue<Lanes>& b) {
    const unsigned a_defined = bits_of(a.everywhere);
    const unsigned b_defined = bits_of(b.everywhere);
    if (op == Op::SmoothMin) {
        const auto [first, second] = blend_sides(difference);
        return choice_bits(first.bits & b_defined, second.bits & a_defined);
    }
    const Lanes zero = like(difference.hi, 0.0);
    const unsigned a_is_larger = (difference.neg_lo <= zero).bits;
    const unsigned b_is_larger = (difference.hi <= zero).bits;
    return choice_bits((op == Op::Max ? a_is_larger : b_is_larger) & b_defined,
                       (op == Op::Max ? b_is_larger : a_is_larger) & a_defined);
}

/// Lanes that stand for one of the operands as if it were surely the larger or smaller one.
template <class Lanes>
Kink<Lanes> decided_kink(const Interval<Lanes>& difference, unsigned above, unsigned below) {
    Kink<Lanes> kink = kink_of(difference);
    const Lanes one = like(difference.hi, 1.0);
    const BlockMask up{static_cast<std::uint16_t>(above)};
    const BlockMask down{static_cast<std::uint16_t>(below & ~above)};
    kink.alpha = select(up, one, select(down, -one, kink.alpha));
    kink.rest = select(either(up, down), like(one, 0.0), kink.rest);
    kink.above = either(both(kink.above, no(down)), up);
    kink.below = either(both(kink.below, no(up)), down);
    return kink;
}

/// Copies a or b to `place` if the other one is left out in all lanes, and tells whether it did:
/// quicker than choosing lane by lane.
template <class Lanes>
bool copied(const ChoiceBits& bits, const Operand<BeamValue<Lanes>>& a,
            const Operand<BeamValue<Lanes>>& b, BeamValue<Lanes>* place) {
    constexpr unsigned all = (1U << Lanes::lanes) - 1U;
    const bool first = (bits.first & all) == all;
    if (!first && (bits.second & all) != all) return false;
    new (place) BeamValue<Lanes>(first ? a.value : b.value);
    return true;
}

/// Makes min, max or the smooth minimum of a and b in `place` and tells where it is one of them, or
/// taken for it as `left_out` tells.
template <class Lanes>
[[gnu::flatten]] ChoiceBits make_extreme(BeamAlgebra<Lanes>& algebra, Op op,
                                         const Operand<BeamValue<Lanes>>& a,
                                         const Operand<BeamValue<Lanes>>& b,
                                         const ChoiceBits& left_out, BeamValue<Lanes>* place) {
    if (copied(left_out, a, b, place)) return left_out;
    const Beam<Lanes> difference = a.value.f - b.value.f;
    const Interval<Lanes> range = difference.range();
    const ChoiceBits bits = joined(left_out, choice_by_size(op, range, a.value, b.value));
    if (copied(bits, a, b, place)) return bits;
    if (op == Op::SmoothMin) {
        const unsigned only_second = bits.second & ~unsigned{bits.first};
        const BlendSides<BlockMask> sides{
            .first = BlockMask{bits.first},
            .second = BlockMask{static_cast<std::uint16_t>(only_second)}};
        new (place) BeamValue<Lanes>(algebra.blend(a, b, difference, sides));
        return bits;
    }
    const bool max = op == Op::Max;
    const auto kink =
        decided_kink(range, max ? bits.first : bits.second, max ? bits.second : bits.first);
    new (place) BeamValue<Lanes>(algebra.larger(a, b, kink, max ? 1.0 : -1.0));
    return bits;
}

/// Where the form of a function that is from 0 to `height` is wider than that, it is that.
template <class Lanes>
void narrow_to(double height, BeamValue<Lanes>& value) {
    const Lanes half = like(value.f.r, 0.5 * height);  // rounded upward
    const Affine<Lanes> whole{half, {}, half};
    value.f = {select(no(value.f.f.e <= half), whole, value.f.f), value.f.r, value.f.size};
}

}  // namespace zeroset
