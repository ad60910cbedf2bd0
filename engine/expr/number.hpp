#pragma once

#include <string>
#include <string_view>

namespace zeroset {

/// The doubles nearest around a decimal number; equal when the number is a double.
struct NumberEnclosure {
    double lo;
    double hi;

    bool operator==(const NumberEnclosure&) const = default;
};

/// `digits` is a decimal literal: digits, at most one point, an optional exponent.
NumberEnclosure enclose_number(std::string_view digits);

/// The shortest literal found whose enclosure is this one.
std::string number_text(const NumberEnclosure& number);

}  // namespace zeroset
