#pragma once

#include "engine/expr/expr.hpp"
#include "engine/rewrite/sample/box_sample.hpp"

namespace zeroset {

/// Returns a function of the same zero set, domain and sign without the poles that lie along
/// surfaces of the region: f is brought to N / D, which becomes Oriented(N, D), where sums,
/// products and powers of quotients and tangents allow it. Gradients there point the same way as
/// those of f. A division by what vanishes in the region at most along curves stays: its poles are
/// cheap, and N would be wider.
Expr without_poles(const Expr& expr, const SampleRegion& region = {});

}  // namespace zeroset
