#pragma once

#include "engine/algebra/facts.hpp"
#include "engine/expr/expr.hpp"

#include <span>
#include <vector>

namespace zeroset {

/// Facts of each node, in the graph's order. What is built on an undefined constant subexpression
/// (1/0, sqrt(-1)) is undefined, too, unless a condition may select something else; the first such
/// node of the graph is where it begins. Undefined nodes have no `constant`.
std::vector<Facts> facts_of(const Expr& expr);

/// Facts of one more node, from those of the nodes before it.
Facts facts_of_node(const Node& node, std::span<const Facts> before);

}  // namespace zeroset
