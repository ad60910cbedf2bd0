#include "engine/base/text.hpp"

#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace zeroset {
namespace {

/// Whether a byte of UTF-8 text is the first of its character.
bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

}  // namespace

std::string_view line_at(std::string_view text, std::size_t offset) {
    offset = std::min(offset, text.size());
    const std::size_t before = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    return text.substr(begin, text.find('\n', begin) - begin);
}

std::size_t column_of(std::string_view text, std::size_t offset) {
    const std::string_view line = line_at(text, offset);
    const auto start = static_cast<std::size_t>(line.data() - text.data());
    const std::string_view before = text.substr(start, std::min(offset, text.size()) - start);
    return 1 + static_cast<std::size_t>(std::ranges::count_if(before, starts_character));
}

Excerpt excerpt(std::string_view line, std::size_t caret) {
    constexpr std::size_t context = 50;
    const std::size_t first = caret > context ? caret - context : 0;
    Excerpt part{.text = first > 0 ? "..." : "", .caret = caret - first};
    part.caret += part.text.size();
    std::size_t index = 0;
    for (const char c : line) {
        if (starts_character(c)) ++index;
        if (index <= first) continue;
        if (index > first + 2 * context) {
            part.text += "...";
            break;
        }
        part.text += c == '\t' ? ' ' : c;
    }
    return part;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(blank);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blank) + 1 - begin);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.push_back(trimmed(text.substr(0, end)));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

std::string lower_case(std::string_view text) {
    std::string result(text);
    for (char& letter : result) {
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    return result;
}

std::string one_of(std::span<const std::string_view> words) {
    std::string text;
    for (std::size_t i = 0; i + 1 < words.size(); ++i)
        text += (i > 0 ? ", " : "") + std::string(words[i]);
    if (words.empty()) return text;
    return words.size() == 1 ? std::string(words[0])
                             : filled(tr("{0} or {1}"), {text, words.back()});
}

std::string grouped(std::size_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t at = digits.size(); at > 3; at -= 3)
        digits.insert(at - 3, " ");
    return digits;
}

std::string short_number(double value, int digits) {
    std::array<char, 64> buffer{};
    const int length = std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
    return {buffer.data(), static_cast<std::size_t>(length)};
}

}  // namespace zeroset
