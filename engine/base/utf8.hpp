#pragma once

#include <algorithm>
#include <cstddef>
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

}  // namespace zeroset
