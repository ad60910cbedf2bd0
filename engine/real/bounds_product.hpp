#pragma once

#include "engine/real/field_answers.hpp"

namespace zeroset {

/// The bounds of the products of numbers within these bounds, as the rounding mode rounds.
inline ValueBounds product_of(const ValueBounds& a, const ValueBounds& b) {
    ValueBounds hull{.lo = a.lo * b.lo, .hi = a.lo * b.lo};
    for (const double product : {a.lo * b.hi, a.hi * b.lo, a.hi * b.hi})
        hull.add({.lo = product, .hi = product});
    return hull;
}

}  // namespace zeroset
