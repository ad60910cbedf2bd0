#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace zeroset {

/// Column of the byte at `offset` in its line of UTF-8 text, counted from 1 in characters.
std::size_t column_of(std::string_view text, std::size_t offset);

/// The line of `text` that holds the byte at `offset`, without its line end.
std::string_view line_at(std::string_view text, std::size_t offset);

/// Part of a line that holds the character at `caret`, with tabs as spaces.
struct Excerpt {
    std::string text;
    std::size_t caret;  ///< in characters from the start of `text`
};

/// The line, or of a long line the part around its character `caret` (counted from 0).
Excerpt excerpt(std::string_view line, std::size_t caret);

/// `text` without blanks and line ends at its ends.
std::string_view trimmed(std::string_view text);

/// The parts of `text` between separators, trimmed; one at least.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The number that is all of `text`, with a + or - before it or without; nothing where it is none.
template <class Number>
std::optional<Number> number_from(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// `text` with small letters in place of the capitals of ASCII.
std::string lower_case(std::string_view text);

/// The words as "one, two or three".
std::string one_of(std::span<const std::string_view> words);

/// The number with its digits in groups of three, as in "1 234 567".
std::string grouped(std::size_t number);

/// The number as a person would write it, with at most `digits` significant digits.
std::string short_number(double value, int digits = 6);

/// The shortest text that is read as this number.
inline std::string digits_of(double number) {
    std::array<char, 32> digits{};
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    return {digits.data(), written.ptr};
}

/// `text` as a terminal may show it: a U+FFFD for each control character and for each byte that is
/// not UTF-8, so that a file's words are neither commands to the terminal nor further lines.
std::string printable(std::string_view text);

}  // namespace zeroset
