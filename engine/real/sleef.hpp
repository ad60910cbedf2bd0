#pragma once

#include "engine/real/elementary.hpp"
#include "engine/real/format.hpp"

namespace zeroset {

/// Address of native code of SLEEF over `lanes` numbers in the C calling convention: one or two
/// vectors in registers to one vector (1 lane: a plain number). It rounds to nearest and returns in
/// upward rounding. Atan2 takes (y, x). Registers of 128 bits (4 floats, 2 doubles) exist on every
/// machine, 256 bits need AVX2 and FMA, 512 bits AVX-512; nullptr where the machine lacks them.
const void* elementary_code(Elementary function, int lanes, RealType type = RealType::Float);

/// One lane of elementary_code, with the same bits, in round-to-nearest whatever the caller's mode.
float one_lane(Elementary function, float a, float b = 0.0F);
double one_lane(Elementary function, double a, double b = 0.0);

/// The value by MPFR, correctly rounded to nearest whatever the caller's mode; slow.
double correctly_rounded(Elementary function, double a, double b = 0.0);

/// The elementary functions of the algebra over single numbers. A float is treated as a lane of a
/// kernel. Doubles are computed once, for constants and single points, and do not depend on the
/// machine.
inline float elementary(Elementary function, float a, float b = 0.0F) {
    return one_lane(function, a, b);
}
inline double elementary(Elementary function, double a, double b = 0.0) {
    return correctly_rounded(function, a, b);
}

}  // namespace zeroset
