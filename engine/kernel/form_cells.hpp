#pragma once

#include "engine/kernel/kernel.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace zeroset {

/// Some cells of a frustum and what forms say of them: FormBatchOf's arrays, of a fixed room.
/// Plain data, nothing of it set at first.
template <class Real, std::size_t room>
struct FormCells {
    static_assert(room % batch_multiple == 0);

    std::array<Real, room> u, v, s, s_radius;
    std::array<Real, room> c, e, r, slope_neg_lo, slope_hi;
    std::array<std::array<Real, room>, 3> k;
    std::array<ContinuityMask<Real>, room> continuous, nowhere;

    /// The first `count`, a multiple of batch_multiple; `uniforms`: for boxes.
    FormBatchOf<Real> batch(std::size_t count, const FrustumOf<Real>& frustum,
                            const Real* uniforms) {
        return {count,           u.data(),          v.data(),
                s.data(),        s_radius.data(),   frustum.base,
                uniforms,        c.data(),          {k[0].data(), k[1].data(), k[2].data()},
                e.data(),        r.data(),          slope_neg_lo.data(),
                slope_hi.data(), continuous.data(), nowhere.data()};
    }

    /// How far f can be from c[i] in the cell. In upward rounding.
    [[nodiscard]] Real spread(std::size_t i) const {
        return std::abs(k[0][i]) + std::abs(k[1][i]) + std::abs(k[2][i]) + e[i];
    }
};

}  // namespace zeroset
