#pragma once

#include "engine/noise/noise_cell.hpp"
#include "engine/real/field_answers.hpp"

#include <array>
#include <cstddef>

// The mean of the linear functions of a cell's corners and its derivatives of any order, at points
// and over parts of the cell: for second derivatives, which are asked for rarely.

namespace zeroset {

/// s and its derivatives at t.
struct Fade {
    explicit Fade(double t)
        : value(t * t * t * (t * (6 * t - 15) + 10)),
          slope(30 * (t * t) * ((1 - t) * (1 - t))),
          bend(60 * t * ((1 - t) * (1 - 2 * t))) {}

    double value, slope, bend;

    /// The derivative of order 0, 1 or 2.
    [[nodiscard]] double derivative(int order) const {
        return order == 0 ? value : order == 1 ? slope : bend;
    }
};

/// How often a mean is differentiated by each axis, the linear functions held fast.
using FadeOrders = std::array<int, 3>;

/// The numbers at the corners, weighted by s or its derivatives.
inline double mean_at(Corners numbers, const std::array<Fade, 3>& fades, const FadeOrders& orders) {
    for (std::size_t axis = 3; axis-- > 0;) {
        const std::size_t step = std::size_t{1} << axis;
        const double weight = fades[axis].derivative(orders[axis]);
        for (std::size_t c = 0; c < step; ++c) {
            const double moved = weight * (numbers[c + step] - numbers[c]);
            numbers[c] = orders[axis] == 0 ? numbers[c] + moved : moved;
        }
    }
    return numbers[0];
}

/// The ranges of s and its derivatives over [from, to] in [0, 1].
struct FadeRange {
    FadeRange(double from, double to);

    ValueBounds value, slope, bend;
};

/// A part of a cell.
struct CellPart {
    std::array<ValueBounds, 3> shares;
    std::array<FadeRange, 3> fades;
};

/// Encloses the mean of linear functions over a part of a cell, and its derivatives as mean_at.
class MeanOver {
public:
    MeanOver(const NoiseCell& cell, const CellPart& part) : cell_(cell), part_(part) {}

    /// The mean of the functions themselves.
    [[nodiscard]] ValueBounds of_functions(const FadeOrders& orders) const;
    /// The mean of their slopes along an axis.
    [[nodiscard]] ValueBounds of_slopes(std::size_t axis, const FadeOrders& orders) const;

private:
    struct Ends {
        Corners lo, hi;
    };
    [[nodiscard]] Ends ranges(const NoiseCell& cell, const FadeOrders& orders) const;
    [[nodiscard]] ValueBounds mean(Ends ends, const FadeOrders& orders) const;

    const NoiseCell& cell_;
    const CellPart& part_;
};

/// The sum of two, and of one to which a number times another is added.
inline ValueBounds operator+(const ValueBounds& a, const ValueBounds& b) {
    return {.lo = a.lo + b.lo, .hi = a.hi + b.hi};
}

}  // namespace zeroset
