#pragma once

#include "engine/algebra/node_facts.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/expr.hpp"

#include <optional>

namespace zeroset {

/// Returns the same function, its small differences without cancellation: in (F(x + c) - F(x))/c,
/// which many formulas have for a derivative, both terms are computed to their own accuracy and
/// enclosed on their own, and the difference of the enclosures is divided by a small c. It is
/// written by what is common to both instead: (x + c)^2 - x^2 is c (2x + c), sin(u) - sin(v) is (u
/// - v) cos((u + v)/2) sinc((u - v)/2). Differences whose terms differ by more than constants are
/// left alone, and so are those of large c.
Expr without_small_differences(const Expr& expr);

/// A difference f1 - f0 is delta dd(f).
struct Difference {
    NodeId delta;
    NodeId divided;
};

/// The divided difference of two values of a function whose variables differ by constants; delta is
/// one of these.
/// Nothing where they differ by more, or by much.
std::optional<Difference> divided_difference(ExprBuilder& builder, NodeFacts& facts, NodeId f1,
                                             NodeId f0);

/// A node of a function, and what another function has in its place.
struct Replacement {
    NodeId from, by;
};

/// (f - g)/(from - by) for a function g that is f with a replaced node, from - by being `delta`.
/// Nothing where f is made of functions of `from` that have no such quotient.
std::optional<NodeId> divided_difference(ExprBuilder& builder, NodeFacts& facts, NodeId f, NodeId g,
                                         const Replacement& replaced, NodeId delta);

// Nodes that differ by constants. Private to the divided differences.

/// The constant f1 - f0, if they are the same but for a constant summand.
std::optional<Fraction> step_between(ExprBuilder& builder, NodeId f1, NodeId f0);

NodeId constant_of(ExprBuilder& builder, const Fraction& value);
/// The quotient of two constants.
NodeId ratio(ExprBuilder& builder, NodeId a, NodeId b);

}  // namespace zeroset
