#pragma once

#include "engine/num/dual.hpp"
#include "engine/num/elementary.hpp"

// ln(e^a + e^b) over any carrier: max(a, b) + ln(1 + e^-|a - b|), where nothing overflows.

namespace zeroset {

/// Of operands that are apart by d >= 0.
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

/// How far `rest`, a share of it or its like is off at most, in any rounding mode: each comes from
/// an exponential by few roundings.
template <class Real>
Real log_sum_error(const Real& value) {
    const Format& format = format_of(value);
    constexpr double ulp = 10.0;
    return value * like(value, 0.5 * ulp * format.relative_gap) +
           like(value, format.smallest_normal);
}

/// In upward rounding.
template <class Real>
Interval<Real> log_sum(const Interval<Real>& a, const Interval<Real>& b) {
    const auto number = [&](double value) { return like(a.hi, value); };
    // The differences of the ends, rounded up either way.
    const Real above = a.hi - b.hi;
    const Real below = b.hi - a.hi;
    const Real least = maximum(-above, -below);
    const Real highest = log_sum_rest(select(unordered(above, below), number(0), least)).rest;
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
