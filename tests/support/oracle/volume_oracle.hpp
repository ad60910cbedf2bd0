#pragma once

#include "engine/expr/expr.hpp"
#include "engine/volume/volume.hpp"
#include "tests/support/oracle/ray_question.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace zeroset::test {

/// Finds the first place on a ray where a volume is a number: in each cell that is a polynomial
/// in t with rational coefficients, of degree 3 or, of a spline, 9, which PolynomialOracle solves
/// exactly. Only where cells meet is t rounded.
class VolumeOracle {
public:
    /// The oracle, or nullopt where the formula is not volume(x, y, z) - c with a volume that does
    /// not jump.
    static std::optional<VolumeOracle> of(const Expr& expr);

    [[nodiscard]] RayAnswer answer(const RayQuestion& ray) const;

private:
    VolumeOracle(std::shared_ptr<const Volume> volume, Node level)
        : volume_(std::move(volume)), level_(std::move(level)) {}

    [[nodiscard]] std::vector<double> crossings(const RayQuestion& ray) const;
    [[nodiscard]] std::optional<Expr> polynomial(const RayQuestion& ray, double middle) const;
    [[nodiscard]] std::vector<NodeId> cell_weights(ExprBuilder& builder, NodeId above) const;
    [[nodiscard]] int sign_at(const RayQuestion& ray, double t) const;

    std::shared_ptr<const Volume> volume_;
    Node level_;
};

}  // namespace zeroset::test
