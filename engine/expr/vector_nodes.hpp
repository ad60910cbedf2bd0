#pragma once

#include "engine/expr/expr.hpp"

#include <array>

// Vectors of three nodes of one graph. Their numbers are finite wherever they have values, so that
// factors that are 0 leave nothing of a product.

namespace zeroset {

/// A point or a direction.
using VectorNodes = std::array<NodeId, 3>;

/// (x, y, z).
VectorNodes make_place(ExprBuilder& builder);
VectorNodes make_sum(ExprBuilder& builder, const VectorNodes& a, const VectorNodes& b);
VectorNodes make_difference(ExprBuilder& builder, const VectorNodes& a, const VectorNodes& b);
VectorNodes make_scaled(ExprBuilder& builder, NodeId factor, const VectorNodes& v);
VectorNodes make_cross(ExprBuilder& builder, const VectorNodes& a, const VectorNodes& b);
NodeId make_dot(ExprBuilder& builder, const VectorNodes& a, const VectorNodes& b);
NodeId make_length(ExprBuilder& builder, const VectorNodes& v);
/// The vector at length 1; no value where it is 0.
VectorNodes make_unit(ExprBuilder& builder, const VectorNodes& v);

}  // namespace zeroset
