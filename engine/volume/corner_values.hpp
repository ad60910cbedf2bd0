#pragma once

#include "engine/volume/pyramid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace zeroset {

/// Numbers at the points of a small grid, the first axis running fastest.
///
/// What is trilinear in each cell takes its extremes over a box where the box's faces and the
/// grid's planes meet: `narrow` along each axis makes the values there from the samples about the
/// box, and `differentiate` in its place the slopes. Both are linear and can be made in any order.
class CornerValues {
public:
    static constexpr std::size_t most = 64;

    CornerValues() = default;
    explicit CornerValues(const std::array<std::size_t, 3>& count) : count_(count) {}
    // Copies what is there: most are few.
    CornerValues(const CornerValues& other) : count_(other.count_) {
        std::copy_n(other.values_.begin(), size(), values_.begin());
    }
    CornerValues& operator=(const CornerValues& other) {
        count_ = other.count_;
        std::copy_n(other.values_.begin(), size(), values_.begin());
        return *this;
    }
    ~CornerValues() = default;

    [[nodiscard]] std::size_t size() const { return count_[0] * count_[1] * count_[2]; }
    double& operator[](std::size_t i) { return values_[i]; }
    double operator[](std::size_t i) const { return values_[i]; }

    /// Replaces the first and the last number along the axis by those at `from` of the way from the
    /// first to the second and at `to` of the way from the last but one to the last.
    void narrow(std::size_t axis, double from, double to) {
        each_line(axis, [&](double* line, std::size_t step) {
            const std::size_t last = count_[axis] - 1;
            const double first = mix(line[0], line[step], from);
            line[last * step] = mix(line[(last - 1) * step], line[last * step], to);
            line[0] = first;
        });
    }
    /// Replaces the numbers along the axis by their differences, which are one fewer.
    void differentiate(std::size_t axis) {
        CornerValues result(count_);
        --result.count_[axis];
        const std::size_t step = step_of(axis);
        std::size_t at = 0;
        for (std::size_t i = 0; i < size(); ++i) {
            if (i / step % count_[axis] == count_[axis] - 1) continue;
            result.values_[at++] = values_[i + step] - values_[i];
        }
        *this = result;
    }
    /// The least and the largest of the finite ones.
    [[nodiscard]] SampleRange range() const { return range_of(std::span(values_.data(), size())); }

private:
    static double mix(double a, double b, double t) { return a * (1 - t) + b * t; }
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

    std::array<std::size_t, 3> count_{};
    std::array<double, most> values_;
};

}  // namespace zeroset
