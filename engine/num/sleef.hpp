#pragma once

#include "engine/num/format.hpp"

#include <cstdint>

namespace zeroset {

/// Elementary functions taken from a library (engine/num/sleef_functions.def).
enum class Elementary : std::uint8_t {
#define ZEROSET_SLEEF(id, arity, name, accuracy, float_ulp, float_overflow, double_ulp, \
                      double_overflow)                                                  \
    id,
#include "engine/num/sleef_functions.def"
#undef ZEROSET_SLEEF
};

int elementary_arity(Elementary function);

/// Results of the functions below are within this many ulp of the true value (tested), but for
/// infinite results where the true value's size is at least `elementary_overflow`.
double elementary_bound_ulp(Elementary function, RealType type = RealType::Float);
double elementary_overflow(Elementary function, RealType type = RealType::Float);

/// Address of native code over `lanes` numbers: one or two vectors in registers to one vector (1
/// lane: a plain number), C calling convention, rounds to nearest and returns in upward rounding.
/// Registers of 128 bits (4 floats, 2 doubles) are had everywhere; nullptr when this machine
/// cannot: 256 bits need AVX2 and FMA, 512 AVX-512. Atan2 takes (y, x).
const void* elementary_code(Elementary function, int lanes, RealType type = RealType::Float);

/// One lane of that code, with the same bits, in round-to-nearest whatever the caller's mode.
float one_lane(Elementary function, float a, float b = 0.0F);
double one_lane(Elementary function, double a, double b = 0.0);

/// By MPFR, correctly rounded to nearest whatever the caller's mode; slow.
double correctly_rounded(Elementary function, double a, double b = 0.0);

/// What the algebra takes over single numbers. A float is a lane of a kernel. A double is what is
/// computed once, constants and single points: it does not depend on the machine.
inline float elementary(Elementary function, float a, float b = 0.0F) {
    return one_lane(function, a, b);
}
inline double elementary(Elementary function, double a, double b = 0.0) {
    return correctly_rounded(function, a, b);
}

}  // namespace zeroset
