#pragma once

#include "engine/algebra/node_facts.hpp"

#include <optional>

namespace zeroset {

/// A difference f1 - f0 is delta dd(f).
struct Difference {
    NodeId delta;
    NodeId divided;
};

/// The divided difference of two values of a function whose variables differ by constants; delta is
/// one of these. Nothing
/// where they differ by more, or by much.
std::optional<Difference> divided_difference(ExprBuilder& builder, NodeFacts& facts, NodeId f1,
                                             NodeId f0);

}  // namespace zeroset
