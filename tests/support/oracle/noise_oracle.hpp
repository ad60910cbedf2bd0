#pragma once

#include "engine/expr/expr.hpp"
#include "engine/noise/cellular.hpp"
#include "engine/noise/lattice_noise.hpp"
#include "tests/support/oracle/ray_question.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace zeroset::test {

/// Finds the first place on a ray where noise is a number. Between the planes of the lattice
/// gradient and value noise are polynomials in t with rational coefficients of degree 16, which
/// PolynomialOracle solves exactly; cellular noise changes its side of the number only on spheres
/// about the cells' points. Only where pieces meet is t rounded.
class NoiseOracle {
public:
    /// The oracle, or nullopt where the formula is not noise(x, y, z) - c.
    static std::optional<NoiseOracle> of(const Expr& expr);

    [[nodiscard]] RayAnswer answer(const RayQuestion& ray) const;

private:
    NoiseOracle(std::shared_ptr<const Field> field, const Node& level)
        : field_(std::move(field)), level_(level) {}

    [[nodiscard]] std::vector<double> planes(const RayQuestion& ray) const;
    [[nodiscard]] std::vector<double> spheres(const RayQuestion& ray, const Cellular& of) const;
    [[nodiscard]] std::optional<Expr> polynomial(const RayQuestion& ray, const LatticeNoise& of,
                                                 double middle) const;
    [[nodiscard]] RayAnswer first_change(const RayQuestion& ray, const Cellular& of) const;
    [[nodiscard]] int sign_at(const RayQuestion& ray, double t) const;

    std::shared_ptr<const Field> field_;
    Node level_;
};

}  // namespace zeroset::test
