#pragma once

#include "engine/algebra/facts.hpp"
#include "engine/expr/expr.hpp"
#include "engine/rewrite/polynomial/polynomial.hpp"
#include "engine/rewrite/sample/box_sample.hpp"

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

/// A long polynomial with equal monomials added up, nested in the way that beams are likely traced
/// through soonest in the region; the formula itself where it is none, or short, or that saves
/// little. Equal in the reals. A sum of 500 terms in numbers that have names becomes one of 200.
Expr with_collected_terms(const Expr& expr, const SampleRegion& region);

}  // namespace zeroset
