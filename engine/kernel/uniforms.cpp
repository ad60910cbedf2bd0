#include "engine/kernel/uniforms.hpp"

#include "engine/real/scalar.hpp"

#include <algorithm>
#include <limits>

namespace zeroset {

void Uniforms::set(std::size_t item, double lo, double hi) {
    if (middle.size() <= item) {
        middle.resize(item + 1, 0.0F);
        neg_lo_hi.resize(2 * (item + 1), 0.0F);
        middle_double.resize(item + 1, 0.0);
        neg_lo_hi_double.resize(2 * (item + 1), 0.0);
    }
    // In this order of operands NaN stays.
    constexpr double lowest = std::numeric_limits<double>::lowest();
    const double neg_lo = std::max(-lo, lowest);
    const double up = std::max(hi, lowest);
    neg_lo_hi[2 * item] = float_above(neg_lo);
    neg_lo_hi[2 * item + 1] = float_above(up);
    neg_lo_hi_double[2 * item] = neg_lo;
    neg_lo_hi_double[2 * item + 1] = up;
    middle_double[item] = 0.5 * (lo + hi);
    middle[item] = static_cast<float>(middle_double[item]);
}

}  // namespace zeroset
