#pragma once

#include "engine/language/words/lexer.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

// The meanings of characters beyond ASCII and of LaTeX commands.

namespace zeroset {

struct CodePoint {
    char32_t code = 0;
    std::size_t length = 1;  ///< in bytes
};

/// The UTF-8 character at `start`; U+FFFD for a byte that belongs to none.
CodePoint code_point_at(std::string_view text, std::size_t start);

/// The meaning of a sign; a sign with an empty text is skipped like a space.
struct Sign {
    TokenKind kind;
    std::string_view text;
};

/// The meaning of a character beyond ASCII: an operator, a Greek letter, a space.
std::optional<Sign> sign_of(char32_t code);
/// Whether the character is a Greek letter.
bool is_greek(char32_t code);
/// '0' to '9', '+' or '-' for a superscript character; 0 for any other.
char superscript_digit(char32_t code);
/// The plain letter that one of mathematics stands for, x for an italic or a bold one; 0: none.
char32_t plain_letter(char32_t code);
/// The sign that a command without a meaning here stands for, as hint_for_sign has it; 0: none.
char32_t sign_without_meaning(std::string_view command);
/// '0' to '9' for a subscript digit; 0 for any other.
char subscript_digit(char32_t code);
/// The meaning of a LaTeX command, given without its backslash: cdot, pi, sin, left.
std::optional<Sign> sign_of_command(std::string_view command);

}  // namespace zeroset
