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

/// A row of the table of elementary functions. It is here for its readers to be inlined: code in
/// wide registers waits long where it calls code that knows of narrow ones only.
struct ElementaryRow {
    int arity;
    std::array<double, 2> bound_ulp;  ///< by RealType
    std::array<double, 2> overflow;
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

/// Results of the functions below are within this many ulp of the true value (tested), but for
/// infinite results where the true value's size is at least `elementary_overflow`.
constexpr double elementary_bound_ulp(Elementary function, RealType type = RealType::Float) {
    return elementary_row(function).bound_ulp[static_cast<std::size_t>(type)];
}
constexpr double elementary_overflow(Elementary function, RealType type = RealType::Float) {
    return elementary_row(function).overflow[static_cast<std::size_t>(type)];
}

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
