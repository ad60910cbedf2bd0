#pragma once

#include "engine/blobs/blobs.hpp"
#include "engine/expr/expr.hpp"
#include "tests/support/oracle/ray_question.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace zeroset::test {

/// Finds the first place on a ray where the sum of Wyvill's balls is a number: between the ends of
/// supports it is a polynomial in t of degree 6 with rational coefficients, which PolynomialOracle
/// solves exactly. Only where pieces meet is t rounded.
class BlobOracle {
public:
    /// The oracle, or nullopt where the formula is not blobs(x, y, z, ...) - c after Wyvill.
    static std::optional<BlobOracle> of(const Expr& expr);

    [[nodiscard]] RayAnswer answer(const RayQuestion& ray) const;

private:
    BlobOracle(std::shared_ptr<const BlobsField> field, const Node& level)
        : field_(std::move(field)), level_(level) {}

    [[nodiscard]] std::vector<double> ends(const RayQuestion& ray) const;
    [[nodiscard]] std::optional<Expr> polynomial(const RayQuestion& ray, double middle) const;

    std::shared_ptr<const BlobsField> field_;
    Node level_;
};

}  // namespace zeroset::test
