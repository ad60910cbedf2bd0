#include "engine/draw/files/encoders.hpp"

#include <array>
#include <charconv>
#include <cstddef>

namespace zeroset {

std::string file_number(double number, int decimals) {
    std::array<char, 64> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                   std::chars_format::fixed, decimals);
    if (end.ec != std::errc()) return "0";
    std::string text(digits.data(), end.ptr);
    if (text.contains('.')) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.ends_with('.')) text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string hex_digits(std::uint32_t color) {
    constexpr const char* digits = "0123456789ABCDEF";
    std::string text;
    for (int shift = 20; shift >= 0; shift -= 4)
        text += digits[static_cast<std::size_t>(color >> static_cast<unsigned>(shift) & 15U)];
    return text;
}

}  // namespace zeroset
