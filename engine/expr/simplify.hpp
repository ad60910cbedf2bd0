#pragma once

#include "engine/expr/expr.hpp"

namespace zeroset {

// Nodes by meaning, with the rewrites that keep the value everywhere and never loosen the interval.

NodeId make_negate(ExprBuilder& builder, NodeId a);
NodeId make_add(ExprBuilder& builder, NodeId a, NodeId b);
NodeId make_subtract(ExprBuilder& builder, NodeId a, NodeId b);
/// Factors that are powers of one base become one power.
NodeId make_multiply(ExprBuilder& builder, NodeId a, NodeId b);
NodeId make_divide(ExprBuilder& builder, NodeId a, NodeId b);
/// An integer exponent makes powers and reciprocals, a fraction p/q with small q roots (of negative
/// numbers, too, where q is odd), any other exponent the real power exp(b ln a), which needs a > 0.
NodeId make_power(ExprBuilder& builder, NodeId a, NodeId b);
/// a^n for any n.
NodeId make_int_power(ExprBuilder& builder, NodeId a, int n);
/// The real root of degree n: odd and at least 3.
NodeId make_root(ExprBuilder& builder, NodeId a, int n);
/// A function or condition of op.def. sin and cos of sums with integer multiples of atan2 lose the
/// cut of atan2.
NodeId make_call(ExprBuilder& builder, Op function, NodeId a, NodeId b = 0, NodeId c = 0);

}  // namespace zeroset
