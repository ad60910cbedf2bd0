#pragma once

#include "engine/expr/expr.hpp"

#include <optional>

namespace zeroset {

/// p / q in lowest terms, q > 0.
struct Fraction {
    long long p, q;
};

/// The exact value of a subexpression of + - * / and powers over decimal numbers, if it is a
/// fraction of moderate numbers and of few operators.
std::optional<Fraction> exact_fraction(const ExprBuilder& builder, NodeId id);
/// The exact value of such a subexpression, if it is a double.
std::optional<double> exact_value(const ExprBuilder& builder, NodeId id);

}  // namespace zeroset
