#pragma once

#include "engine/real/field_answers.hpp"
#include "engine/real/unbounded.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace zeroset {

/// A rectangle of complex numbers about a part of the real line.
struct ComplexBox {
    double from, to;  ///< real parts
    double height;    ///< the largest imaginary part

    /// A bound of |z| in it.
    [[nodiscard]] double radius() const {
        return 1.0001 * std::hypot(std::max(std::abs(from), std::abs(to)), height);
    }
};

/// A real function of x >= 0, or of x > 0, that is analytic there, with all that must be known of
/// it to replace it by polynomials with proved errors (pieces.hpp).
struct Analytic {
    /// f(x) to `x`'s precision, some 115 bits, but for a few of the last.
    std::function<void(mpfr_ptr result, mpfr_srcptr x)> value;
    /// ln of a bound of |f| in a box; infinite where none is known.
    std::function<double(const ComplexBox& box)> log_bound;
    /// Pieces begin at 2^first, or at 0. From there on, 2^n to 2^(n+1) has 8 or more equal ones.
    int first = 0;
    bool from_zero = true;
    double widest = unbounded;  ///< of pieces, a power of 2
    double end = 0;             ///< where pieces end
    /// Bounds of the derivative of an order anywhere from `end` on.
    std::function<ValueBounds(int order)> beyond;
    /// Where much of what lies beyond `far` is asked for, its pieces are not made for that: there
    /// the bounds of a derivative anywhere stand for them; none: nothing is known.
    double far = 32;
    std::function<ValueBounds(int order)> everywhere{};
    /// The sign of the infinity to which f tends at 0. It is monotone below the first piece, as are
    /// its derivatives, whose infinities have signs in turn.
    int sign_at_zero = 0;
};

}  // namespace zeroset
