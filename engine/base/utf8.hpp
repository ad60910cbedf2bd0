#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

// Characters of UTF-8 text, each a sequence of bytes.

namespace zeroset {

/// Whether a byte goes on with the character of the byte before it.
constexpr bool continues_character(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// The end of the character that begins at byte `at`; at most the text's size.
constexpr std::size_t end_of_character(std::string_view text, std::size_t at) {
    ++at;
    while (at < text.size() && continues_character(text[at]))
        ++at;
    return std::min(at, text.size());
}

/// Where the character begins that ends at byte `at`; 0 for 0.
constexpr std::size_t character_before(std::string_view text, std::size_t at) {
    while (at > 0 && continues_character(text[--at])) {
    }
    return at;
}

/// Adds a character of Unicode in UTF-8.
inline void add_character(std::string& text, std::uint32_t code) {
    const auto byte = [&](std::uint32_t bits) { text += static_cast<char>(bits); };
    const auto further = [&](unsigned shift) { byte(0x80U | (code >> shift & 0x3FU)); };
    if (code < 0x80U) return byte(code);
    if (code < 0x800U) {
        byte(0xC0U | code >> 6U);
    } else if (code < 0x10000U) {
        byte(0xE0U | code >> 12U);
        further(6);
    } else {
        byte(0xF0U | code >> 18U);
        further(12);
        further(6);
    }
    further(0);
}

}  // namespace zeroset
