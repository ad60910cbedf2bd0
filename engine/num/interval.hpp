#pragma once

#include "engine/real/scalar.hpp"

#include <limits>

// Interval arithmetic, written once for every carrier (float, double, lanes of machine code).
//
// An interval [lo, hi] is stored as (-lo, hi). All of this must run in upward rounding: then both
// members round outward and the result encloses [Lambov08]. 0 * inf is 0 in the reals meant here
// (inf stands for any large number); the products below give the whole line instead, which is sound
// and costs less.
//
// The contract of every operation here, in elementary.hpp, periodic.hpp, odd_root.hpp, steps.hpp
// and enclosure.hpp:
//   proper     lo <= hi; members are numbers or +inf, which means has_no_bound: half lines and the
//              whole line are proper, a point at infinity is not. Proper operands give a proper
//              range wherever the function is defined somewhere.
//   empty      lo > hi, as of a box that was cut to nothing; or a range beside a false
//              Enclosure::somewhere. Its members mean nothing, as no point belongs to it.
//   unknown    NaN in both members, or in one beside +inf. Sums, multiples, powers and roots pass
//              it on; every other operation answers as for the whole line, or wider. So an unknown
//              operand never lets a box be rejected that the whole line would not: every
//              comparison with NaN fails.
// Multiplication by choosing factors by sign follows [Lambov08]. Where the structure of the formula
// proves a factor nonnegative (engine/algebra/facts.hpp), it needs 3 to 5 operations instead of 12.

