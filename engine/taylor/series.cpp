#include "engine/taylor/series.hpp"

#include "engine/num/elementary.hpp"
#include "engine/real/unbounded.hpp"

#include <algorithm>
#include <cmath>

// Taylor's theorem: f(c + t) is the sum of f_k t^k up to the degree, and f_n(x) t^n with n one
// above it and x between c and c + t. The f_k at c are enclosed by intervals, whose radii go to the
// error, and |f_n| is bounded over [c - reach, c + reach].

namespace zeroset {
namespace {

using Range = Interval<double>;

constexpr std::size_t degree = patch_degree;
/// Angles larger than this are not worth a series.
constexpr double large_angle = 0x1p30;

using Terms = std::array<Range, degree + 1>;

constexpr Series none{.term = {}, .error = unbounded};

Range library(Elementary function, double x) {
    const double value = one_lane(function, x);
    return widened(function, value, value);
}

Range divided(const Range& a, double positive) {
    return {.neg_lo = a.neg_lo / positive, .hi = a.hi / positive};
}

/// `highest`: a bound of |f_n|.
Series assembled(const Terms& terms, double highest, double reach) {
    Series series{.term = {}, .error = 0.0};
    double power = 1.0;
    for (std::size_t k = 0; k <= degree; ++k) {
        const Range& range = terms[k];
        const double middle = 0.5 * (range.hi - range.neg_lo);
        series.term[k] = middle;
        series.error += std::max(range.hi - middle, middle + range.neg_lo) * power;
        power *= reach;
    }
    series.error += highest * power;
    if (!(series.error < unbounded)) return none;
    return series;
}

/// f_k / k! from derivatives that repeat after four.
Terms over_factorials(const std::array<Range, 4>& derivatives) {
    Terms terms;
    double factorial = 1.0;
    for (std::size_t k = 0; k <= degree; ++k) {
        if (k > 0) factorial *= static_cast<double>(k);
        terms[k] = divided(derivatives[k % 4], factorial);
    }
    return terms;
}

constexpr double next_factorial = [] {
    double product = 1.0;
    for (std::size_t k = 2; k <= degree + 1; ++k)
        product *= static_cast<double>(k);
    return product;
}();

Series wave_series(Op op, double c, double reach) {
    if (!(std::abs(c) <= large_angle)) return none;
    const Range s = clamped(library(Elementary::Sin, c), -1.0, 1.0);
    const Range co = clamped(library(Elementary::Cos, c), -1.0, 1.0);
    const Terms terms =
        op == Op::Sin ? over_factorials({s, co, -s, -co}) : over_factorials({co, -s, -co, s});
    return assembled(terms, 1.0 / next_factorial, reach);
}

Series exp_series(double c, double reach) {
    const Range value = library(Elementary::Exp, c);
    const double highest = exp(Range{.neg_lo = -(c + reach), .hi = c + reach}).hi;
    return assembled(over_factorials({value, value, value, value}), highest / next_factorial,
                     reach);
}

Series hyperbolic_series(Op op, double c, double reach) {
    const Range up = library(Elementary::Exp, c);
    const Range down = library(Elementary::Exp, -c);
    const Range s = divided(up - down, 2.0);
    const Range co = divided(up + down, 2.0);
    const double far = std::abs(c) + reach;
    // cosh is below exp of the size.
    const double highest = exp(Range{.neg_lo = -far, .hi = far}).hi;
    const Terms terms =
        op == Op::Sinh ? over_factorials({s, co, s, co}) : over_factorials({co, s, co, s});
    return assembled(terms, highest / next_factorial, reach);
}

/// A bound of 1 / |x| for |x - c| <= reach; +inf where 0 is among them.
double most_reciprocal(double c, double reach) {
    const double neg_least = reach - std::abs(c);
    return neg_least < 0.0 ? 1.0 / -neg_least : unbounded;
}

double whole_power(double x, std::size_t n) {
    double power = 1.0;
    for (std::size_t k = 0; k < n; ++k)
        power *= x;
    return power;
}

Range reciprocal(double c) { return point(1.0) / point(c); }

Series log_series(Op op, double c, double reach) {
    const double most = most_reciprocal(c, reach);
    if (!(c > 0.0) || !(most < unbounded)) return none;
    const Elementary function = op == Op::Log     ? Elementary::Log
                                : op == Op::Log10 ? Elementary::Log10
                                                  : Elementary::Log2;
    // The slope of the logarithm at 1: 1 / ln(base).
    const Range scale = op == Op::Log
                            ? point(1.0)
                            : point(1.0) / library(Elementary::Log, op == Op::Log10 ? 10.0 : 2.0);
    Terms terms;
    terms[0] = library(function, c);
    const Range per_c = reciprocal(c);
    Range power = scale;
    for (std::size_t k = 1; k <= degree; ++k) {
        power = power * per_c;
        const Range term = divided(power, static_cast<double>(k));
        terms[k] = k % 2 == 0 ? -term : term;
    }
    const double highest =
        scale.hi * whole_power(most, degree + 1) / static_cast<double>(degree + 1);
    return assembled(terms, highest, reach);
}

Series sqrt_series(double c, double reach) {
    const double most = most_reciprocal(c, reach);
    if (!(c > 0.0) || !(most < unbounded)) return none;
    const Range per_c = reciprocal(c);
    Terms terms;
    terms[0] = square_root(point(c));
    double highest = 1.0;
    for (std::size_t k = 0; k <= degree; ++k) {
        const double factor = 0.5 - static_cast<double>(k);
        const double count = static_cast<double>(k) + 1.0;
        highest = highest * std::abs(factor) / count;
        if (k < degree)
            terms[k + 1] =
                divided(factor < 0.0 ? scale(-terms[k], -factor) : scale(terms[k], factor), count) *
                per_c;
    }
    // x^(1/2 - n) is largest at the least x.
    return assembled(terms, highest * whole_power(most, degree) * std::sqrt(most), reach);
}

Series atan_series(double c, double reach) {
    // w(t) = 1 / (1 + (c + t)^2) is the slope: (1 + c^2) w_k + 2 c w_(k-1) + w_(k-2) = 0.
    const Range per = point(1.0) / (point(1.0) + power(point(c), 2, false));
    const Range twice = point(2.0 * c);
    Terms terms;
    terms[0] = library(Elementary::Atan, c);
    Range before = point(0.0);
    Range w = per;
    for (std::size_t k = 1; k <= degree; ++k) {
        terms[k] = divided(w, static_cast<double>(k));
        const Range next = -((twice * w + before) * per);
        before = w;
        w = next;
    }
    // The n-th derivative of atan is at most (n - 1)!.
    return assembled(terms, 1.0 / static_cast<double>(degree + 1), reach);
}

}  // namespace

Series reciprocal_series(double c, double reach) {
    const double most = most_reciprocal(c, reach);
    if (!(most < unbounded)) return none;
    const Range per_c = reciprocal(c);
    Terms terms;
    terms[0] = per_c;
    for (std::size_t k = 1; k <= degree; ++k)
        terms[k] = -(terms[k - 1] * per_c);
    return assembled(terms, whole_power(most, degree + 2), reach);
}

bool has_series(Op op) {
    return op == Op::Sqrt || op == Op::Exp || op == Op::Log || op == Op::Log10 || op == Op::Log2 ||
           op == Op::Sin || op == Op::Cos || op == Op::Atan || op == Op::Sinh || op == Op::Cosh;
}

Series series_of(Op op, double c, double reach) {
    if (!std::isfinite(c) || !(reach < unbounded)) return none;
    if (op == Op::Sin || op == Op::Cos) return wave_series(op, c, reach);
    if (op == Op::Exp) return exp_series(c, reach);
    if (op == Op::Sinh || op == Op::Cosh) return hyperbolic_series(op, c, reach);
    if (op == Op::Log || op == Op::Log10 || op == Op::Log2) return log_series(op, c, reach);
    if (op == Op::Sqrt) return sqrt_series(c, reach);
    return op == Op::Atan ? atan_series(c, reach) : none;
}

}  // namespace zeroset
