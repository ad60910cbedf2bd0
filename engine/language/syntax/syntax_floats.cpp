#include "engine/language/syntax/syntax_floats.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/vocabulary/parse_notes.hpp"

#include <algorithm>
#include <span>
#include <string>

namespace zeroset {
namespace {

bool is_f(const Token& token) {
    return token.kind == TokenKind::Name && (token.text == "f" || token.text == "F");
}

/// Whether the token is an f directly after a number with a point or an exponent.
bool ends_number(std::span<const Token> tokens, std::size_t at) {
    if (at == 0 || !is_f(tokens[at])) return false;
    const Token& number = tokens[at - 1];
    return number.kind == TokenKind::Number && adjacent(number, tokens[at]) &&
           number.text.find_first_of(".eE") != std::string_view::npos;
}

/// Whether the text has an f that is a value.
bool has_f(std::span<const Token> tokens, const DefinedNames& defined) {
    if (defined.defines_value("f")) return true;
    for (std::size_t at = 0; at < tokens.size(); ++at) {
        const bool called = at + 1 < tokens.size() && is_symbol(tokens[at + 1], {"(", "["});
        if (is_f(tokens[at]) && !called && !ends_number(tokens, at)) return true;
    }
    return false;
}

/// Whether nothing continues the f, as in 0.5f_1, 0.5fx and 0.5f(x).
bool stands_alone(std::span<const Token> tokens, std::size_t at) {
    const Token& next = tokens[at + 1];
    const bool goes_on =
        next.kind == TokenKind::Name || next.kind == TokenKind::Number || is_symbol(next, {"("});
    return tokens[at].subscript.empty() && !(goes_on && adjacent(tokens[at], next));
}

}  // namespace

std::vector<Token> without_float_suffixes(std::vector<Token> tokens, const DefinedNames& defined,
                                          Notes& notes) {
    const auto is_suffix = [&](std::size_t at) {
        return ends_number(tokens, at) && stands_alone(tokens, at);
    };
    bool has_suffix = false;
    for (std::size_t at = 0; at < tokens.size() && !has_suffix; ++at)
        has_suffix = is_suffix(at);
    if (!has_suffix || has_f(tokens, defined)) return tokens;
    std::vector<Token> result;
    result.reserve(tokens.size());
    for (std::size_t at = 0; at < tokens.size(); ++at) {
        if (!is_suffix(at)) {
            result.push_back(tokens[at]);
            continue;
        }
        const std::string number = shown_number(tokens[at - 1].text);
        notes.add(
            tokens[at].offset,
            filled(
                tr("{0} is read as the number {1}, as programs write it; for a product type {2}"),
                {number + "f", number, number + "*f"}));
    }
    return result;
}

}  // namespace zeroset
