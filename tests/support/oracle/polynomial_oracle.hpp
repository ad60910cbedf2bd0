#pragma once

#include "engine/expr/expr.hpp"
#include "tests/support/oracle/ray_question.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace zeroset::test {

/// A root of a polynomial along a ray: the only one for t in [from, to].
struct RayRoot {
    double from, to;
    bool crosses;  ///< its multiplicity is odd
};

/// Finds the roots of polynomials along rays exactly: the formula and the doubles of the ray make a
/// polynomial in t with rational coefficients, whose real roots are isolated by Descartes' rule of
/// signs and bisection (Collins and Akritas 1976), in FLINT.
class PolynomialOracle {
public:
    /// The oracle, or nullopt where the formula is no polynomial with fractions for constants.
    /// `uniforms` are w and the parameters.
    static std::optional<PolynomialOracle> of(const Expr& expr, std::span<const double> uniforms);

    /// The first `most` roots in outer_from <= t <= outer_to, in order, each narrowed to 2^-32 of
    /// that range; nullopt where f is 0 on the whole ray.
    [[nodiscard]] std::optional<std::vector<RayRoot>> roots(
        const RayQuestion& ray, std::size_t most = std::numeric_limits<std::size_t>::max()) const;

    [[nodiscard]] RayAnswer answer(const RayQuestion& ray) const;

private:
    explicit PolynomialOracle(Expr expr, std::span<const double> uniforms)
        : expr_(std::move(expr)), uniforms_(uniforms.begin(), uniforms.end()) {}

    Expr expr_;
    std::vector<double> uniforms_;
};

}  // namespace zeroset::test
