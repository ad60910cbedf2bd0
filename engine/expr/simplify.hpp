#pragma once

#include "engine/expr/expr.hpp"

#include <expected>
#include <optional>
#include <string>

namespace zeroset {

// Nodes by meaning, with the rewrites that keep the value everywhere and tighten the interval.

NodeId make_negate(ExprBuilder& builder, NodeId a);
NodeId make_add(ExprBuilder& builder, NodeId a, NodeId b);
NodeId make_subtract(ExprBuilder& builder, NodeId a, NodeId b);
/// x * x becomes a square.
NodeId make_multiply(ExprBuilder& builder, NodeId a, NodeId b);
NodeId make_divide(ExprBuilder& builder, NodeId a, NodeId b);
/// An integer exponent makes powers and reciprocals, 1/2 a square root, any other exponent the
/// real power exp(b log a), which needs a > 0.
NodeId make_power(ExprBuilder& builder, NodeId a, NodeId b);
/// A function of op.def. sin and cos of integer multiples of atan2 lose the cut of atan2.
NodeId make_call(ExprBuilder& builder, Op function, NodeId a, NodeId b);

/// The exact value of a subexpression of + - * / and powers over integers, if it is an integer or
/// half of one; looked for `depth` operators deep.
std::optional<double> exact_value(const ExprBuilder& builder, NodeId id, int depth = 64);

}  // namespace zeroset
