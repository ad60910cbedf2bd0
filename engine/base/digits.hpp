#pragma once

#include <array>
#include <charconv>
#include <string>

namespace zeroset {

/// The shortest text that is read as this number.
inline std::string digits_of(double number) {
    std::array<char, 32> digits{};
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    return {digits.data(), written.ptr};
}

}  // namespace zeroset
