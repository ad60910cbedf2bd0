#pragma once

#include "engine/expr/op.hpp"
#include "engine/num/interval.hpp"

namespace zeroset {

/// The values of a step that matter: outside the band, only on which side the value lies does.
struct Band {
    double lo, hi;

    static constexpr Band everything() { return {.lo = -infinity, .hi = infinity}; }
    /// The band of a value that nobody asks for.
    static constexpr Band nothing() { return {.lo = everything().hi, .hi = everything().lo}; }
    [[nodiscard]] constexpr bool empty() const { return lo > hi; }
};

/// The band of an operand that min, max or a smooth minimum may take, from that of the result: an
/// operand above hi + 1 has no part in a smooth minimum of at most hi.
constexpr Band band_of_alternative(Op op, const Band& band) {
    return op == Op::SmoothMin ? Band{.lo = band.lo, .hi = band.hi + 1} : band;
}

}  // namespace zeroset
