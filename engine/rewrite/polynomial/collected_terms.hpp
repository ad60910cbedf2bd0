#pragma once

#include "engine/expr/expr.hpp"
#include "engine/rewrite/sample/box_sample.hpp"

namespace zeroset {

/// A long polynomial with equal monomials added up, nested in the way that beams are likely traced
/// through soonest in the region; the formula itself where it is none, or short, or that saves
/// little. Equal in the reals. A sum of 500 terms in numbers that have names becomes one of 200.
Expr with_collected_terms(const Expr& expr, const SampleRegion& region);

}  // namespace zeroset
