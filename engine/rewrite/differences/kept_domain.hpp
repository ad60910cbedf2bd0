#pragma once

#include "engine/algebra/node_facts.hpp"
#include "engine/expr/expr.hpp"

#include <initializer_list>
#include <span>

// Domains of functions that are written in another way. Private to the divided differences.

namespace zeroset {

/// The function, undefined where one of the terms is: what cancels has no value everywhere. Terms'
/// operators among `divided` are those whose poles the function has by itself.
NodeId with_domain_of(ExprBuilder& builder, NodeFacts& facts, NodeId function,
                      std::span<const NodeId> terms, std::initializer_list<Op> divided);

}  // namespace zeroset
