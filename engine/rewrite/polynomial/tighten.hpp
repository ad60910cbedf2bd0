#pragma once

#include "engine/expr/expr.hpp"
#include "engine/rewrite/sample/box_sample.hpp"

namespace zeroset {

/// Returns the same function of the same parameters, its polynomials written such that interval
/// arithmetic encloses it tighter: of several forms (as typed, Horner, squares completed, ...) the
/// one that leaves a search for the zero set the least work on a sample of boxes. Equal in the
/// reals, and defined at the same points. Takes some milliseconds at most; a very large graph is
/// left as it is.
Expr tightened(const Expr& expr, const SampleRegion& region = {});

/// The time of a cell in a search for the zero set, roughly, in additions.
double time_of_cell(const Expr& expr);

}  // namespace zeroset
