#include "document/json/share_text.hpp"

#include "document/json/document_json.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/export/packed.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace zeroset {
namespace {

constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// Each 6 bits as a letter, without padding.
std::string base64(std::span<const std::uint8_t> bytes) {
    std::string text;
    std::uint32_t bits = 0;
    unsigned count = 0;
    for (const std::uint8_t byte : bytes) {
        bits = bits << 8U | byte;
        for (count += 8; count >= 6; count -= 6)
            text += digits[bits >> (count - 6) & 0x3FU];
    }
    if (count > 0) text += digits[bits << (6 - count) & 0x3FU];
    return text;
}

/// The bytes; nullopt where a letter is none of base64url's. Blanks and line ends do not count.
std::optional<std::vector<std::uint8_t>> bytes_of(std::string_view text) {
    std::vector<std::uint8_t> bytes;
    std::uint32_t bits = 0;
    unsigned count = 0;
    for (const char letter : text) {
        if (std::isspace(static_cast<unsigned char>(letter)) != 0) continue;
        const std::size_t digit = digits.find(letter);
        if (digit == std::string_view::npos) return std::nullopt;
        bits = bits << 6U | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<std::uint8_t>(bits >> count & 0xFFU));
    }
    return bytes;
}

}  // namespace

std::string share_text(const Document& document) {
    const auto json = nlohmann::ordered_json::parse(text_of(document));
    return std::string(share_prefix) + base64(packed(json.dump()));
}

bool is_share_text(std::string_view text) { return trimmed(text).starts_with(share_prefix); }

std::expected<std::string, std::string> shared_json(std::string_view text) {
    const auto bytes = bytes_of(trimmed(text).substr(share_prefix.size()));
    const auto json = bytes ? unpacked(*bytes) : std::nullopt;
    if (!json)
        return std::unexpected(tr("it is damaged: copy all of the text that begins with zeroset:"));
    return *json;
}

}  // namespace zeroset
