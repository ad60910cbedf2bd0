#pragma once

#include "engine/kernel/kernel.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace zeroset {

/// Some cells of a frustum and their forms: FormBatchOf's arrays, of a fixed capacity.
/// Plain data, nothing of it set at first.
template <class Real, std::size_t capacity>
struct FormCells {
    static_assert(capacity % batch_multiple == 0);

    std::array<Real, capacity> u, v, s, s_radius;
    std::array<Real, capacity> c, e, r, slope_neg_lo, slope_hi;
    std::array<std::array<Real, capacity>, 3> k;
    std::array<ContinuityMask<Real>, capacity> continuous, nowhere;

    /// The first `count`, a multiple of batch_multiple; `uniforms`: for boxes.
    FormBatchOf<Real> batch(std::size_t count, const FrustumOf<Real>& frustum,
                            const Real* uniforms) {
        return {.size = count,
                .u = u.data(),
                .v = v.data(),
                .s = s.data(),
                .s_radius = s_radius.data(),
                .frustum = frustum.base,
                .uniforms = uniforms,
                .c = c.data(),
                .k = {k[0].data(), k[1].data(), k[2].data()},
                .e = e.data(),
                .r = r.data(),
                .slope_neg_lo = slope_neg_lo.data(),
                .slope_hi = slope_hi.data(),
                .continuous = continuous.data(),
                .nowhere = nowhere.data()};
    }

    /// The most by which f can differ from c[i] in the cell. In upward rounding.
    [[nodiscard]] Real spread(std::size_t i) const {
        return std::abs(k[0][i]) + std::abs(k[1][i]) + std::abs(k[2][i]) + e[i];
    }
};

}  // namespace zeroset
