#pragma once

#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/vocabulary/parse_notes.hpp"
#include "engine/language/vocabulary/reading.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <map>
#include <string>
#include <string_view>
#include <vector>

// What a text says before names mean anything: a tree for each statement.

namespace zeroset {

using SyntaxId = std::uint32_t;

enum class SyntaxKind : std::uint8_t {
    Number,   ///< text: the literal
    Name,     ///< text: the full name
    Negate,   ///< 1 operand
    Sum,      ///< marks: '+' or '-' before each operand but the first
    Product,  ///< marks: '*', '/' or '%' before each operand but the first
    Power,    ///< base, exponent
    Call,     ///< function, or text: the name of a function of the text
    Compare,  ///< marks between the operands: '=', '<', '>', 'l' for <=, 'g' for >=, 'e' for ==,
              ///< 'n' for !=
    And,      ///< 2 operands or more
    Or,       ///< 2 operands or more
    Not,      ///< 1 operand
    Cases,    ///< condition, value, condition, value, ..., and maybe the value otherwise; marks:
              ///< "?" if written condition ? value : value
    Let,      ///< text: a name; the name's value, and what has the name in it
    List,     ///< values one after the other, of which the last counts
    Earlier,  ///< a value that stands before in the same list
};

/// Whether it is true or false by itself.
constexpr bool is_condition(SyntaxKind kind) {
    return kind == SyntaxKind::Compare || kind == SyntaxKind::And || kind == SyntaxKind::Or ||
           kind == SyntaxKind::Not;
}

struct Syntax {
    SyntaxKind kind = SyntaxKind::Number;
    std::size_t offset = 0;  ///< where an error in it is shown
    std::string text;
    std::vector<SyntaxId> operands;
    std::string marks;
    const Function* function = nullptr;
};

/// A statement as typed: what it says and the conditions that restrict it.
struct StatementSyntax {
    SyntaxId relation;
    std::vector<SyntaxId> restrictions;
    std::size_t offset;       ///< of its first character
    bool is_certain = false;  ///< a definition, as := and words such as float say
    char leading_sign = 0;    ///< '+' or '-' if its line starts with it, below another
};

/// A function of library.def.
struct LibraryFunction {
    std::vector<std::string> arguments;
    SyntaxId body;
};

struct SyntaxTree {
    std::vector<Syntax> nodes;
    std::vector<StatementSyntax> statements;
    std::map<const Function*, LibraryFunction> library;  ///< those that are called
    Notes notes;

    [[nodiscard]] const Syntax& operator[](SyntaxId id) const { return nodes[id]; }
};

/// The trees of a text's statements. Functions are found by name; other names are any. What stands
/// at `counted_end` or behind does not tell whether a name before it is a definition.
std::expected<SyntaxTree, ParseError> read_syntax(std::string_view text,
                                                  std::size_t counted_end = std::string_view::npos);

}  // namespace zeroset
