#pragma once

#include "engine/volume/cell_spline.hpp"
#include "engine/volume/control_points.hpp"
#include "engine/volume/index_box.hpp"
#include "engine/volume/spline.hpp"
#include "engine/volume/trilinear.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

// The cubic B-spline of coefficients of one type: values at points, enclosures over boxes. In any
// rounding mode, as Trilinear, whose place it takes in VolumeOf.

namespace zeroset {

template <class Number>
class CubicSpline {
public:
    using Source = SplineData;
    using Range = InterpolationRange;
    template <class Wide>
    using Point = InterpolationPoint<Wide>;
    /// First and second derivatives go on where cells meet.
    static constexpr bool joins_smoothly = true;
    /// Roundings of values and slopes between coefficients, amply counted.
    static constexpr double roundings = 512;
    static constexpr double share_of_errors = 0x1p-5;

    explicit CubicSpline(const SplineData& spline)
        : data_(static_cast<const Number*>(spline.coefficients().data.get())),
          size_(spline.volume()->samples().size),
          map_(spline.volume()->map()),
          pyramid_(spline.pyramid<Number>()) {}

    [[nodiscard]] IndexBox box(const std::array<double, 3>& lo,
                               const std::array<double, 3>& hi) const {
        return index_box(map_, size_, lo, hi);
    }
    [[nodiscard]] Range range(const IndexBox& box, bool with_slopes) const;
    /// The second derivatives by the indices, over the box.
    [[nodiscard]] Bends<ValueBounds> bends(const IndexBox& box) const;
    /// At indices within the grid.
    template <class Wide>
    [[nodiscard]] Point<Wide> at(const std::array<Wide, 3>& index, bool with_bends) const;

private:
    /// The first of the coefficients about a cell.
    [[nodiscard]] const Number* coefficient(const std::array<std::int64_t, 3>& cell) const {
        return data_ + cell[2] * slice() + cell[1] * width() + cell[0];
    }
    [[nodiscard]] std::int64_t width() const { return static_cast<std::int64_t>(size_[0]) + 2; }
    [[nodiscard]] std::int64_t slice() const {
        return width() * (static_cast<std::int64_t>(size_[1]) + 2);
    }
    /// `range` of a box in one cell without holes; nothing where there is one.
    [[nodiscard]] std::optional<Range> in_cell(const IndexBox& box) const;
    /// The coefficients about the box, or nothing where there are too many.
    [[nodiscard]] std::optional<ControlPoints> control_points(const IndexBox& box) const;
    /// All coefficients about the box.
    [[nodiscard]] SampleRange all(const IndexBox& box) const {
        CellSpan span = box.cells;
        for (std::int64_t& last : span.last)
            last += 2;
        return pyramid_.range(span);
    }
    static ValueBounds bounds(ControlPoints points, const IndexBox& box, double error) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto first = static_cast<double>(box.cells.first[axis]);
            points.narrow(axis, box.from[axis] - first, box.to[axis] - first);
        }
        const SampleRange range = points.range();
        return ValueBounds{.lo = range.lo, .hi = range.hi}.widened(error);
    }

    const Number* data_;
    GridSize size_;
    IndexMap map_;
    const Pyramid<Number>& pyramid_;
};

template <class Number>
auto CubicSpline<Number>::in_cell(const IndexBox& box) const -> std::optional<Range> {
    CellCoefficients all;
    const Number* const base = coefficient(box.cells.first);
    double sizes = 0;
    for (std::size_t row = 0; row < 16; ++row) {
        const Number* const from = base + static_cast<std::int64_t>(row / 4) * slice() +
                                   static_cast<std::int64_t>(row % 4) * width();
        for (std::size_t i = 0; i < 4; ++i) {
            all[4 * row + i] = static_cast<double>(from[i]);
            sizes += std::abs(all[4 * row + i]);
        }
    }
    if (!(sizes <= std::numeric_limits<double>::max())) return std::nullopt;
    std::array<double, 3> from{};
    std::array<double, 3> to{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto first = static_cast<double>(box.cells.first[i]);
        from[i] = box.from[i] - first;
        to[i] = box.to[i] - first;
    }
    const CellRange found = range_in_cell(all, from, to);
    Range result;
    result.exact = true;
    result.largest = hull_of(all).size();
    const double error = roundings * unit_of<double> * result.largest;
    result.value = found.value.widened(error);
    for (std::size_t i = 0; i < 3; ++i)
        result.slopes[i] = found.slopes[i].widened(error);
    return result;
}

template <class Number>
std::optional<ControlPoints> CubicSpline<Number>::control_points(const IndexBox& box) const {
    const std::array<std::size_t, 3> cells{box.samples(0) - 1, box.samples(1) - 1,
                                           box.samples(2) - 1};
    if (!ControlPoints::fits(cells)) return std::nullopt;
    ControlPoints points(cells);
    const Number* const base = coefficient(box.cells.first);
    const auto& count = points.count();
    std::size_t at = 0;
    for (std::size_t k = 0; k < count[2]; ++k) {
        for (std::size_t j = 0; j < count[1]; ++j) {
            const Number* const row = base + static_cast<std::int64_t>(k) * slice() +
                                      static_cast<std::int64_t>(j) * width();
            for (std::size_t i = 0; i < count[0]; ++i)
                points[at++] = static_cast<double>(row[i]);
        }
    }
    return points;
}

