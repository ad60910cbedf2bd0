#pragma once

#include "engine/num/interval.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <type_traits>

namespace zeroset::test {

/// Numbers and intervals that are likely to find faults, equal for equal seeds on every machine.
/// Use it in round-to-nearest.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

    std::uint64_t bits() { return engine_(); }
    /// A number from 0 to count - 1.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }
    int between(int first, int last) {
        return first + static_cast<int>(below(static_cast<std::size_t>(last - first + 1)));
    }
    bool one_in(std::size_t count) { return below(count) == 0; }
    /// A number in [0, 1).
    double uniform() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }
    double uniform(double lo, double hi) { return lo + uniform() * (hi - lo); }

    /// Any finite number of the type, often a critical one.
    template <class Real>
    Real number() {
        switch (below(12)) {
            case 0: return one_in(2) ? Real(0) : -Real(0);
            case 1: return nudged(Real(between(-9, 9)));
            case 2: return nudged(static_cast<Real>(between(-40, 40) * (0.5 * std::numbers::pi)));
            case 3: return nudged(one_in(2) ? Real(1) : Real(-1));
            case 4: return static_cast<Real>(between(-9, 9)) * smallest_denormal<Real>();
            case 5: return any_bits<Real>();
            case 6: return nudged(static_cast<Real>(std::ldexp(1.0, between(-20, 20))));
            case 7: return static_cast<Real>(uniform(-1000, 1000));
            case 8:
            case 9: return static_cast<Real>(uniform(-2, 2));
            default: return static_cast<Real>(uniform(-20, 20));
        }
    }

    /// An interval without NaN and with lo <= hi, now and then infinite.
    template <class Real>
    Interval<Real> interval() {
        const Real infinite = std::numeric_limits<Real>::infinity();
        const Real a = number<Real>();
        switch (below(16)) {
            case 0: return {-a, a};
            case 1: return {-a, one_in(2) ? infinite : std::numeric_limits<Real>::max()};
            case 2: return {one_in(2) ? infinite : std::numeric_limits<Real>::max(), a};
            case 3: return one_in(4) ? whole_line(a) : between_ends(Real(0), a);
            case 4: return between_ends(-Real(0), a);
            case 5:
            case 6: return between_ends(a, nudged(a));
            case 7:
            case 8: return between_ends(a, a + a * Real(uniform(0, 0.01)));
            case 9: return between_ends(a, a + Real(uniform(0, 7)));
            default: return between_ends(a, number<Real>());
        }
    }

    /// A real number in the box, as a double: an end, a critical place or any other.
    template <class Real>
    double point_in(const Interval<Real>& box) {
        const auto largest = std::numeric_limits<double>::max();
        const double lo = std::max(-static_cast<double>(box.neg_lo), -largest);
        const double hi = std::min(static_cast<double>(box.hi), largest);
        switch (below(10)) {
            case 0: return lo;
            case 1: return hi;
            case 2: return std::clamp(0.0, lo, hi);
            case 3: return std::clamp(one_in(2) ? 1.0 : -1.0, lo, hi);
            case 4: return std::clamp(0.5 * std::numbers::pi * between(-40, 40), lo, hi);
            case 5: return std::clamp(static_cast<double>(number<Real>()), lo, hi);
            case 6: return std::clamp(number<double>(), lo, hi);
            case 7: return std::clamp(std::nextafter(one_in(2) ? lo : hi, 0.0), lo, hi);
            default: {
                const double t = uniform();
                return std::clamp(lo * (1 - t) + hi * t, lo, hi);
            }
        }
    }

    /// `a`, moved by up to three neighbours.
    template <class Real>
    Real nudged(Real a) {
        const Real towards =
            one_in(2) ? std::numeric_limits<Real>::max() : std::numeric_limits<Real>::lowest();
        for (int steps = between(0, 3); steps > 0; --steps)
            a = std::nextafter(a, towards);
        return a;
    }

private:
    template <class Real>
    static Real smallest_denormal() {
        return std::numeric_limits<Real>::denorm_min();
    }

    template <class Real>
    Real any_bits() {
        using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
        const Real value = std::bit_cast<Real>(static_cast<Bits>(bits()));
        return std::isfinite(value) ? value : std::numeric_limits<Real>::max();
    }

    template <class Real>
    static Interval<Real> between_ends(Real a, Real b) {
        if (a > b) std::swap(a, b);
        return {-a, b};
    }

    std::mt19937_64 engine_;
};

}  // namespace zeroset::test
