#pragma once

#include "engine/num/dual.hpp"
#include "engine/num/elementary.hpp"

// ln(e^a + e^b) over any carrier, as max(a, b) + ln(1 + e^-|a - b|), in which nothing overflows.

namespace zeroset {

/// Terms of ln(e^a + e^b) for operands that differ by d >= 0.
template <class Real>
struct LogSumRest {
    Real ratio;  ///< e^-d
    Real rest;   ///< ln(1 + e^-d)
};

template <class Real>
LogSumRest<Real> log_sum_rest(const Real& d) {
    const Real ratio = elementary(Elementary::Exp, -d);
    const Real half = elementary(Elementary::Atanh, ratio / (ratio + like(d, 2.0)));
    return {ratio, half + half};
}

/// Error bound of `rest`, of a share or of a similar term `value`, in any rounding mode: each comes
/// from an exponential by few roundings.
template <class Real>
Real log_sum_error(const Real& value) {
    const Format& format = format_of(value);
    constexpr double ulp = 10.0;
    return value * like(value, 0.5 * ulp * format.relative_gap) +
           like(value, format.smallest_normal);
}

/// Range of ln(e^a + e^b), in upward rounding.
template <class Real>
Interval<Real> log_sum(const Interval<Real>& a, const Interval<Real>& b) {
    const auto number = [&](double value) { return like(a.hi, value); };
    // Differences of the upper ends in both directions, rounded upward.
    const Real above = a.hi - b.hi;
    const Real below = b.hi - a.hi;
    const Real least = maximum(-above, -below);
    const Real highest = log_sum_rest(select(unordered(above, below), number(0), least)).rest;
    // Differences of the lower ends in both directions, rounded upward.
    const Real above_lo = b.neg_lo - a.neg_lo;
    const Real below_lo = a.neg_lo - b.neg_lo;
    const Real most = maximum(above_lo, below_lo);
    const Real lowest =
        log_sum_rest(select(unordered(above_lo, below_lo), number(infinity), most)).rest;
    const Real larger_hi = select(unordered(above, below), number(infinity), maximum(a.hi, b.hi));
    return without_nan(
        Interval<Real>{minimum(a.neg_lo, b.neg_lo) + (log_sum_error(lowest) - lowest),
                       larger_hi + (highest + log_sum_error(highest))});
}

template <class Real>
Dual<Real> log_sum(const Dual<Real>& a, const Dual<Real>& b) {
    const auto [ratio, rest] = log_sum_rest(magnitude(a.value - b.value));
    const Real larger = like(ratio, 1.0) / (ratio + like(ratio, 1.0));
    const Real smaller = ratio * larger;
    const auto first = a.value >= b.value;
    return chain(select(first, a.value, b.value) + rest, select(first, larger, smaller), a,
                 select(first, smaller, larger), b);
}

}  // namespace zeroset
