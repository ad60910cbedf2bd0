#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace zeroset {

/// Column, from 1 and in characters, of the byte at `offset` of its line in UTF-8 text.
std::size_t column_of(std::string_view text, std::size_t offset);

/// The line of `text` that holds the byte at `offset`, without its end.
std::string_view line_at(std::string_view text, std::size_t offset);

/// Part of a line, tabs as spaces, with the character at `caret` in it.
struct Excerpt {
    std::string text;
    std::size_t caret;  ///< in characters from its start
};

/// The line, or if it is long the part around its character `caret` (counted from 0).
Excerpt excerpt(std::string_view line, std::size_t caret);

/// Without spaces and line ends at both ends.
std::string_view trimmed(std::string_view text);

/// The number as a person would write it, with at most `digits` significant digits.
std::string short_number(double value, int digits = 6);

}  // namespace zeroset
