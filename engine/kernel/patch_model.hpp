#pragma once

#include "engine/kernel/uniforms.hpp"
#include "engine/real/unbounded.hpp"

#include <array>
#include <cstddef>
#include <span>

// Parametric surfaces as polynomials: what the code of a patch tells of it over small boxes.

namespace zeroset {

/// The (u, v) with |u - u_i| <= u_radius and |v - v_i| <= v_radius.
struct UvBox {
    double u, v, u_radius, v_radius;

    /// The box with radii times `factor`.
    [[nodiscard]] UvBox grown(double factor) const {
        return {.u = u, .v = v, .u_radius = factor * u_radius, .v_radius = factor * v_radius};
    }
};

/// Polynomials in (p, q) have the terms p^i q^j with i + j <= patch_degree, by i + j and then by j:
/// 1, p, q, p^2, p q, q^2, ...
inline constexpr int patch_degree = 7;
inline constexpr std::size_t patch_terms =
    std::size_t{patch_degree + 1} * std::size_t{patch_degree + 2} / 2;

/// The term p^i q^j.
constexpr std::size_t patch_term(int i, int j) {
    return static_cast<std::size_t>((i + j) * (i + j + 1) / 2 + j);
}

/// The exponents of a term.
struct PatchPower {
    int p, q;
};
inline constexpr std::array<PatchPower, patch_terms> patch_powers = [] {
    std::array<PatchPower, patch_terms> powers{};
    for (int sum = 0; sum <= patch_degree; ++sum) {
        for (int j = 0; j <= sum; ++j)
            powers[patch_term(sum - j, j)] = {.p = sum - j, .q = j};
    }
    return powers;
}();

/// A patch over a box: for (p, q) in [-1, 1]^2, which run over it, coordinate k is within error[k]
/// of the polynomial, and continuous.
struct PatchModel {
    std::array<std::array<double, patch_terms>, 3> terms;
    /// +inf: nothing is known of the coordinate.
    std::array<double, 3> error;

    [[nodiscard]] bool known() const {
        return error[0] < unbounded && error[1] < unbounded && error[2] < unbounded;
    }
};

/// Makes the models of a patch. Any thread; in upward rounding.
class PatchModeler {
public:
    PatchModeler() = default;
    PatchModeler(const PatchModeler&) = delete;
    PatchModeler& operator=(const PatchModeler&) = delete;
    virtual ~PatchModeler() = default;

    /// The model over each of the boxes.
    virtual void make_models(std::span<const UvBox> boxes, const Uniforms& uniforms,
                             std::span<PatchModel> models) const = 0;
};

}  // namespace zeroset
