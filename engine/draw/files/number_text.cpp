#include "engine/draw/files/encoders.hpp"

#include <array>
#include <charconv>

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

}  // namespace zeroset
