#pragma once

#include "engine/expr/expr.hpp"

#include <vector>

namespace zeroset {

/// A function and what restricts it as a whole: it is defined where no bound is above 0, but for
/// the places where one is 0.
struct RestrictedExpr {
    Expr function;
    std::vector<Expr> bounds;  ///< continuous where what they compare is
};

/// Takes the restrictions off the root whose conditions are comparisons, joined by and, or, not;
/// the others stay.
RestrictedExpr without_restriction(const Expr& expr);

}  // namespace zeroset
