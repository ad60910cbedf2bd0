#pragma once

#include "engine/special/line_field.hpp"

// The functions of special.hpp as pieces; the comments at each tell why its bounds hold.

namespace zeroset {

PiecedLine erf_line();
PiecedLine erfc_line();

/// 1/gamma, which has no poles.
PiecedLine reciprocal_gamma_line();
/// ln(gamma(x)) and its derivative for x > 0.
PiecedLine log_gamma_line();
PiecedLine digamma_line();

/// (x - 1) zeta(x)
PiecedLine zeta_line();
/// The principal branch of Lambert's W at (p^2 - 1)/e.
PiecedLine lambert_line();

/// Bessel functions of a whole order from 0 to `highest_bessel_order`.
PiecedLine bessel_j_line(int order);
PiecedLine bessel_y_line(int order);
PiecedLine bessel_i_line(int order);
PiecedLine bessel_k_line(int order);

}  // namespace zeroset
