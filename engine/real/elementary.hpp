#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// Elementary functions that each carrier takes from a library (SLEEF:
/// engine/real/sleef_functions.def).
enum class Elementary : std::uint8_t {
#define ZEROSET_SLEEF(id, arity, name, accuracy, float_ulp, float_overflow, double_ulp, \
                      double_overflow)                                                  \
    id,
#include "engine/real/sleef_functions.def"
#undef ZEROSET_SLEEF
};

constexpr int elementary_arity(Elementary function) {
    constexpr std::array arities{
#define ZEROSET_SLEEF(id, arity, name, accuracy, float_ulp, float_overflow, double_ulp, \
                      double_overflow)                                                  \
    arity,
#include "engine/real/sleef_functions.def"
#undef ZEROSET_SLEEF
    };
    return arities[static_cast<std::size_t>(function)];
}

/// Bounds of a library function's results.
struct LibraryBound {
    double ulp;       ///< of the error, where the result is finite
    double overflow;  ///< true values from this size on may come out infinite
};

/// Bounds of all elementary functions of a library, indexed by Elementary.
using LibraryBounds = std::array<LibraryBound, static_cast<std::size_t>(Elementary::Atanh) + 1>;

/// Bounds of SLEEF's functions for float (tested).
inline constexpr LibraryBounds sleef_float_bounds{{
#define ZEROSET_SLEEF(id, arity, name, accuracy, float_ulp, float_overflow, double_ulp, \
                      double_overflow)                                                  \
    {float_ulp, float_overflow},
#include "engine/real/sleef_functions.def"
#undef ZEROSET_SLEEF
}};

/// Bounds of SLEEF's functions for double (tested).
inline constexpr LibraryBounds sleef_double_bounds{{
#define ZEROSET_SLEEF(id, arity, name, accuracy, float_ulp, float_overflow, double_ulp, \
                      double_overflow)                                                  \
    {double_ulp, double_overflow},
#include "engine/real/sleef_functions.def"
#undef ZEROSET_SLEEF
}};

}  // namespace zeroset
