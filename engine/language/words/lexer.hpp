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
    Name,         ///< a run of letters, a defined name, a Greek letter, a LaTeX command such as
                  ///< \frac
    Superscript,  ///< an exponent in raised digits, such as "-12"
    Symbol,
    Volume,  ///< a field that a file holds, as typed: volume("ct.nrrd", edge)
    Part,    ///< the letters of a part of a vector behind its point: xz of p.xz
    Break,   ///< the end of a statement: ";" or the end of a line
    End,
};

/// A token. Signs with equal meanings have equal texts: "×", "·" and "\cdot" are "*", "π" and "\pi"
/// are "pi". The bars of \left| and \right| are "(|" and "|)"; the commands \frac and \sqrt keep
/// their "\".
struct Token {
    TokenKind kind = TokenKind::End;
    std::string_view text = {};       ///< a view of the typed text or a constant
    std::string_view subscript = {};  ///< subscript of a name that is not defined, as typed: "1" in
                                      ///< c_{1}
    std::size_t offset = 0;           ///< in bytes
    std::size_t length = 0;           ///< in bytes, as typed

    [[nodiscard]] std::size_t end() const { return offset + length; }
};

/// Whether the token is one of these symbols.
bool is_symbol(const Token& token, std::initializer_list<std::string_view> symbols);
/// Whether the token stands between two conditions: and, or.
bool is_connective(const Token& token);
/// Whether `second` follows `first` without a space.
bool adjacent(const Token& first, const Token& second);

/// The tokens of a text; the last one is End. A line end is a Break only outside brackets and where
/// the next line does not continue the statement. A name in `defined` is one token; without
/// `defined`, each run of letters, digits and "_" is one. The text and `defined` must outlive the
/// tokens.
std::expected<std::vector<Token>, ParseError> tokenize(std::string_view text,
                                                       const DefinedNames* defined, Notes& notes);

/// Rewrites functions of other languages that are assigned to a name, such as f = @(x) x^2 and f =
/// lambda x: x^2, as f(x) := x^2; and f = volume("FILE") as f(x, y, z) := volume("FILE")(x, y, z).
std::vector<Token> with_plain_functions(std::vector<Token> tokens);
/// Removes the line ends that end no statement: in brackets, next to an operator that lacks an
/// operand, and before a "+" if the statement has no "=" yet. After a "\v", a line that starts with
/// a sign continues a complete statement, too.
std::vector<Token> without_inner_line_ends(std::vector<Token> tokens, Notes& notes);

}  // namespace zeroset
