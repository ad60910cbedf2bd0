#pragma once

#include "engine/language/dialects/asked_box.hpp"
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

// A text as trees, one for each statement, before names are looked up.

namespace zeroset {

using SyntaxId = std::uint32_t;

enum class SyntaxKind : std::uint8_t {
    Number,   ///< text: the literal
    Name,     ///< text: the full name
    Negate,   ///< 1 operand
    Sum,      ///< marks: '+' or '-' before each operand but the first
    Product,  ///< marks: '*', '/', '%' or, for '*' in p[1], '[' before each operand but the first
    Power,    ///< base, exponent
    Volume,   ///< text: volume("FILE", ...) as typed; 3 operands
    Call,     ///< function, or text: the name of a function that the text defines
    Compare,  ///< marks between the operands: '=', '<', '>', 'l' for <=, 'g' for >=, 'e' for ==,
              ///< 'n' for !=
    And,      ///< 2 operands or more
    Or,       ///< 2 operands or more
    Not,      ///< 1 operand
    Cases,    ///< condition, value, condition, value, ..., and perhaps a last value for all other
              ///< cases; marks: "?" if written condition ? value : value
    Let,      ///< text: a name; operands: its value, and the expression that may use the name
    Vector,   ///< 2 to 4 operands: (a, b, c)
    Items,    ///< 2 operands or more: [a, b, c]
    Part,     ///< text: the parts, as xz; 1 operand
    Replace,  ///< text: parts, as xz; operands: a vector, and what takes the place of these parts
    List,     ///< values computed in order; the value of the list is the last one
    Earlier,  ///< an earlier value of the same list
};

/// Whether a node of this kind is a truth value by itself.
constexpr bool is_condition(SyntaxKind kind) {
    return kind == SyntaxKind::Compare || kind == SyntaxKind::And || kind == SyntaxKind::Or ||
           kind == SyntaxKind::Not;
}

struct Syntax {
    SyntaxKind kind = SyntaxKind::Number;
    std::size_t offset = 0;  ///< where an error about the node is shown, in bytes of the text
    std::string text;
    std::vector<SyntaxId> operands;
    std::string marks;
    const Function* function = nullptr;
};

/// A statement as typed: its relation and the conditions that restrict it.
struct StatementSyntax {
    SyntaxId relation;
    std::vector<SyntaxId> restrictions;
    std::size_t offset;       ///< offset of its first character, in bytes
    bool is_certain = false;  ///< marked as a definition, by := or a word such as float
    char leading_sign = 0;    ///< '+' or '-' if its line starts with it and is not the first
};

/// A function of library.def.
struct LibraryFunction {
    std::vector<std::string> arguments;
    SyntaxId body;
};

struct SyntaxTree {
    std::vector<Syntax> nodes;
    std::vector<StatementSyntax> statements;
    std::map<const Function*, LibraryFunction> library;  ///< the functions of library.def that are
                                                         ///< called
    Notes notes;
    AskedBox box = {};           ///< ranges that plotting commands of other programs give, as typed
    std::size_t box_offset = 0;  ///< of such a command

    [[nodiscard]] const Syntax& operator[](SyntaxId id) const { return nodes[id]; }
};

/// Reads the trees of a text's statements. Functions are looked up by name; other names are not.
/// Text at offset `counted_end` or later does not decide whether an earlier name is defined.
std::expected<SyntaxTree, ParseError> read_syntax(std::string_view text,
                                                  std::size_t counted_end = std::string_view::npos);

}  // namespace zeroset
