#include "document/import/plain_text.hpp"

#include "engine/base/utf8.hpp"

#include <cstddef>
#include <cstdint>

namespace zeroset {
namespace {

/// Units of 16 bits, of which pairs may stand for one character, in UTF-8.
std::string from_utf16(std::string_view bytes, bool big_endian) {
    const auto unit = [&](std::size_t at) {
        const auto first = static_cast<unsigned char>(bytes[at]);
        const auto second = static_cast<unsigned char>(bytes[at + 1]);
        return big_endian ? std::uint32_t{first} << 8U | second
                          : std::uint32_t{second} << 8U | first;
    };
    constexpr std::uint32_t replacement = 0xFFFD;
    std::string text;
    for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
        std::uint32_t code = unit(at);
        if (code >> 11U == 0xD800U >> 11U) {  // half of a pair
            const std::uint32_t low = at + 3 < bytes.size() ? unit(at + 2) : 0;
            const bool is_pair = code < 0xDC00U && low >> 10U == 0xDC00U >> 10U;
            if (is_pair) at += 2;
            code = is_pair ? 0x10000U + ((code & 0x3FFU) << 10U | (low & 0x3FFU)) : replacement;
        }
        add_character(text, code);
    }
    return text;
}

}  // namespace

std::string plain_text(std::string_view bytes) {
    std::string text;
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) {
        text = from_utf16(bytes.substr(2), bytes.starts_with('\xfe'));
    } else {
        text = bytes.substr(bytes.starts_with("\xef\xbb\xbf") ? 3 : 0);
    }
    for (std::size_t at = 0; at < text.size(); ++at) {
        const bool alone = text[at] == '\r' && (at + 1 == text.size() || text[at + 1] != '\n');
        if (alone) text[at] = '\n';
    }
    return text;
}

}  // namespace zeroset
