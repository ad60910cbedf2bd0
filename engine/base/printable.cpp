#include "engine/base/text.hpp"
#include "engine/base/utf8.hpp"

#include <cstddef>

namespace zeroset {
namespace {

struct Character {
    int code;  ///< -1: the byte begins no character of UTF-8
    std::size_t size;
};

Character character_at(std::string_view text, std::size_t at) {
    constexpr Character none{.code = -1, .size = 1};
    const auto first = static_cast<unsigned char>(text[at]);
    if (first < 0x80U) return {.code = first, .size = 1};
    const std::size_t size = first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
    if (first < 0xC2U || first > 0xF4U || text.size() - at < size) return none;
    unsigned code = first & (0x7FU >> size);
    for (const char byte : text.substr(at + 1, size - 1)) {
        if (!continues_character(byte)) return none;
        code = code << 6U | (static_cast<unsigned char>(byte) & 0x3FU);
    }
    const unsigned least = size == 2 ? 0x80U : size == 3 ? 0x800U : 0x10000U;
    const bool is_surrogate = code >= 0xD800U && code < 0xE000U;
    if (code < least || is_surrogate || code > 0x10FFFFU) return none;
    return {.code = static_cast<int>(code), .size = size};
}

/// Whether the character is a control of C0 or C1, or one that begins a line or turns the direction
/// of writing.
bool is_control(int code) {
    return code < ' ' || (code >= 0x7F && code < 0xA0) || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string printable(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const auto [code, size] = character_at(text, at);
        if (is_control(code)) {
            result += "\uFFFD";
        } else {
            result += text.substr(at, size);
        }
        at += size;
    }
    return result;
}

}  // namespace zeroset
