#pragma once

#include "engine/expr/patch_graph.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/view/box.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/picture_request.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace zeroset {

/// The code that draws a parametric surface, a curve or a point in a clip box, which says how thick
/// curves and points are: interpreted until it has been used for long enough.
Kernel patch_code(const PatchGraphs& graphs, const Box& clip);

/// The formula that is drawn for what a row shows: that of a meeting is a tube, all others are
/// themselves.
Expr drawn_formula(const Expr& surface, const Box& clip);

/// The error of what knows only equations, if a picture shows a parametric surface, a curve or a
/// point; nothing where it does not.
std::optional<InputError> patch_refusal(const PictureRequest& request, std::string reason);

}  // namespace zeroset
