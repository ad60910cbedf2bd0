#pragma once

#include <cstdint>

namespace zeroset {

/// Elementary functions taken from a library (engine/num/sleef_functions.def).
enum class Elementary : std::uint8_t {
#define ZEROSET_SLEEF(id, arity, name, accuracy, bound_ulp, overflow) id,
#include "engine/num/sleef_functions.def"
#undef ZEROSET_SLEEF
};

int elementary_arity(Elementary function);

/// Results of the functions below are within this many ulp of the true value (tested), but for
/// infinite results where the true value's size is at least `elementary_overflow`.
double elementary_bound_ulp(Elementary function);
double elementary_overflow(Elementary function);

/// The function over float, in round-to-nearest whatever the caller's mode. Bit-equal to the
/// lanes of `elementary_code`. Atan2 takes (y, x).
float elementary(Elementary function, float a, float b = 0.0F);

/// The same in double, correctly rounded to nearest by MPFR, and slow: for what is computed once.
double elementary(Elementary function, double a, double b = 0.0);

/// Address of native code over `lanes` floats: one or two vectors in registers to one vector (1
/// lane: a plain float), C calling convention, rounds to nearest and returns in upward rounding.
/// nullptr when this machine cannot: 8 needs AVX2 and FMA, 16 AVX-512.
const void* elementary_code(Elementary function, int lanes);

}  // namespace zeroset
