#pragma once

#include "engine/special/line_field.hpp"
#include "engine/special/special.hpp"
#include "tests/support/mpfr_number.hpp"

namespace zeroset::test {

/// A special function by other means than the program's: MPFR's own functions, integrals for I and
/// K, bisection for W. Unknown where these take long.
Reference special_reference(SpecialFunction function, int order, const MpfrNumber& x);
/// That of a field which is no derivative.
Reference special_reference(const LineField& field, const MpfrNumber& x);

}  // namespace zeroset::test
