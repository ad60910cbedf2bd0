#pragma once

#include "engine/real/elementary.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

// Properties of a carrier that the error bounds of the algebra need: its binary format, and its
// library's elementary functions.

namespace zeroset {

enum class RealType : std::uint8_t { Float, Double };

/// Every number but `far` and the bounds of the library is one of the format itself. It is all in
/// the header so that its readers are inlined: code in wide registers waits long when it calls code
/// compiled for narrow ones only.
struct Format {
    RealType type;
    double relative_gap;  ///< 2 ulp of 1: more than the relative distance of neighbours
    double smallest_normal;
    double largest_finite;
    double pi_lo;  ///< pi_lo and pi_hi: the neighbours around pi
    double pi_hi;
    double turns_per_radian;  ///< nearest to 1 / (2 pi)
    double turns_slack;       ///< above twice the error of turns_per_radian
    double far;               ///< operand size beyond which the phase of a wave is unknown
    double per_ln10;          ///< nearest to 1 / ln(10)
    double per_ln2;           ///< nearest to 1 / ln(2)
    LibraryBounds library;    ///< of the elementary functions that the carrier calls

    [[nodiscard]] constexpr const LibraryBound& bound(Elementary function) const {
        return library[static_cast<std::size_t>(function)];
    }
};

// 1 / (2 pi) is 0x1.45f306dc9c882a53f...p-3: the nearest float is off by 0.87 * 2^-27, the nearest
// double by 0.36 * 2^-55. At `far`, a period holds 50 floats, or 402 doubles.
inline constexpr Format float_format{.type = RealType::Float,
                                     .relative_gap = 0x1p-22,
                                     .smallest_normal = 0x1p-126,
                                     .largest_finite = 0x1.fffffep+127,
                                     .pi_lo = 0x1.921fb4p+1,
                                     .pi_hi = 0x1.921fb6p+1,
                                     .turns_per_radian = 0x1.45f306p-3,
                                     .turns_slack = 0x1p-21,
                                     .far = 0x1p20,
                                     .per_ln10 = 0x1.bcb7b2p-2,
                                     .per_ln2 = 0x1.715476p+0,
                                     .library = sleef_float_bounds};
inline constexpr Format double_format{.type = RealType::Double,
                                      .relative_gap = 0x1p-51,
                                      .smallest_normal = std::numeric_limits<double>::min(),
                                      .largest_finite = std::numeric_limits<double>::max(),
                                      .pi_lo = 0x1.921fb54442d18p+1,
                                      .pi_hi = 0x1.921fb54442d19p+1,
                                      .turns_per_radian = 0x1.45f306dc9c883p-3,
                                      .turns_slack = 0x1p-54,
                                      .far = 0x1p46,
                                      .per_ln10 = 0x1.bcb7b1526e50ep-2,
                                      .per_ln2 = 0x1.71547652b82fep+0,
                                      .library = sleef_double_bounds};

constexpr bool brackets_pi(const Format& format) {
    constexpr auto more_digits = std::numbers::pi_v<long double>;
    return static_cast<long double>(format.pi_lo) < more_digits &&
           more_digits < static_cast<long double>(format.pi_hi);
}
static_assert(brackets_pi(float_format) && brackets_pi(double_format));

constexpr const Format& format_of(float /*kind*/) { return float_format; }
constexpr const Format& format_of(double /*kind*/) { return double_format; }

/// Whether `value` is a number of the format.
inline bool representable(double value, const Format& format) {
    return format.type == RealType::Double ||
           static_cast<double>(static_cast<float>(value)) == value;
}

}  // namespace zeroset
