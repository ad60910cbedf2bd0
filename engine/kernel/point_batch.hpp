#pragma once

#include "engine/kernel/batches.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace zeroset {

/// Some points, and f and its gradient there: ValueBatchOf's arrays, as many as there are.
template <class Real>
class PointBatch {
public:
    enum class Asks { Value, Gradient };

    PointBatch() = default;
    explicit PointBatch(std::size_t count, Asks asks = Asks::Gradient) { resize(count, asks); }

    /// Room for `count` points, at least one, and for what is asked about them. Of points that were
    /// set before nothing is kept for sure.
    void resize(std::size_t count, Asks asks = Asks::Gradient) {
        count_ = count;
        for (std::vector<Real>& column : x_)
            column.resize(size());
        f_.resize(size());
        for (std::vector<Real>& column : gradient_)
            column.resize(asks == Asks::Gradient ? size() : 0);
    }
    void set(std::size_t i, Real x, Real y, Real z) {
        x_[0][i] = x;
        x_[1][i] = y;
        x_[2][i] = z;
    }
    /// Repeats the last point up to whole batches.
    void pad() {
        for (std::vector<Real>& column : x_)
            std::fill(column.begin() + static_cast<std::ptrdiff_t>(count_), column.end(),
                      column[count_ - 1]);
    }
    /// Points up to whole batches.
    [[nodiscard]] std::size_t size() const { return padded(count_); }
    /// `size` points from `first` on, both multiples of batch_multiple; `uniforms`: for points.
    ValueBatchOf<Real> batch(std::size_t first, std::size_t size, const Real* uniforms) {
        const auto from = [first](std::vector<Real>& column) {
            return column.empty() ? nullptr : column.data() + first;
        };
        return {.size = size,
                .x = {from(x_[0]), from(x_[1]), from(x_[2])},
                .uniforms = uniforms,
                .f = from(f_),
                .gradient = {from(gradient_[0]), from(gradient_[1]), from(gradient_[2])}};
    }
    ValueBatchOf<Real> batch(const Real* uniforms) { return batch(0, size(), uniforms); }
    /// Calls a function of values for all points, some at a time, until `stopped()`.
    template <class Function, class Stopped>
    void evaluate(const Function& function, const Real* uniforms, const Stopped& stopped) {
        constexpr std::size_t at_once = 256;
        for (std::size_t i = 0; i < size() && !stopped(); i += at_once)
            function(batch(i, std::min(at_once, size() - i), uniforms));
    }

    /// The number of points that were set.
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] Real f(std::size_t i) const { return f_[i]; }
    [[nodiscard]] Real gradient(std::size_t axis, std::size_t i) const {
        return gradient_[axis][i];
    }

private:
    std::size_t count_ = 0;
    std::array<std::vector<Real>, 3> x_, gradient_;
    std::vector<Real> f_;
};

}  // namespace zeroset
