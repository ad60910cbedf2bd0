#pragma once

#include <string>
#include <string_view>

// Characters and how an error shows what was typed.

namespace zeroset {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The text in quotes for an error of one line: cut where it has more bytes than `longest`.
inline std::string quoted(std::string_view text, std::size_t longest = 40) {
    if (text.size() <= longest) return "'" + std::string(text) + "'";
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
        --end;  // not within a character
    return "'" + std::string(text.substr(0, end)) + "...'";
}

/// A number in a note, cut where it is long.
inline std::string shown_number(std::string_view number) {
    constexpr std::size_t longest = 20;
    return std::string(number.substr(0, longest)) + (number.size() > longest ? "..." : "");
}

}  // namespace zeroset
