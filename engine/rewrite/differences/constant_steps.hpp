#pragma once

#include "engine/expr/exact.hpp"

#include <optional>

// Nodes that differ by constants. Private to the divided differences.

namespace zeroset {

/// The constant f1 - f0, if they are the same but for a constant summand.
std::optional<Fraction> step_between(ExprBuilder& builder, NodeId f1, NodeId f0);

NodeId constant_of(ExprBuilder& builder, const Fraction& value);
/// The quotient of two constants.
NodeId ratio(ExprBuilder& builder, NodeId a, NodeId b);

}  // namespace zeroset
