#pragma once

#include "engine/algebra/facts.hpp"
#include "engine/expr/expr.hpp"
#include "engine/rewrite/polynomial/polynomial.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// A graph with what is known of it.
struct AnalysedExpr {
    const Expr& expr;
    std::span<const Facts> facts;
    const Expansion& expansion;
};

/// Nodes of `builder` that compute what node `id` does, equal in the reals and defined where it is;
/// about `max_new_nodes` new ones at most. `now` are the nodes that stand for the graph's own.
std::vector<NodeId> polynomial_candidates(ExprBuilder& builder, const AnalysedExpr& graph,
                                          std::span<const NodeId> now, NodeId id,
                                          std::size_t max_new_nodes);

}  // namespace zeroset
