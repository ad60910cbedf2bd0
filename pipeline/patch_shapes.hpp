#pragma once

#include "engine/expr/expr.hpp"
#include "engine/expr/patch_graph.hpp"

#include <array>

namespace zeroset {

/// The coordinates of a surface over the unit square in x and y that shows a parametric surface, a
/// curve as a tube of this radius, or a point as a ball of twice that. A tube's ends are open.
std::array<Expr, 3> shown_patch(const PatchGraphs& graphs, double radius);

/// A function that is 0 on a tube of about this radius about the curve in which two surfaces meet,
/// as far as these are flat within it: below 0 inside.
Expr meeting_tube(const PatchGraphs& graphs, double radius);

}  // namespace zeroset