namespace zeroset {

template <class Real>
struct Interval {
    Real neg_lo;
    Real hi;
};

inline constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Real>
Interval<Real> point(Real a) {
    return {-a, a};
}

template <class Real>
Interval<Real> whole_line(Real kind) {
    return {like(kind, infinity), like(kind, infinity)};
}

template <class Real>
Interval<Real> operator-(const Interval<Real>& a) {
    return {a.hi, a.neg_lo};
}

template <class Real>
Interval<Real> operator+(const Interval<Real>& a, const Interval<Real>& b) {
    return {a.neg_lo + b.neg_lo, a.hi + b.hi};
}

template <class Real>
Interval<Real> operator-(const Interval<Real>& a, const Interval<Real>& b) {
    return a + (-b);
}

template <class Mask, class Real>
Interval<Real> select(const Mask& condition, const Interval<Real>& if_true,
                      const Interval<Real>& if_false) {
    return {select(condition, if_true.neg_lo, if_false.neg_lo),
            select(condition, if_true.hi, if_false.hi)};
}

/// `a`, or the whole line where a member is NaN.
template <class Real>
Interval<Real> without_nan(const Interval<Real>& a) {
    return select(unordered(a.neg_lo, a.hi), whole_line(a.hi), a);
}

/// The larger of two upper bounds, +inf where one is NaN.
template <class Real>
Real larger_bound(const Real& p, const Real& q) {
    return select(unordered(p, q), like(p, infinity), maximum(p, q));
}

template <class Real>
Interval<Real> minimum(const Interval<Real>& a, const Interval<Real>& b) {
    // Where one operand is unknown, the other's upper bound still bounds min(a, b).
    const Real hi = minimum(a.hi, b.hi);
    return {larger_bound(a.neg_lo, b.neg_lo), minimum(hi, like(hi, infinity))};
}

template <class Real>
Interval<Real> maximum(const Interval<Real>& a, const Interval<Real>& b) {
    return -minimum(-a, -b);
}

template <class Real>
Interval<Real> operator*(const Interval<Real>& a, const Interval<Real>& b) {
    const Real b_lo = -b.neg_lo;
    const Real b_neg_hi = -b.hi;
    return {larger_bound(a.hi * select_negative(a.hi, b_neg_hi, b.neg_lo),
                         a.neg_lo * select_negative(a.neg_lo, b_lo, b.hi)),
            larger_bound(a.hi * select_negative(a.hi, b_lo, b.hi),
                         a.neg_lo * select_negative(a.neg_lo, b_neg_hi, b.neg_lo))};
}

/// a * b for a >= 0.
template <class Real>
Interval<Real> multiply_nonnegative_by(const Interval<Real>& a, const Interval<Real>& b) {
    const Real a_lo = -a.neg_lo;
    return without_nan(Interval<Real>{b.neg_lo * select_negative(b.neg_lo, a_lo, a.hi),
                                      b.hi * select_negative(b.hi, a_lo, a.hi)});
}

/// a * b for a >= 0 and b >= 0; -lo of the result is never above 0 either.
template <class Real>
Interval<Real> multiply_nonnegative(const Interval<Real>& a, const Interval<Real>& b) {
    const Real hi = a.hi * b.hi;
    return {a.neg_lo * -b.neg_lo, select(unordered(hi, hi), like(hi, infinity), hi)};
}

/// a * c for the exact number c, finite and not 0.
template <class Real>
Interval<Real> scale(const Interval<Real>& a, double c) {
    if (c < 0) return scale(-a, -c);
    const Real factor = like(a.hi, c);
    return {a.neg_lo * factor, a.hi * factor};
}

/// a * c for the enclosure c > 0 of a finite number.
template <class Real>
Interval<Real> scale(const Interval<Real>& a, const Interval<Real>& c, bool a_nonnegative) {
    const Real c_lo = -c.neg_lo;
    if (a_nonnegative) return {a.neg_lo * c_lo, a.hi * c.hi};
    return {a.neg_lo * select_negative(a.neg_lo, c_lo, c.hi),
            a.hi * select_negative(a.hi, c_lo, c.hi)};
}

/// The square of a >= 0.
template <class Real>
Interval<Real> square_nonnegative(const Interval<Real>& a) {
    return {a.neg_lo * -a.neg_lo, a.hi * a.hi};
}

/// |a|: max(|lo|, |hi|) is max(-lo, hi), as lo <= hi.
template <class Real>
Interval<Real> absolute(const Interval<Real>& a) {
    // minimum and maximum return their second argument where one is NaN.
    return {minimum(like(a.hi, 0.0), minimum(a.neg_lo, a.hi)), maximum(a.neg_lo, a.hi)};
}

/// a^n for a >= 0 and n >= 1.
template <class Real>
Interval<Real> power_nonnegative(const Interval<Real>& a, int n) {
    if (n == 1) return a;
    const Interval<Real> half = power_nonnegative(square_nonnegative(a), n / 2);
    return n % 2 == 0 ? half : multiply_nonnegative(half, a);
}

/// Upper bound of sign(h) |h|^n, whose size is rounded away from zero where h > 0, towards zero
/// otherwise: h |h| is such a bound, and so is one such bound times the size of another.
template <class Real>
Real signed_power_up(const Real& h, int n) {
    if (n == 1) return h;
    const Real half = signed_power_up(h * magnitude(h), n / 2);
    return n % 2 == 0 ? half : half * magnitude(h);
}

/// a^n for n >= 1; tight at even n.
template <class Real>
Interval<Real> power(const Interval<Real>& a, int n, bool a_nonnegative) {
    if (n == 1) return a;
    if (a_nonnegative) return power_nonnegative(a, n);
    if (n % 2 == 0) return power_nonnegative(absolute(a), n);
    return {signed_power_up(a.neg_lo, n), signed_power_up(a.hi, n)};
}

/// Where b surely does not contain 0, not even as an end.
template <class Real>
auto excludes_zero(const Interval<Real>& b) {
    const Real zero = like(b.hi, 0.0);
    return either(b.neg_lo < zero, b.hi < zero);
}
template <class Real>
auto contains_zero(const Interval<Real>& b) {
    return no(excludes_zero(b));
}

/// a / b: the whole line where 0 is inside b, a half line where b only touches 0.
template <class Real>
Interval<Real> operator/(const Interval<Real>& a, const Interval<Real>& b) {
    const Real zero = like(b.hi, 0.0);
    const auto b_negative = b.neg_lo > zero;  // b.lo < 0: divide -a by -b
    const Interval<Real> n = select(b_negative, -a, a);
    const Interval<Real> d = select(b_negative, -b, b);
    const Real d_lo = maximum(-d.neg_lo, zero);  // +0, never -0
    const Interval<Real> quotient{n.neg_lo / select_negative(n.neg_lo, d.hi, d_lo),
                                  n.hi / select_negative(n.hi, d.hi, d_lo)};
    // 0 is inside b, or b holds nothing but 0.
    const auto has_no_bound = either(both(b.neg_lo > zero, b.hi > zero), d.hi <= zero);
    return select(has_no_bound, whole_line(zero), without_nan(quotient));
}

/// a / b for b >= 0.
template <class Real>
Interval<Real> divide_by_nonnegative(const Interval<Real>& a, const Interval<Real>& b) {
    const Real zero = like(b.hi, 0.0);
    const Real b_lo = maximum(-b.neg_lo, zero);  // +0, never -0
    const Interval<Real> quotient{a.neg_lo / select_negative(a.neg_lo, b.hi, b_lo),
                                  a.hi / select_negative(a.hi, b.hi, b_lo)};
    const auto has_no_bound = either(unordered(quotient.neg_lo, quotient.hi), b.hi <= zero);
    return select(has_no_bound, whole_line(zero), quotient);
}

/// `gap` (enclosure.hpp) of a / b where 0 is inside b: every quotient is at most hi or at least
/// -neg_lo. The whole line where a may contain 0.
template <class Real>
Interval<Real> quotient_gap(const Interval<Real>& a, const Interval<Real>& b) {
    // Minus the least |a|, where a does not contain 0
    const Real neg_size = minimum(a.neg_lo, a.hi);
    const Real behind = neg_size / b.hi;
    const Real before = neg_size / b.neg_lo;
    const auto positive = a.neg_lo < like(a.hi, 0.0);
    const auto inside = both(b.neg_lo > like(a.hi, 0.0), b.hi > like(a.hi, 0.0));
    const auto known = no(unordered(a.neg_lo, a.hi));
    const auto usable = both(known, both(inside, neg_size < like(a.hi, 0.0)));
    return select(
        usable, Interval<Real>{select(positive, behind, before), select(positive, before, behind)},
        whole_line(a.hi));
}

/// Square root of the nonnegative part of a.
template <class Real>
Interval<Real> square_root(const Interval<Real>& a) {
    const Real zero = like(a.hi, 0.0);
    const Real lo = maximum(zero, -a.neg_lo);  // this order keeps NaN
    const Real up = square_root(lo);
    // `up` is the root rounded upward. It is exact where its square, rounded upward, is lo again;
    // otherwise `up` less one part in 2^22 (float) or 2^51 (double) is below the root.
    const Real below = up * like(up, -(1.0 - format_of(up).relative_gap));
    const Real neg_lo = select(up * up == lo, -up, below);
    return {neg_lo, square_root(maximum(zero, a.hi))};
}

}  // namespace zeroset
