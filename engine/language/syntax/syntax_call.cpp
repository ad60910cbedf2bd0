#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/syntax/syntax_parser.hpp"
#include "engine/language/vocabulary/foreign.hpp"
#include "engine/language/words/signs.hpp"
#include "engine/language/words/words.hpp"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <utility>

// Calls of functions.

namespace zeroset {

SyntaxParser::List SyntaxParser::arguments() {
    take();  // skips the opener
    const int bars = std::exchange(bars_, 0);
    ++brackets_;
    std::vector<SyntaxId> values;
    for (;;) {
        const Parsed value = choice();
        if (!value) return std::nullopt;
        values.push_back(*value);
        if (!next_is(",")) break;
        take();
    }
    --brackets_;
    bars_ = bars;
    return values;
}

/// Skips to the list that is the only argument, as in norm([x, y, z]) and length(vec3(x, y, z)), so
/// that its opener is the next token. False if there is none.
bool SyntaxParser::skip_to_list() {
    std::size_t at = at_ + 1;
    const bool vector = tokens_[at].kind == TokenKind::Name && tokens_[at].text.starts_with("vec");
    if (vector) ++at;
    if (!is_symbol(tokens_[at], {"(", "[", "{"})) return false;
    const std::size_t opener = at;
    int open = 0;
    bool has_comma = false;
    for (; tokens_[at].kind != TokenKind::End; ++at) {
        if (is_symbol(tokens_[at], {"(", "[", "{"})) ++open;
        if (is_symbol(tokens_[at], {")", "]", "}"}) && --open == 0) break;
        has_comma = has_comma || (open == 1 && is_symbol(tokens_[at], {","}));
    }
    const bool is_all =
        tokens_[at].kind != TokenKind::End && is_symbol(tokens_[at + 1], {")", "]", "}"});
    if (!has_comma || !is_all) return false;
    at_ = opener;
    return true;
}

SyntaxParser::List SyntaxParser::arguments_of(const Token& token, const Function& function) {
    if (next_is_one_of({"(", "[", "{"})) {
        const Token& opener = next();
        const bool of_list = function.most < 0 && skip_to_list();
        List values = arguments();
        if (!values) return values;
        if (of_list) take();  // the end of the list
        if (!close(opener)) return std::nullopt;
        return values;
    }
    const std::string name(function.name);
    if (!function.takes_a_number()) {
        const bool restricts = function.op == Op::Where || function.op == Op::If;
        const std::string call = name + "(" + std::string(function.arguments) + ")";
        const char* const hint = restricts
                                     ? tr("type {0}, or behind a surface a comma and the condition")
                                     : tr("type {0}");
        return fail(next(), filled(tr("'(' is missing after {0}"), {quoted(full_name(token))}),
                    filled(hint, {call}));
    }
    if (at_break() || (!starts_factor() && next().kind != TokenKind::Number &&
                       !next_is_one_of({"-", "+", "|"}))) {
        return fail(next(), filled(tr("{0} is a function and wants a value"), {quoted(token.text)}),
                    filled(tr("type {0}"), {name + "(...)"}));
    }
    const Parsed value = is_root_of_number(token, function) ? operand() : bare_argument();
    if (!value) return std::nullopt;
    return std::vector<SyntaxId>{*value};
}

/// Whether a root of the number directly behind it is a factor of what follows, as in sqrt2 x;
/// notes that.
bool SyntaxParser::is_root_of_number(const Token& token, const Function& function) {
    const Token& number = next();
    if (function.op != Op::Sqrt || number.kind != TokenKind::Number || !adjacent(token, number))
        return false;
    ++at_;
    const bool has_factor = starts_factor();
    --at_;
    if (!has_factor) return false;
    const std::string digits(number.text);
    tree_.notes.add(token.offset, filled(tr("{0} is {1}; for the root of a product type {2}"),
                                         {"sqrt" + digits + " ...", "sqrt(" + digits + ")*...",
                                          "sqrt(" + digits + " ...)"}));
    return true;
}

/// Whether the next token continues the argument of a function without parentheses: a name that is
/// no function.
bool SyntaxParser::starts_bare_factor() const {
    if (next().kind != TokenKind::Name || !starts_factor()) return false;
    const std::string name = full_name(next());
    return find_fixed_function(name) == nullptr && !defined_.defines_function(name) &&
           next().text != "\\frac" && next().text != "\\sqrt" && next().text != "log";
}

/// Reads an argument without parentheses, as 2x in sin 2x: a product of a number or name and names;
/// a bracket is part of it only directly after a number.
SyntaxParser::Parsed SyntaxParser::bare_argument() {
    const std::size_t offset = next().offset;
    const Parsed first = signed_power();
    if (!first) return first;
    std::vector<SyntaxId> operands{*first};
    const SyntaxKind kind = tree_[*first].kind;
    bool goes_on = kind == SyntaxKind::Number && next_is_one_of({"(", "["});
    const bool simple = !goes_on && (kind == SyntaxKind::Number || kind == SyntaxKind::Name ||
                                     kind == SyntaxKind::Power || kind == SyntaxKind::Negate);
    while (goes_on || (simple && starts_bare_factor())) {
        const Parsed factor = power();
        if (!factor) return factor;
        operands.push_back(*factor);
        goes_on = false;
    }
    if (operands.size() == 1) return first;
    const std::string marks(operands.size() - 1, '*');
    return add(SyntaxKind::Product, offset, std::move(operands), marks);
}

SyntaxParser::Parsed SyntaxParser::call(const Token& token, const Function& function) {
    std::optional<SyntaxId> exponent;
    if (next_is("^") || next().kind == TokenKind::Superscript) {
        const bool raised = next().kind == TokenKind::Superscript;
        if (!raised) take();
        const Parsed power_of = raised ? superscript() : signed_power();
        if (!power_of) return power_of;
        exponent = power_of;
    }
    const bool square = next_is("[");
    List values = arguments_of(token, function);
    if (!values) return std::nullopt;
    if (square && token.text == "Log" && values->size() == 2) {
        std::swap((*values)[0], (*values)[1]);
        tree_.notes.add(token.offset,
                        filled(tr("{0} is {1}, as in Mathematica"), {"Log[b, x]", "log(x, b)"}));
    }
    if (function.name == "sinc") {
        tree_.notes.add(token.offset,
                        filled(tr("{0} is {1}; for that of NumPy and MATLAB type {2}"),
                               {"sinc(a)", "sin(a)/a", "sinc(pi a)"}));
    }
    if (function.composed == Composed::LogBase && token.text != "Log") note_base(token, *values);
    if (function.op == Op::Where && values->size() == 3) {
        tree_.notes.add(token.offset, tr("where(condition, a, b) is if(condition, a, b)"));
        return add_call(*find_function("if"), token.offset, std::move(*values));
    }
    if (token.text == "log" && !token.subscript.empty() && values->size() == 1) {
        const std::string base = subscript_text(token);
        const bool number = base.find_first_not_of("0123456789") == std::string::npos;
        values->push_back(
            add(number ? SyntaxKind::Number : SyntaxKind::Name, token.offset, {}, {}, base));
    }
    if (function.op == Op::Atan && values->size() == 2) {
        return add_call(*find_function("atan2"), token.offset, in_order_of_atan2(token, *values));
    }
    if (!function.takes(values->size())) {
        return refuse(wrong_count(token, function, values->size()));
    }
    note_letter(token, function);
    const SyntaxId result = add_call(function, token.offset, std::move(*values));
    if (!exponent) return result;
    return with_exponent(result, token, function, *exponent);
}

/// Notes that log(2, x) has its base behind, where the first of two values alone is a number.
void SyntaxParser::note_base(const Token& token, const std::vector<SyntaxId>& values) {
    if (values.size() != 2) return;
    const auto is_number = [&](SyntaxId id) { return tree_[id].kind == SyntaxKind::Number; };
    if (!is_number(values[0]) || is_number(values[1])) return;
    tree_.notes.add(token.offset, tr("log(a, b) is the logarithm of a to the base b; for the base "
                                     "a type log(b, a)"));
}

/// The arguments of an angle in the order of atan2: GLSL has atan(y, x), but Mathematica ArcTan[x,
/// y].
std::vector<SyntaxId> SyntaxParser::in_order_of_atan2(const Token& token,
                                                      std::vector<SyntaxId> values) {
    const bool swapped = token.text == "ArcTan";
    if (swapped) std::swap(values[0], values[1]);
    tree_.notes.add(token.offset, swapped ? filled(tr("{0} is {1}, as in Mathematica"),
                                                   {"ArcTan[x, y]", "atan2(y, x)"})
                                          : tr("atan(a, b) is atan2(a, b), the angle of (b, a)"));
    return values;
}

/// Applies an exponent after a function's name: sin^2 x is (sin x)^2, but sin^-1 x is the inverse.
SyntaxParser::Parsed SyntaxParser::with_exponent(SyntaxId call, const Token& token,
                                                 const Function& function, SyntaxId exponent) {
    const Syntax& power_of = tree_[exponent];
    const bool inverse = power_of.kind == SyntaxKind::Negate &&
                         tree_[power_of.operands[0]].kind == SyntaxKind::Number &&
                         tree_[power_of.operands[0]].text == "1";
    if (!inverse) return add(SyntaxKind::Power, token.offset, {call, exponent});
    const Function* const other = inverse_of(function);
    const std::string name(function.name);
    if (other == nullptr) {
        return fail(token, filled(tr("{0} can be read in two ways"), {name + "^-1"}),
                    filled(tr("for the reciprocal type {0}"), {"1/" + name + "(...)"}));
    }
    tree_.nodes[call].function = other;
    return call;
}

SyntaxParser::Parsed SyntaxParser::call_of_text(const Token& token) {
    const Token& opener = next();
    List values = arguments();
    if (!values) return std::nullopt;
    if (!close(opener)) return std::nullopt;
    return add(SyntaxKind::Call, token.offset, std::move(*values), {}, full_name(token));
}

}  // namespace zeroset
