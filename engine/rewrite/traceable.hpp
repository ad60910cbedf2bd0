#pragma once

#include "engine/expr/expr.hpp"
#include "engine/rewrite/sample/box_sample.hpp"

namespace zeroset {

/// The function that is traced for f: it has the same zero set and domain, but for limits in place
/// of 0/0 (differences/removable_poles.hpp), gradients that point the same way at the zeros, and is
/// written so that it is enclosed tightest. Takes some milliseconds at most; a very large graph is
/// left as it is.
Expr traceable(const Expr& expr, const SampleRegion& region = {});

}  // namespace zeroset
