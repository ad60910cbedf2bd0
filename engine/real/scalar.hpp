#pragma once

#include "engine/real/format.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

// The operations that the algebra (interval.hpp, elementary.hpp and dual.hpp of engine/num)
// requires of its carrier, for float and double; format_of (engine/real/format.hpp) belongs to
// them. jit/llvm/lanes.hpp implements them for vectors of an IR under construction. Both must agree
// to the bit: the comments name the machine instruction whose meaning they share.

namespace zeroset {

/// `value` as the type of the first argument; `value` must be representable in it.
inline float like(float /*kind*/, double value) { return static_cast<float>(value); }
inline double like(double /*kind*/, double value) { return value; }

/// The smallest float that is not below `value`, in any rounding mode.
inline float float_above(double value) {
    const auto near = static_cast<float>(value);
    if (static_cast<double>(near) >= value) return near;
    return std::nextafter(near, std::numeric_limits<float>::infinity());
}

/// The upper end, in the carrier's type, of the smallest enclosure of `value`.
inline float upper_end(float /*kind*/, double value) { return float_above(value); }
inline double upper_end(double /*kind*/, double value) { return value; }

/// Maximum and minimum; the second argument where both are equal or unordered (x86 MAXPS, MINPS).
template <class Real>
    requires std::is_floating_point_v<Real>
Real maximum(Real a, Real b) {
    return a > b ? a : b;
}
template <class Real>
    requires std::is_floating_point_v<Real>
Real minimum(Real a, Real b) {
    return a < b ? a : b;
}

template <class Real>
    requires std::is_floating_point_v<Real>
Real select(bool condition, Real if_true, Real if_false) {
    return condition ? if_true : if_false;
}

/// `if_set` where the sign bit of x is set, as that of -0 is; else `if_clear` (x86 BLENDVPS).
template <class Real>
    requires std::is_floating_point_v<Real>
Real select_negative(Real x, Real if_set, Real if_clear) {
    return std::signbit(x) ? if_set : if_clear;
}

template <class Real>
    requires std::is_floating_point_v<Real>
bool unordered(Real a, Real b) {
    return std::isunordered(a, b);
}

/// Square root, rounded in the current mode.
template <class Real>
    requires std::is_floating_point_v<Real>
Real square_root(Real a) {
    return std::sqrt(a);
}
/// a b + c, rounded once or twice.
template <class Real>
    requires std::is_floating_point_v<Real>
Real fused(Real a, Real b, Real c) {
    return a * b + c;
}
template <class Real>
    requires std::is_floating_point_v<Real>
Real magnitude(Real a) {
    return std::fabs(a);
}
template <class Real>
    requires std::is_floating_point_v<Real>
Real round_down(Real a) {
    return std::floor(a);
}

inline bool both(bool a, bool b) { return a && b; }
inline bool either(bool a, bool b) { return a || b; }
inline bool no(bool a) { return !a; }
/// Whether the masks are known to be the same.
inline bool identical(bool a, bool b) { return a == b; }

}  // namespace zeroset
