#include "engine/volume/files/base64.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {
namespace {

/// A character of base64 stands for a number below 64, or for one of these.
constexpr std::uint8_t base64_space = 64, base64_padding = 65, no_base64 = 66;
constexpr std::array<std::uint8_t, 256> base64_digits = [] {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<std::uint8_t, 256> table{};
    table.fill(no_base64);
    for (std::size_t i = 0; i < digits.size(); ++i)
        table[static_cast<unsigned char>(digits[i])] = static_cast<std::uint8_t>(i);
    for (const char c : {' ', '\t', '\r', '\n'})
        table[static_cast<unsigned char>(c)] = base64_space;
    table['='] = base64_padding;
    return table;
}();

}  // namespace

std::optional<std::string> from_base64(std::string_view text) {
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    unsigned count = 0;
    for (const char c : text) {
        const std::uint8_t digit = base64_digits[static_cast<unsigned char>(c)];
        if (digit == base64_space) continue;
        if (digit == no_base64) return std::nullopt;
        if (digit == base64_padding) {
            count = 0;
            continue;
        }
        bits = bits << 6U | digit;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xFFU);
    }
    return bytes;
}

}  // namespace zeroset