template <class Number>
auto CubicSpline<Number>::range(const IndexBox& box, bool with_slopes) const -> Range {
    if (box.cells.first == box.cells.last) {
        if (const auto found = in_cell(box)) return *found;
    }
    Range result;
    const auto points = control_points(box);
    const SampleRange about = points ? points->range() : all(box);
    result.holes = about.holes;
    result.somewhere = about.any();
    if (!about.any()) return result;
    result.value = {.lo = about.lo, .hi = about.hi};
    result.largest = result.value.size();
    const double error = roundings * unit_of<double> * result.largest;
    if (!points || about.holes) {
        // A slope is between differences of neighbours.
        const double apart = about.hi - about.lo + error;
        result.value = result.value.widened(error);
        result.slopes.fill({.lo = -apart, .hi = apart});
        return result;
    }
    result.exact = true;
    result.value = bounds(*points, box, error);
    if (!with_slopes) return result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ControlPoints slope = *points;
        slope.differentiate(axis);
        result.slopes[axis] = bounds(slope, box, error);
    }
    return result;
}

template <class Number>
Bends<ValueBounds> CubicSpline<Number>::bends(const IndexBox& box) const {
    Bends<ValueBounds> bends;
    const auto points = control_points(box);
    const SampleRange about = points ? points->range() : all(box);
    if (!about.any()) return bends;
    const double error =
        roundings * unit_of<double> * std::max(std::abs(about.lo), std::abs(about.hi));
    const double apart = 2 * (about.hi - about.lo) + error;
    bends.mixed.fill({.lo = -apart, .hi = apart});
    bends.own.fill({.lo = -apart, .hi = apart});
    if (!points || about.holes) return bends;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ControlPoints own = *points;
        own.differentiate(axis);
        own.differentiate(axis);
        bends.own[axis] = bounds(own, box, error);
        ControlPoints mixed = *points;
        mixed.differentiate((axis + 1) % 3);
        mixed.differentiate((axis + 2) % 3);
        bends.mixed[axis] = bounds(mixed, box, error);
    }
    return bends;
}

/// The weights of four coefficients at `t` in a cell; of the function, its slope and its bend.
template <class Wide>
std::array<std::array<Wide, 4>, 3> spline_weights(Wide t) {
    const Wide s = 1 - t;
    return {{{s * s * s / 6, (t * t * (3 * t - 6) + 4) / 6, (s * s * (3 * s - 6) + 4) / 6,
              t * t * t / 6},
             {-s * s / 2, t * (3 * t - 4) / 2, s * (4 - 3 * s) / 2, t * t / 2},
             {s, 3 * t - 2, 3 * s - 2, t}}};
}

/// Sums of products with the coefficients about a cell.
template <class Wide>
class SplineSums {
public:
    using Four = std::array<Wide, 4>;
    using Orders = std::array<Four, 3>;  ///< by the order of a derivative

    /// `row(j, k)` is the first of four coefficients. Derivatives up to the order `most`.
    SplineSums(const std::array<Orders, 3>& weights, std::size_t most, auto row)
        : by_k_(weights[2]) {
        for (std::size_t k = 0; k < 4; ++k) {
            Orders in_row;
            for (std::size_t j = 0; j < 4; ++j) {
                const auto* const from = row(j, k);
                const Four four{static_cast<Wide>(from[0]), static_cast<Wide>(from[1]),
                                static_cast<Wide>(from[2]), static_cast<Wide>(from[3])};
                for (std::size_t order = 0; order <= most; ++order)
                    in_row[order][j] = dot(weights[0][order], four);
            }
            for (std::size_t by_i = 0; by_i <= most; ++by_i) {
                for (std::size_t by_j = 0; by_i + by_j <= most; ++by_j)
                    in_slices_[by_i][by_j][k] = dot(weights[1][by_j], in_row[by_i]);
            }
        }
    }
    [[nodiscard]] Wide derivative(std::size_t by_i, std::size_t by_j, std::size_t by_k) const {
        return dot(by_k_[by_k], in_slices_[by_i][by_j]);
    }

private:
    static Wide dot(const Four& a, const Four& b) {
        return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
    }

    Orders by_k_;
    std::array<Orders, 3> in_slices_;  ///< by the orders in i and j
};

template <class Number>
template <class Wide>
auto CubicSpline<Number>::at(const std::array<Wide, 3>& index, bool with_bends) const
    -> Point<Wide> {
    std::array<std::int64_t, 3> cell{};
    std::array<typename SplineSums<Wide>::Orders, 3> weights;
    for (std::size_t i = 0; i < 3; ++i) {
        cell[i] =
            std::min(static_cast<std::int64_t>(index[i]), static_cast<std::int64_t>(size_[i]) - 2);
        weights[i] = spline_weights<Wide>(index[i] - static_cast<Wide>(cell[i]));
    }
    const Number* const base = coefficient(cell);
    const SplineSums<Wide> sums(weights, with_bends ? 2 : 1, [&](std::size_t j, std::size_t k) {
        return base + static_cast<std::int64_t>(k) * slice() +
               static_cast<std::int64_t>(j) * width();
    });
    Point<Wide> point;
    point.value = sums.derivative(0, 0, 0);
    if (!std::isfinite(point.value)) {
        point.value = std::numeric_limits<Wide>::quiet_NaN();
        return point;
    }
    point.slope = {sums.derivative(1, 0, 0), sums.derivative(0, 1, 0), sums.derivative(0, 0, 1)};
    if (!with_bends) return point;
    point.bend.mixed = {sums.derivative(0, 1, 1), sums.derivative(1, 0, 1),
                        sums.derivative(1, 1, 0)};
    point.bend.own = {sums.derivative(2, 0, 0), sums.derivative(0, 2, 0), sums.derivative(0, 0, 2)};
    return point;
}

}  // namespace zeroset
