#pragma once

#include "engine/num/interval.hpp"
#include "papers/along_rays/stretch.hpp"

#include <cmath>

// The interval Newton operator N(T) = m - F(m) / F'(T), with m the middle of T. In upward rounding.

namespace zeroset {

/// N(T) and T for 0 outside F'(T): all roots in T are in both. Divides what is left where it is not
/// much shorter than T.
inline void take_newton_step(const Stretch& t, const Interval<double>& f_middle,
                             const Interval<double>& slope, TaskOutcome& outcome) {
    const Interval<double> n = point(t.middle()) - f_middle / slope;
    Stretch left = t;
    if (-n.neg_lo > t.from)
        left = {.from = -n.neg_lo,
                .to = left.to,
                .from_sign = EndSign::NotAsked,
                .to_sign = left.to_sign};
    if (n.hi < t.to)
        left = {.from = left.from,
                .to = n.hi,
                .from_sign = left.from_sign,
                .to_sign = EndSign::NotAsked};
    if (!(left.from <= left.to)) return outcome.reject();
    constexpr double much = 0.5;
    if (left.width() <= much * t.width()) return outcome.narrow(left);
    outcome.bisect(left);
}

/// The step for 0 inside F'(T) and outside F(m): the parts of T on both sides of m that are left
/// [Caprani00]. A ray whose slope is not known keeps both halves.
inline void take_alefeld_hansen_step(const Stretch& t, const Interval<double>& f_middle,
                                     const Interval<double>& slope, TaskOutcome& outcome) {
    const double m = t.middle();
    const bool is_above = f_middle.neg_lo < 0.0;
    const double neg_size = is_above ? f_middle.neg_lo : f_middle.hi;  // minus the least |F(m)|
    // Towards smaller s f falls at most by the slope's upper end, and rises by its lower one.
    // Neither end is below 0; as a divisor it is never -0.
    const double front_slope = std::abs(is_above ? slope.hi : slope.neg_lo);
    const double behind_slope = std::abs(is_above ? slope.neg_lo : slope.hi);
    const double front_end = m + neg_size / front_slope;
    const double neg_behind = neg_size / behind_slope - m;
    const bool front = front_end >= t.from;
    const bool behind = -neg_behind <= t.to;
    const Stretch front_part{
        .from = t.from, .to = front_end, .from_sign = t.from_sign, .to_sign = EndSign::NotAsked};
    const Stretch behind_part{
        .from = -neg_behind, .to = t.to, .from_sign = EndSign::NotAsked, .to_sign = t.to_sign};
    if (front && behind) return outcome.divide(front_part, behind_part);
    if (front) return outcome.narrow(front_part);
    if (behind) return outcome.narrow(behind_part);
    outcome.reject();
}

}  // namespace zeroset
