#pragma once

#include "engine/expr/expr.hpp"
#include "engine/rewrite/sample/box_sample.hpp"

// The passes that write the same function better; traceable.cpp has their order. Each has a source
// of its own.

namespace zeroset {

/// Returns a function of the same zero set, domain and sign without the poles that lie along
/// surfaces of the region: f is brought to N / D, which becomes Oriented(N, D), where sums,
/// products and powers of quotients and tangents allow it. Gradients there point the same way as
/// those of f. A division by what vanishes in the region at most along curves stays: its poles are
/// cheap, and N would be wider.
Expr without_poles(const Expr& expr, const SampleRegion& region = {});

/// Returns the same function with the continuous Op::Fold for remainders whose jumps make no jump:
/// people repeat shapes by abs(mod(x, d) - d/2) and (mod(x, d) - d/2)^2.
Expr with_folds(const Expr& expr);

/// Returns the same function, with LogSum for logarithms of sums of exponentials, as smooth minima
/// are made of: ln(exp(-k a) + exp(-k b)). The exponentials of large operands overflow, and their
/// enclosures are far wider than what the logarithm makes of them.
Expr with_log_sums(const Expr& expr);

/// Returns the same function with min, max, if and where moved out of negations, of sums with what
/// depends on no choice, and of multiples, where each is used once: -min(a, b) + c becomes max(-a +
/// c, -b + c), so that less is left between choices and parts (engine/tape/parts.hpp). Values are
/// rounded as before, but for constants that come together.
Expr with_outer_choices(const Expr& expr);

/// Returns the same function, also where it is defined, with as few comparisons as it needs: people
/// write the cells of a lattice as sums of if(abs(x - 2/3) < 1/9, 1, 0) and ask whether the sum is
/// 0. Comparisons with constants lose what is added to the other side, its factors, its absolute
/// values and the choices and sums of whole numbers in it; conditions that are always true or never
/// are left out, products of choices of 1 and 0 are one choice.
Expr with_plain_conditions(const Expr& expr);

/// Returns the same function, its angles from lengths taken by atan2, whose slope has no end:
/// acos(a / r) is atan2(sqrt(T), a) where r is sqrt(a^2 + T) and T a sum of squares, and asin(a /
/// r) is atan2(a, sqrt(T)). Both are undefined where r is 0.
Expr plain_angles(const Expr& expr);

/// Returns the same function, with Length for square roots of sums of squares, and AngleSin and
/// AngleCos for sines and cosines of whole multiples of angles.
Expr polar_form(const Expr& expr);

/// Puts SmoothMin in place of quadratic smooth minima and maxima of constant width, as
/// min(a, b) - h^2/(4k) with h = max(k - |a - b|, 0); the values stay. Its enclosure is tight,
/// where that of the difference is wider the more often it is nested.
Expr with_smooth_minima(const Expr& expr);

}  // namespace zeroset
