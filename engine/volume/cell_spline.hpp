#pragma once

#include "engine/volume/trilinear.hpp"

#include <array>
#include <cstddef>

// A cubic B-spline in one cell: its Bernstein coefficients over a part of the cell, which enclose
// it there. The same as ControlPoints for one cell, with fixed sizes, so that it is fast.

namespace zeroset {

/// Weights of `inputs` coefficients in each of `outputs` others.
template <std::size_t outputs, std::size_t inputs>
using Weights = std::array<std::array<double, inputs>, outputs>;

/// The Bernstein coefficients of a cubic from `a` to `b` in [0, 1]: its blossom at a and b.
inline Weights<4, 4> cubic_weights(double a, double b) {
    const auto row = [](double u, double v, double w) {
        const double product = u * v * w;
        const double pairs = u * (v + w) + v * w;
        return std::array{(1 - u) * (1 - v) * (1 - w) / 6, (3 * product - 2 * pairs + 4) / 6,
                          (pairs - 3 * product + (u + v + w) + 1) / 6, product / 6};
    };
    return {row(a, a, a), row(a, a, b), row(a, b, b), row(b, b, b)};
}
/// The Bernstein coefficients of the slope, from the differences of the coefficients.
inline Weights<3, 3> slope_weights(double a, double b) {
    const auto row = [](double u, double v) {
        return std::array{(1 - u) * (1 - v) / 2, (1 + u + v - 2 * u * v) / 2, u * v / 2};
    };
    return {row(a, a), row(a, b), row(b, b)};
}

/// A block of count^... numbers, along whose middle axis of three the sums are formed: `outer`
/// blocks of `inputs` lines of `inner` numbers each become lines of `outputs`.
template <std::size_t outer, std::size_t inner, std::size_t outputs, std::size_t inputs>
std::array<double, outer * outputs * inner> weighted(
    const std::array<double, outer * inputs * inner>& from,
    const Weights<outputs, inputs>& weights) {
    std::array<double, outer * outputs * inner> to;
    for (std::size_t block = 0; block < outer; ++block) {
        const double* const in = &from[block * inputs * inner];
        double* const out = &to[block * outputs * inner];
        for (std::size_t row = 0; row < outputs; ++row) {
            for (std::size_t i = 0; i < inner; ++i) {
                double sum = weights[row][0] * in[i];
                for (std::size_t n = 1; n < inputs; ++n)
                    sum += weights[row][n] * in[n * inner + i];
                out[row * inner + i] = sum;
            }
        }
    }
    return to;
}
/// The differences of neighbours along that axis.
template <std::size_t outer, std::size_t inner>
std::array<double, outer * 3 * inner> differences(
    const std::array<double, outer * 4 * inner>& from) {
    std::array<double, outer * 3 * inner> to;
    for (std::size_t block = 0; block < outer; ++block) {
        for (std::size_t i = 0; i < 3 * inner; ++i)
            to[block * 3 * inner + i] =
                from[block * 4 * inner + inner + i] - from[block * 4 * inner + i];
    }
    return to;
}
template <std::size_t count>
ValueBounds hull_of(const std::array<double, count>& values) {
    ValueBounds hull{.lo = values[0], .hi = values[0]};
    for (const double value : values) {
        hull.lo = value < hull.lo ? value : hull.lo;
        hull.hi = value > hull.hi ? value : hull.hi;
    }
    return hull;
}

/// The 4^3 coefficients about a cell, i running fastest.
using CellCoefficients = std::array<double, 64>;

/// Encloses a spline and its slopes, but for rounding, over the part of a cell from `from` to `to`.
struct CellRange {
    ValueBounds value;
    std::array<ValueBounds, 3> slopes;
};
inline CellRange range_in_cell(const CellCoefficients& all, const std::array<double, 3>& from,
                               const std::array<double, 3>& to) {
    const auto in_x = cubic_weights(from[0], to[0]);
    const auto in_y = cubic_weights(from[1], to[1]);
    const auto in_z = cubic_weights(from[2], to[2]);
    const auto z = weighted<1, 16>(all, in_z);
    const auto yz = weighted<4, 4>(z, in_y);
    CellRange range;
    range.value = hull_of(weighted<16, 1>(yz, in_x));
    range.slopes[0] =
        hull_of(weighted<16, 1>(differences<16, 1>(yz), slope_weights(from[0], to[0])));
    range.slopes[1] = hull_of(
        weighted<12, 1>(weighted<4, 4>(differences<4, 4>(z), slope_weights(from[1], to[1])), in_x));
    const auto by_z = weighted<1, 16>(differences<1, 16>(all), slope_weights(from[2], to[2]));
    range.slopes[2] = hull_of(weighted<12, 1>(weighted<3, 4>(by_z, in_y), in_x));
    return range;
}

}  // namespace zeroset
