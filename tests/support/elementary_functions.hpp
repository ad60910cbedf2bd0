#pragma once

#include "engine/expr/op.hpp"
#include "engine/real/format.hpp"
#include "engine/real/sleef.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

// Helpers for the tests of the library's elementary functions: their names, close values by the C
// library in a wider type, and calls of their code at every width.

namespace zeroset::test {

/// A type wide enough for its C library functions to count as exact here.
template <class Real>
using Wide = std::conditional_t<sizeof(Real) == 4, double, long double>;
template <class Real>
using Pattern = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

template <class Real>
constexpr RealType type_of = format_of(Real{}).type;

template <class Real>
struct Function {
    Elementary id;
    Op op;
    const char* name;
    Wide<Real> (*close)(Wide<Real>, Wide<Real>);  ///< close values, by the C library
};

/// The operator of the same name, which the MPFR reference knows.
inline Op op_of(Elementary function) {
    if (function == Elementary::Cbrt) return Op::OddRoot;
    static constexpr std::string_view names[] = {
#define ZEROSET_SLEEF(id, arity, name, accuracy, float_ulp, float_overflow, double_ulp, \
                      double_overflow)                                                  \
    #id,
#include "engine/real/sleef_functions.def"
#undef ZEROSET_SLEEF
    };
    return std::ranges::find(operators(), names[static_cast<std::size_t>(function)], &OpInfo::name)
        ->op;
}

template <class Real>
const std::vector<Function<Real>>& functions() {
    using W = Wide<Real>;
    static const std::vector<Function<Real>> all = {
#define ZEROSET_SLEEF(id, arity, name, accuracy, float_ulp, float_overflow, double_ulp, \
                      double_overflow)                                                  \
    {Elementary::id, op_of(Elementary::id), #name, ZEROSET_CLOSE_##arity(name)},
#define ZEROSET_CLOSE_1(name) [](W a, W) { return std::name(a); }
#define ZEROSET_CLOSE_2(name) [](W a, W b) { return std::name(a, b); }
#include "engine/real/sleef_functions.def"
#undef ZEROSET_SLEEF
#undef ZEROSET_CLOSE_1
#undef ZEROSET_CLOSE_2
    };
    return all;
}

template <class Real>
Real from_bits(std::uint64_t bits) {
    return std::bit_cast<Real>(static_cast<Pattern<Real>>(bits));
}

/// Number of lanes of the widest registers.
inline constexpr std::size_t most_lanes = 16;
/// A function that calls code of one or two operands with one register of `a` and of `b`.
template <class Real>
using Caller = void (*)(void* code, int arity, const Real* a, const Real* b, Real* out);

/// Callers for registers of 16, 32 and 64 bytes, each compiled for a machine that has them.
template <class Real>
void call_128(void* code, int arity, const Real* a, const Real* b, Real* out);
template <class Real>
void call_256(void* code, int arity, const Real* a, const Real* b, Real* out);
template <class Real>
void call_512(void* code, int arity, const Real* a, const Real* b, Real* out);

/// The code of a function over registers of one width, and how to call it.
template <class Real>
struct WideCode {
    void* code;  ///< nullptr where this machine has no such registers
    std::size_t lanes;
    Caller<Real> call;
};

/// The code for registers of 16, 32 or 64 bytes.
template <class Real>
WideCode<Real> wide_code(Elementary function, std::size_t bytes) {
    const std::size_t lanes = bytes / sizeof(Real);
    const void* const address = elementary_code(function, static_cast<int>(lanes), type_of<Real>);
    // Remove const, as a pointer to a function has none to keep.
    return {const_cast<void*>(address), lanes,
            bytes == 16   ? call_128<Real>
            : bytes == 32 ? call_256<Real>
                          : call_512<Real>};
}

}  // namespace zeroset::test
