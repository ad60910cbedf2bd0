#pragma once

#include <string>

// The numbers along an axis.

namespace zeroset {

/// The smallest of 1, 2, 5 x 10^n that is >= length; length > 0.
double tick_step(double length);

/// The number at a tick, with as many decimals as the step has: digits, ., e, +, - and, before a
/// number below 0, U+2212.
std::string tick_text(double value, double step);

/// Even steps along an axis: num / den, in units of pi where `of_pi`.
struct TickStep {
    double num = 1.0;
    double den = 1.0;
    bool of_pi = false;

    [[nodiscard]] double length() const;
    bool operator==(const TickStep&) const = default;
};

/// The smallest step that is at least `length` > 0: tick_step(length); or of pi, 1/12, 1/6, 1/4,
/// 1/2 and 1, 2, 5 x 10^n, unless the length is far below these.
TickStep tick_step_of(double length, bool of_pi);

/// The number at the k-th tick from 0, with the decimal mark of the language: as tick_text's, or a
/// multiple of pi in lowest terms.
std::string tick_label(double k, const TickStep& step);

/// Width of such a number, or of x, y or z, in DejaVu Sans, in em; of other words about, and hardly
/// ever too little. Known without the font.
double label_width_em(const std::string& text);

}  // namespace zeroset
