#pragma once

#include "engine/expr/expr.hpp"
#include "engine/rewrite/sample/box_sample.hpp"

namespace zeroset {

/// What is traced for f: a function with the same zero set and domain, and gradients that point the
/// same way at the zeros, in the form that is enclosed tightest. Takes some milliseconds at most; a
/// very large graph is left as it is.
Expr drawn_form(const Expr& expr, const SampleRegion& region = {});

}  // namespace zeroset
