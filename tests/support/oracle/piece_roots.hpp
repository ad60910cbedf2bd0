#pragma once

#include "tests/support/oracle/polynomial_oracle.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace zeroset::test {

/// A function that is another polynomial on each piece of a ray.
struct RayPieces {
    std::vector<double> ends;  ///< where pieces may meet, but for roundings, and the ray's ends
    /// The polynomial of the piece about a place; nullopt where the function is not defined.
    std::function<std::optional<Expr>(double)> polynomial;
    /// The sign at a place; 0 where it is 0 or not defined.
    std::function<int(double)> sign_at;
    /// Whether the piece between two places surely holds no root, by quicker means; may be empty.
    std::function<bool(double, double)> surely_empty = {};
};

/// The first root, from the exact roots of the pieces.
RayAnswer first_root(const RayQuestion& ray, const RayPieces& pieces);

}  // namespace zeroset::test
