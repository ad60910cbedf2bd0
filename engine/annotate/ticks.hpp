#pragma once

#include <string>

// The numbers along an axis.

namespace zeroset {

/// The smallest of 1, 2, 5 x 10^n that is >= length; length > 0.
double tick_step(double length);

/// The number at a tick, with as many decimals as the step has: digits, ., e, +, - and, before a
/// number below 0, U+2212.
std::string tick_text(double value, double step);

/// Width of such a number, or of x, y or z, in DejaVu Sans, in em; of other words about, and hardly
/// ever too little. Known without the font.
double label_width_em(const std::string& text);

}  // namespace zeroset
