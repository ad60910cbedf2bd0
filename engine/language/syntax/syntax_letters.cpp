// Special functions that a letter names: J_2(x), Γ(x), W(x).

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/syntax/syntax_parser.hpp"
#include "engine/language/words/signs.hpp"
#include "engine/language/words/words.hpp"

namespace zeroset {

/// Whether the name at this index is called with one argument: the bracket stands directly behind
/// it, and it is no name of the text.
bool SyntaxParser::is_bessel(std::size_t at) const {
    const Token& token = tokens_[at];
    const Token& opener = tokens_[at + 1];
    const std::string name = full_name(token);
    if (!is_symbol(opener, {"(", "["}) || !adjacent(token, opener)) return false;
    if (defined_.find(name, token.offset) || defined_.defines_value(name)) return false;
    return arguments_at(at + 1) == 1;
}

/// Reads J_2(a), which is besselj(2, a).
SyntaxParser::Parsed SyntaxParser::bessel_call(const Token& token, const Function& function) {
    const Token& opener = next();
    const List values = arguments();
    if (!values || !close(opener)) return std::nullopt;
    const std::string order = subscript_text(token);
    const std::string name = full_name(token);
    const std::string meant = std::string(function.name) + "(" + order + ", ...)";
    tree_.notes.add(token.offset, filled(tr("{0} is {1}; for a product type {2}"),
                                         {name + "(...)", meant, name + "*(...)"}));
    const auto kind = is_digit(order[0]) ? SyntaxKind::Number : SyntaxKind::Name;
    const SyntaxId of = add(kind, token.offset, {}, {}, order);
    return add_call(function, token.offset, {of, values->front()});
}

/// Notes that a letter alone is a special function: W, Γ, ζ, ψ.
void SyntaxParser::note_letter(const Token& token, const Function& function) {
    const bool is_letter = code_point_at(token.text, 0).length == token.text.size();
    if (!is_letter || !function.is_special()) return;
    const std::string letter(token.text);
    tree_.notes.add(token.offset, filled(tr("{0} is {1}; for a product type {2}"),
                                         {letter + "(...)", std::string(function.name) + "(...)",
                                          letter + "*(...)"}));
}

}  // namespace zeroset
