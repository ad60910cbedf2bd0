#pragma once

#include "engine/expr/expr.hpp"
#include "engine/expr/patch_graph.hpp"

#include <array>
#include <cstddef>

namespace zeroset {

/// Number of uniforms that tell how thick one curve or point is drawn: its radius at p is
/// q0 + q1 p.x + q2 p.y + q3 p.z, so that a view in perspective can have it equally thick on the
/// picture.
inline constexpr std::size_t thickness_uniforms = 4;

/// The coordinates of a surface over the unit square in x and y that shows a parametric surface, a
/// curve as a tube with open ends, a segment as a closed one, an arrow with a head, or a point as a
/// ball. `thickness`: the first of its uniforms, counted as parameters from 0 on.
std::array<Expr, 3> shown_patch(const PatchGraphs& graphs, std::size_t thickness);

/// A function that is 0 on a tube of about its radius about the curve in which two surfaces meet,
/// as far as these are flat within it: below 0 inside.
Expr meeting_tube(const PatchGraphs& graphs, std::size_t thickness);

}  // namespace zeroset
