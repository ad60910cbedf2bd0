#pragma once

#include "engine/language/words/lexer.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

// What signs beyond ASCII and LaTeX commands mean.

namespace zeroset {

struct CodePoint {
    char32_t code = 0;
    std::size_t length = 1;  ///< in bytes
};

/// The UTF-8 character at `start`; a byte that belongs to none counts as U+FFFD.
CodePoint code_point_at(std::string_view text, std::size_t start);

/// A sign's meaning; an empty text means nothing, like a space.
struct Sign {
    TokenKind kind;
    std::string_view text;
};

/// A character beyond ASCII: an operator, a Greek letter, a space.
std::optional<Sign> sign_of(char32_t code);
/// Whether the character is a Greek letter.
bool is_greek(char32_t code);
/// "0" to "9", "+" or "-" for a raised character; 0 for any other.
char superscript_digit(char32_t code);
/// "0" to "9" for a lowered digit; 0 for any other.
char subscript_digit(char32_t code);
/// A command, without its backslash: \cdot, \pi, \sin, \left.
std::optional<Sign> sign_of_command(std::string_view command);

}  // namespace zeroset
