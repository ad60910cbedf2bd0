#pragma once

#include "engine/real/field.hpp"

#include <cstdint>
#include <memory>

namespace zeroset {

/// Functions of a real number that are no formulas. Each is known as a `LineField`.
enum class SpecialFunction : std::uint8_t {
    Erf,
    Erfc,
    ReciprocalGamma,  ///< 1/gamma(x)
    LogGamma,         ///< ln(gamma(x)), for x > 0
    Digamma,          ///< its derivative
    ZetaTimes,        ///< (x - 1) zeta(x)
    LambertOfRoot,    ///< W((x^2 - 1)/e)
    BesselJ,
    BesselY,  ///< for x > 0
    BesselI,
    BesselK,  ///< for x > 0
};

inline constexpr int highest_bessel_order = 100;

/// The function, of an order from 0 to `highest_bessel_order` for Bessel's: the same object each
/// time, so that code made for it is found again. Its operand is the first of the field's.
std::shared_ptr<const Field> special_field(SpecialFunction function, int order = 0);

}  // namespace zeroset
