#include "engine/expr/kernel.hpp"

#include "engine/num/scalar.hpp"

namespace zeroset {

void Uniforms::set(std::size_t item, double lo, double hi) {
    if (middle.size() <= item) {
        middle.resize(item + 1, 0.0F);
        neg_lo_hi.resize(2 * (item + 1), 0.0F);
    }
    neg_lo_hi[2 * item] = float_above(-lo);
    neg_lo_hi[2 * item + 1] = float_above(hi);
    middle[item] = static_cast<float>(0.5 * (lo + hi));
}

}  // namespace zeroset
