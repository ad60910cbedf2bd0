#pragma once

#include "engine/expr/expr.hpp"

namespace zeroset {

/// Whether `inverse_slope` knows the function.
bool is_inverse(Op op);

/// Values p and q of an inverse function at u and v.
struct InverseValues {
    Op op;
    NodeId u, v;
    NodeId p, q;
};

/// (u - v)/(p - q), also where u = v. Private to the divided differences.
NodeId inverse_slope(ExprBuilder& builder, const InverseValues& values);

}  // namespace zeroset
