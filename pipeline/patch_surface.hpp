#pragma once

#include "document/document.hpp"
#include "engine/expr/expr.hpp"
#include "engine/expr/patch_graph.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/view/box.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/picture_request.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

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

/// The code that draws a parametric surface, a curve or a point: interpreted until it has been used
/// for long enough. `thickness`: as in shown_patch.
Kernel patch_code(const PatchGraphs& graphs, std::size_t thickness);

/// The formula that is drawn for what a row shows: that of a meeting is a tube, all others are
/// themselves. `thickness`: as in meeting_tube.
Expr drawn_formula(const Expr& surface, std::size_t thickness);

/// The radius of a curve or a point, as its uniforms tell it to a formula.
using ThicknessUniforms = std::array<double, thickness_uniforms>;

/// How thick a curve or a point is drawn: as wide as `chosen` says, or as suits the clip box. In
/// pixels it is so wide in a picture of this height from this camera.
ThicknessUniforms thickness_of(PatchKind kind, const std::optional<Thickness>& chosen,
                               const Box& clip, const Camera& camera, int height_px);

/// The error of what knows only equations, if a picture shows a parametric surface, a curve or a
/// point; nothing where it does not.
std::optional<InputError> patch_refusal(const PictureRequest& request, std::string reason);

}  // namespace zeroset
