#pragma once

#include "engine/volume/pyramid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace zeroset {

/// The control points of a B-spline over a few cells of the grid of whole numbers, the first axis
/// running fastest: along an axis of `degree` and n cells there are n + degree, and what they
/// control lies between the least and the largest of them.
///
/// `narrow` along each axis puts those of a part of the cells in their place (by inserting the
/// part's ends as knots [Boehm80]), and `differentiate` those of the derivative. Both are linear;
/// an axis is differentiated before it is narrowed.
class ControlPoints {
public:
    static constexpr std::size_t most = 216;

    /// Control points of a cubic over so many cells along each axis: `fits` says whether there is
    /// room.
    explicit ControlPoints(const std::array<std::size_t, 3>& cells)
        : count_{cells[0] + 3, cells[1] + 3, cells[2] + 3} {}
    static bool fits(const std::array<std::size_t, 3>& cells) {
        constexpr std::size_t most_cells = most / 16;
        return cells[0] <= most_cells && cells[1] <= most_cells && cells[2] <= most_cells &&
               (cells[0] + 3) * (cells[1] + 3) * (cells[2] + 3) <= most;
    }
    // Copies what is there: most are few.
    ControlPoints(const ControlPoints& other) : count_(other.count_), degree_(other.degree_) {
        std::copy_n(other.values_.begin(), size(), values_.begin());
    }
    ControlPoints& operator=(const ControlPoints& other) {
        count_ = other.count_;
        degree_ = other.degree_;
        std::copy_n(other.values_.begin(), size(), values_.begin());
        return *this;
    }
    ~ControlPoints() = default;

    [[nodiscard]] std::size_t size() const { return count_[0] * count_[1] * count_[2]; }
    [[nodiscard]] const std::array<std::size_t, 3>& count() const { return count_; }
    double& operator[](std::size_t i) { return values_[i]; }
    double operator[](std::size_t i) const { return values_[i]; }

    /// Keeps of the cells along the axis what lies from `from`, in the first one, to `to`, in the
    /// last one; the first cell begins at 0.
    void narrow(std::size_t axis, double from, double to) {
        const Shares first = shares_of_start(axis, from);
        const Shares last = shares_of_end(axis, from, to);
        const std::size_t degree = degree_[axis];
        each_line(axis, [&](double* line, std::size_t step) {
            double* const end = line + (count_[axis] - 1) * step;
            for (std::size_t round = 0; round < degree; ++round) {
                for (std::size_t i = 0; i < degree - round; ++i) {
                    double& value = line[i * step];
                    value = mix(value, line[(i + 1) * step], first[round][i]);
                }
            }
            for (std::size_t round = 0; round < degree; ++round) {
                for (std::size_t i = 0; i < degree - round; ++i) {
                    double& value = *(end - i * step);
                    value = mix(value, *(end - (i + 1) * step), last[round][i]);
                }
            }
        });
    }
    void differentiate(std::size_t axis) {
        const std::size_t step = step_of(axis);
        std::size_t at = 0;
        for (std::size_t i = 0; i < size(); ++i) {
            if (i / step % count_[axis] == count_[axis] - 1) continue;
            values_[at++] = values_[i + step] - values_[i];
        }
        --count_[axis];
        --degree_[axis];
    }
    /// The least and the largest of the finite ones.
    [[nodiscard]] SampleRange range() const { return range_of(std::span(values_.data(), size())); }

private:
    /// By the round of insertions and the place from the end: the share of the inner neighbour.
    using Shares = std::array<std::array<double, 3>, 3>;

    static double mix(double a, double b, double t) { return a * (1 - t) + b * t; }
    [[nodiscard]] Shares shares_of_start(std::size_t axis, double from) const {
        Shares shares{};
        for (std::size_t round = 0; round < degree_[axis]; ++round) {
            const std::size_t left = degree_[axis] - round;  // rounds, with this one
            for (std::size_t i = 0; i < left; ++i)
                shares[round][i] =
                    (from + static_cast<double>(left - 1 - i)) / static_cast<double>(left);
        }
        return shares;
    }
    /// The start has been inserted: it is the knot before the first inner one.
    [[nodiscard]] Shares shares_of_end(std::size_t axis, double from, double to) const {
        const auto cells = static_cast<double>(count_[axis] - degree_[axis]);
        Shares shares{};
        for (std::size_t round = 0; round < degree_[axis]; ++round) {
            const std::size_t left = degree_[axis] - round;
            for (std::size_t i = 0; i < left; ++i) {
                const double outer = cells + static_cast<double>(left - 1 - i);
                const double inner = std::max(cells - 1 - static_cast<double>(i), from);
                shares[round][i] = outer > inner ? (outer - to) / (outer - inner) : 0;
            }
        }
        return shares;
    }
    [[nodiscard]] std::size_t step_of(std::size_t axis) const {
        return axis == 0 ? 1 : axis == 1 ? count_[0] : count_[0] * count_[1];
    }
    void each_line(std::size_t axis, auto change) {
        const std::size_t step = step_of(axis);
        const std::size_t block = step * count_[axis];
        for (std::size_t from = 0; from < size(); from += block) {
            for (std::size_t i = 0; i < step; ++i)
                change(&values_[from + i], step);
        }
    }

    std::array<std::size_t, 3> count_;
    std::array<std::size_t, 3> degree_{3, 3, 3};
    std::array<double, most> values_;
};

}  // namespace zeroset
