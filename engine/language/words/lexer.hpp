#pragma once

#include "engine/language/vocabulary/reading.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace zeroset {

class DefinedNames;
class Notes;

enum class TokenKind : std::uint8_t {
    Number,
    Name,         ///< a run of letters, a defined name, a Greek letter, a LaTeX command as \frac
    Superscript,  ///< an exponent in raised digits, as "-12"
    Symbol,
    Break,  ///< between two statements: ";" or the end of a line
    End,
};

/// Signs of one meaning have one text: "×", "·" and "\cdot" are "*", "π" and "\pi" are "pi".
/// The bars of \left| and \right| are "(|" and "|)"; the commands \frac and \sqrt keep their "\".
struct Token {
    TokenKind kind = TokenKind::End;
    std::string_view text = {};       ///< a part of the typed text or a constant
    std::string_view subscript = {};  ///< of a name that is not defined, as typed: "1" of c_{1}
    std::size_t offset = 0;           ///< in bytes
    std::size_t length = 0;           ///< in bytes, as typed

    [[nodiscard]] std::size_t end() const { return offset + length; }
};

/// Whether the token is one of these symbols.
bool is_symbol(const Token& token, std::initializer_list<std::string_view> symbols);
/// Whether the token stands between two conditions: and, or.
bool is_connective(const Token& token);
/// Whether `second` stands right behind `first`.
bool adjacent(const Token& first, const Token& second);

/// The text's tokens, the last of them End. Line ends are Breaks only outside brackets and where
/// the lines do not go on with each other. A name of `defined` is one token; without `defined` so
/// is each run of letters, digits and "_". The text and `defined` must outlive the tokens.
std::expected<std::vector<Token>, ParseError> tokenize(std::string_view text,
                                                       const DefinedNames* defined, Notes& notes);

/// Writes functions that other programs define without a name of their own, such as f = @(x) x^2
/// and f = lambda x: x^2, as f(x) := x^2.
std::vector<Token> with_plain_functions(std::vector<Token> tokens);
/// Leaves out the line ends that separate nothing: in brackets, behind and before an operator that
/// wants more, before a "+" that goes on with what has no "=" yet. Behind a "\v" a line that starts
/// with a sign goes on with a finished one, too.
std::vector<Token> without_inner_line_ends(std::vector<Token> tokens, Notes& notes);

}  // namespace zeroset
