#pragma once

#include "engine/expr/exact.hpp"

#include <optional>

// Values of nodes that are exactly known, of functions, too. Private to the divided differences.

namespace zeroset {

/// The value of an expression of numbers, sin(0) being 0 and exp(0) 1, where it is a fraction that
/// is exactly known; so is a - a, whatever a is, and 0*a.
std::optional<Fraction> known_value(const ExprBuilder& builder, NodeId id);
bool is_known_zero(const ExprBuilder& builder, NodeId id);

}  // namespace zeroset
