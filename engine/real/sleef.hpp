#pragma once

#include "engine/real/format.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// Elementary functions taken from a library (engine/real/sleef_functions.def).
enum class Elementary : std::uint8_t {
#define ZEROSET_SLEEF(id, arity, name, accuracy, float_ulp, float_overflow, double_ulp, \
                      double_overflow)                                                  \
    id,
#include "engine/real/sleef_functions.def"
#undef ZEROSET_SLEEF
};

/// A row of the table of elementary functions. It is in the header so that its readers are inlined:
/// code in wide registers waits long when it calls code compiled for narrow ones only.
struct ElementaryRow {
    int arity;
    std::array<double, 2> bound_ulp;  ///< indexed by RealType
    std::array<double, 2> overflow;   ///< indexed by RealType
};

constexpr ElementaryRow elementary_row(Elementary function) {
    constexpr std::array rows{
#define ZEROSET_SLEEF(id, arity, name, accuracy, float_ulp, float_overflow, double_ulp, \
                      double_overflow)                                                  \
    ElementaryRow{arity, {float_ulp, double_ulp}, {float_overflow, double_overflow}},
#include "engine/real/sleef_functions.def"
#undef ZEROSET_SLEEF
    };
    return rows[static_cast<std::size_t>(function)];
}

constexpr int elementary_arity(Elementary function) { return elementary_row(function).arity; }

/// Error bound, in ulp, of the results of the functions below (tested). Only where the true value's
/// size is at least `elementary_overflow` may a result be infinite instead.
constexpr double elementary_bound_ulp(Elementary function, RealType type = RealType::Float) {
    return elementary_row(function).bound_ulp[static_cast<std::size_t>(type)];
}
constexpr double elementary_overflow(Elementary function, RealType type = RealType::Float) {
    return elementary_row(function).overflow[static_cast<std::size_t>(type)];
}

/// Address of native code over `lanes` numbers in the C calling convention: one or two vectors in
/// registers to one vector (1 lane: a plain number). It rounds to nearest and returns in upward
/// rounding. Atan2 takes (y, x). Registers of 128 bits (4 floats, 2 doubles) exist on every
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
