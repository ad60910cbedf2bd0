#pragma once

#include "engine/kernel/batches.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// +1 or -1 where all of a range surely has that sign, else 0; of none, 0.
template <class Real>
int sign_of_range(Real neg_lo, Real hi) {
    return static_cast<int>(neg_lo < 0) - static_cast<int>(hi < 0);
}

/// Some boxes and enclosures of f over them: RangeBatchOf's arrays, of a fixed capacity. Plain
/// data, nothing of it set at first.
template <class Real, std::size_t most>
struct RangeBoxes {
    static_assert(most % batch_multiple == 0);
    static constexpr std::size_t capacity = most;

    alignas(64) Real ends[6][most];  ///< -lo of x, y, z, then hi of x, y, z
    alignas(64) Real f_neg_lo[most];
    alignas(64) Real f_hi[most];
    alignas(64) ContinuityMask<Real> continuous[most];

    /// Repeats the first of `count` boxes up to whole batches.
    void pad(std::size_t count) {
        for (auto& column : ends)
            std::fill(column + count, column + padded(count), column[0]);
    }
    /// The first `count`, a multiple of batch_multiple; `uniforms`: for boxes.
    RangeBatchOf<Real> batch(std::size_t count, const Real* uniforms) {
        return {.size = count,
                .neg_lo = {ends[0], ends[1], ends[2]},
                .hi = {ends[3], ends[4], ends[5]},
                .uniforms = uniforms,
                .f_neg_lo = f_neg_lo,
                .f_hi = f_hi,
                .continuous = continuous};
    }
    /// Whether f is surely nowhere 0 in the box.
    [[nodiscard]] bool excludes_zero(std::size_t i) const { return f_neg_lo[i] < 0 || f_hi[i] < 0; }
    /// +1 or -1 where f surely has that sign, else 0.
    [[nodiscard]] int sign(std::size_t i) const { return sign_of_range(f_neg_lo[i], f_hi[i]); }
    /// A lower bound of |f| in the box, where f surely has a sign; else at most 0.
    [[nodiscard]] Real least_size(std::size_t i) const { return std::max(-f_neg_lo[i], -f_hi[i]); }
};

/// Boxes as in RangeBoxes, as many as there are.
template <class Real>
struct RangeBoxList {
    std::array<std::vector<Real>, 6> ends;
    std::vector<Real> f_neg_lo, f_hi;
    std::vector<ContinuityMask<Real>> continuous, branches;

    [[nodiscard]] std::size_t capacity() const { return f_hi.size(); }
    void resize(std::size_t capacity) {
        for (std::vector<Real>& column : ends)
            column.resize(capacity);
        f_neg_lo.resize(capacity);
        f_hi.resize(capacity);
        continuous.resize(capacity);
        branches.resize(capacity);
    }
    /// Room for `count` boxes and a whole batch more.
    void reserve(std::size_t count) {
        if (count + 2 * batch_multiple > capacity()) resize(2 * count + 4 * batch_multiple);
    }
    /// The first `count` boxes, or of each the piece that `held` tells; up to whole batches, which
    /// repeat the first box. `uniforms`: for boxes.
    RangeBatchOf<Real> batch(std::size_t count, const Real* uniforms,
                             const HeldSwitches<Real>& held = {}) {
        for (std::vector<Real>& column : ends)
            std::fill(column.data() + count, column.data() + padded(count), column[0]);
        return {.size = padded(count),
                .neg_lo = {ends[0].data(), ends[1].data(), ends[2].data()},
                .hi = {ends[3].data(), ends[4].data(), ends[5].data()},
                .uniforms = uniforms,
                .f_neg_lo = f_neg_lo.data(),
                .f_hi = f_hi.data(),
                .continuous = continuous.data(),
                .held = held,
                .branches = branches.data()};
    }
    /// Whether f is surely nowhere 0 in the box.
    [[nodiscard]] bool excludes_zero(std::size_t i) const { return f_neg_lo[i] < 0 || f_hi[i] < 0; }
    /// The sign of f, and its least size, as in RangeBoxes.
    [[nodiscard]] int sign(std::size_t i) const { return sign_of_range(f_neg_lo[i], f_hi[i]); }
    [[nodiscard]] Real least_size(std::size_t i) const { return std::max(-f_neg_lo[i], -f_hi[i]); }
    [[nodiscard]] BranchBits branches_of(std::size_t i) const {
        return {static_cast<std::uint32_t>(branches[i])};
    }
};

}  // namespace zeroset
