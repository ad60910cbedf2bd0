#pragma once

#include "engine/real/field.hpp"
#include "engine/real/scalar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

// Helpers of fields that compute their answers in double, lane by lane, in any rounding mode.

namespace zeroset {

/// The relative error of one operation, in any rounding mode.
template <class Real>
inline constexpr Real unit_of = std::numeric_limits<Real>::epsilon();

/// [lo, hi].
struct ValueBounds {
    double lo = 0, hi = 0;

    [[nodiscard]] double size() const { return std::max(std::abs(lo), std::abs(hi)); }
    void add(const ValueBounds& other) {
        lo = std::min(lo, other.lo);
        hi = std::max(hi, other.hi);
    }
    [[nodiscard]] ValueBounds widened(double by) const { return {.lo = lo - by, .hi = hi + by}; }
};

/// Columns of an answer for one lane; bounds are stored as (-lo, hi), rounded outward.
template <class Real>
class AnswerLane {
public:
    AnswerLane(Real* out, int lanes, int lane) : out_(out + lane), lanes_(lanes) {}

    void set(std::size_t column, double value) { place(column) = static_cast<Real>(value); }
    void set_above(std::size_t column, double bound) { place(column) = upper_end(Real{}, bound); }
    void set(std::size_t column, const ValueBounds& bounds) {
        set_above(column, -bounds.lo);
        set_above(column + 1, bounds.hi);
    }
    void set_mask(std::size_t column, bool holds) { place(column) = holds ? Real{1} : Real{0}; }

private:
    Real& place(std::size_t column) { return out_[column * static_cast<std::size_t>(lanes_)]; }

    Real* out_;
    int lanes_;
};

/// Numbers from `column` of a question for one lane; with `sign` -1 their negatives.
template <class Real>
std::array<double, 3> question_lane(const Real* in, std::size_t column, int lanes, int lane,
                                    double sign = 1) {
    const auto number = [&](std::size_t i) {
        const auto at = (column + i) * static_cast<std::size_t>(lanes);
        return sign * static_cast<double>(in[at + static_cast<std::size_t>(lane)]);
    };
    return {number(0), number(1), number(2)};
}

/// The axes of a derivative of first or second order.
inline std::array<std::size_t, 2> axes_of(int derivative) {
    std::array<std::size_t, 2> axes{};
    std::size_t found = 0;
    const auto times = times_of(derivative);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int n = 0; n < times[axis] && found < 2; ++n)
            axes[found++] = axis;
    }
    return axes;
}

}  // namespace zeroset
