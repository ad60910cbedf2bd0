// Operands of formulas: numbers, names, brackets, calls.

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/syntax/syntax_parser.hpp"
#include "engine/language/vocabulary/foreign.hpp"
#include "engine/language/words/signs.hpp"
#include "engine/language/words/words.hpp"

#include <algorithm>

namespace zeroset {
namespace {

constexpr std::size_t longest_letter = 4;  // library names up to this length, such as f_r and f_th,
                                           // may be parameters

/// The number with a decimal point, for 0,5 and 0{,}5, too.
std::string decimal(std::string_view typed) {
    std::string text;
    for (const char c : typed) {
        if (c == ',') text += '.';
        if (c != ',' && c != '{' && c != '}') text += c;
    }
    return text;
}

/// Whether a function's name is a parameter, or words that the text defines, where it calls
/// nothing.
bool may_be_letter(const Function& function, std::string_view name) {
    return function.is_word() || (function.is_of_library() && name.size() <= longest_letter);
}

}  // namespace

SyntaxParser::Parsed SyntaxParser::operand() {
    const Token& token = next();
    if (token.kind == TokenKind::Number) {
        take();
        return add(SyntaxKind::Number, token.offset, {}, {}, decimal(token.text));
    }
    if (token.kind == TokenKind::Name) return name(token);
    if (token.kind == TokenKind::Volume) return volume(take());
    if (next_is_one_of({"(", "[", "{"})) return group(take());
    if (next_is_one_of({"|", "(|"})) return absolute(take());
    if (next_is_one_of({"⌊", "⌈"})) return floor_or_ceil(take());
    return refuse(missing_operand());
}

/// Reads the point behind a volume, volume("ct.nrrd")(x, y, z), or behind blobs.
SyntaxParser::Parsed SyntaxParser::volume(const Token& token) {
    const std::string example = "scan = " + std::string(token.text);
    const bool is_volume = token.text.starts_with("volume");
    if (!next_is("(") && !is_volume) {  // blobs("atoms.xyz") is at (x, y, z)
        std::vector<SyntaxId> point;
        for (const char* const axis : {"x", "y", "z"})
            point.push_back(add(SyntaxKind::Name, token.offset, {}, {}, axis));
        return add(SyntaxKind::Volume, token.offset, std::move(point), {}, token.text);
    }
    if (!next_is("(")) {
        return fail(token, tr("a volume is a function of a point"),
                    filled(tr("give it a name in a row of its own, {0}, and type {1}"),
                           {example, "scan(x, y, z)"}));
    }
    const Token& opener = next();
    List point = arguments();
    if (!point || !close(opener)) return std::nullopt;
    if (point->size() != 3) {
        return fail(
            token,
            filled(tr("a volume takes 3 arguments, not {0}"), {std::to_string(point->size())}),
            filled(tr("type {0}"), {"(x, y, z)"}));
    }
    return add(SyntaxKind::Volume, token.offset, std::move(*point), {}, token.text);
}

/// Refuses a call of what is no function.
SyntaxParser::Parsed SyntaxParser::refuse_call(const Token& token, const std::string& full) {
    if (full != "volume") return refuse(no_function(token));
    return fail(token, tr("a volume is named by its file, in quotes"),
                filled(tr("type {0}"), {"volume(\"ct.nrrd\")"}));
}

/// Remarks where a letter that often names a function is a factor.
void SyntaxParser::note_product(const Token& token, const std::string& name) {
    const bool means_call = std::string_view("fghFGH").contains(name) && next_is("(");
    if (!means_call || defined_.defines_value(name) || !adjacent(token, next())) return;
    tree_.notes.add(token.offset,
                    filled(tr("{0} is read as {1}; to make it a function define it, as in {2}"),
                           {name + "(...)", name + "*(...)", name + "(u, v) = u^2 + v^2"}));
}

SyntaxParser::Parsed SyntaxParser::name(const Token& token) {
    if (token.text == "and" || token.text == "or") return refuse(missing_operand());
    if (token.text == "not")
        return fail(token, tr("'not' stands before a comparison only"),
                    tr("put it in parentheses: (not x < 1)"));
    take();
    if (token.text == "\\frac") return fraction();
    if (token.text == "\\sqrt" || token.text == "√" || token.text == "∛") return radical(token);
    const std::string full = full_name(token);
    if (defined_.is_place_with_arguments(token.offset)) {
        while (take().text != ")") {
        }
        return add(SyntaxKind::Name, token.offset, {}, {}, full);
    }
    const bool defined = defined_.find(full, token.offset).has_value();
    if (auto foreign = error_for_foreign(full, token.offset); foreign && !defined) {
        return refuse(std::move(*foreign));
    }
    const bool called = next_is_one_of({"(", "["});
    if (called && defined_.defines_function(full)) return call_of_text(token);
    const bool log = token.text == "log";
    const Function* const function = find_function(log ? "log" : std::string_view(full));
    const bool is_letter = !called && function != nullptr && may_be_letter(*function, full);
    const bool hides =
        function != nullptr && (function->is_of_library() || function->is_word()) && defined;
    if (function != nullptr && !is_letter && !hides && (called || !defined))
        return call(token, *function);
    const bool is_letter_name = is_parameter_name(full) || is_built_in_value(full);
    if (called && !defined && !is_letter_name) return refuse_call(token, full);
    note_product(token, full);
    return add(SyntaxKind::Name, token.offset, {}, {}, full);
}

/// Reads an operand in brackets; "{" may also start cases.
SyntaxParser::Parsed SyntaxParser::group(const Token& opener) {
    const std::size_t start = at_ - 1;
    const int bars = std::exchange(bars_, 0);
    ++brackets_;
    Parsed inside = choice();
    if (inside && opener.text == "(" && next_is(",") && start > statement_start_ &&
        tokens_[start - 1].kind == TokenKind::Name && tokens_[start - 1].text != "return") {
        return refuse(no_function(tokens_[start - 1]));
    }
    if (inside && opener.text == "{" && next_is(":")) inside = cases(opener, *inside);
    if (inside && opener.text != "{" && next_is(",")) inside = tuple(opener, *inside);
    if (!inside) return inside;
    if (!close(opener)) return std::nullopt;
    --brackets_;
    bars_ = bars;
    return inside;
}

/// Reads the rest of a vector (a, b, c) or of a list [a, b, c].
SyntaxParser::Parsed SyntaxParser::tuple(const Token& opener, SyntaxId first) {
    constexpr std::size_t most_parts = 4;
    const bool is_list = opener.text == "[";
    std::vector<SyntaxId> values{first};
    while (next_is(",")) {
        if (!is_list && values.size() == most_parts) {
            return fail(next(), tr("a vector has at most 4 parts"),
                        tr("type a list in brackets: [a, b, c, d, e]"));
        }
        take();
        const Parsed value = choice();
        if (!value) return value;
        values.push_back(*value);
    }
    return add(is_list ? SyntaxKind::Items : SyntaxKind::Vector, opener.offset, std::move(values));
}

/// Reads the part of a vector that is next: .x, or .xz for several.
SyntaxParser::Parsed SyntaxParser::part_of(SyntaxId vector) {
    const Token& token = take();
    return add(SyntaxKind::Part, token.offset, {vector}, {}, token.text);
}

/// Reads the rest of { condition: value, condition: value, value otherwise }, in which the last
/// value may be missing.
SyntaxParser::Parsed SyntaxParser::cases(const Token& opener, SyntaxId condition) {
    std::vector<SyntaxId> operands{condition};
    for (;;) {
        if (!next_is(":")) break;
        take();
        const Parsed value = choice();
        if (!value) return value;
        operands.push_back(*value);
        if (!next_is(",")) break;
        take();
        const Parsed further = logic();
        if (!further) return further;
        operands.push_back(*further);
    }
    return add(SyntaxKind::Cases, opener.offset, std::move(operands));
}

SyntaxParser::Parsed SyntaxParser::absolute(const Token& opener) {
    const bool plain = opener.text == "|";
    const int bars = plain ? bars_++ : std::exchange(bars_, 0);
    Parsed inside = choice();
    if (!inside) return inside;
    if (!close(opener)) return std::nullopt;
    bars_ = bars;
    const SyntaxId call = add_call(*find_function("abs"), opener.offset, {*inside});
    tree_.nodes[call].marks = "|";
    return call;
}

SyntaxParser::Parsed SyntaxParser::floor_or_ceil(const Token& opener) {
    const int bars = std::exchange(bars_, 0);
    const Parsed inside = choice();
    if (!inside) return inside;
    if (!close(opener)) return std::nullopt;
    bars_ = bars;
    const Function& function = *find_function(opener.text == "⌊" ? "floor" : "ceil");
    return add_call(function, opener.offset, {*inside});
}

/// Reads a braced group, or a single digit or operand, as TeX does.
SyntaxParser::Parsed SyntaxParser::part() {
    const Level level(depth_);
    if (!may_nest()) return std::nullopt;
    Token& token = tokens_[at_];
    const bool digits = token.kind == TokenKind::Number && token.text.size() > 1 &&
                        token.text.find_first_not_of("0123456789") == std::string_view::npos;
    if (!digits) return operand();
    const SyntaxId digit = add(SyntaxKind::Number, token.offset, {}, {}, token.text.substr(0, 1));
    token.text.remove_prefix(1);
    ++token.offset;
    --token.length;
    return digit;
}

SyntaxParser::Parsed SyntaxParser::fraction() {
    const std::size_t offset = tokens_[at_ - 1].offset;
    const Parsed numerator = part();
    if (!numerator) return numerator;
    const Parsed denominator = part();
    if (!denominator) return denominator;
    return add(SyntaxKind::Product, offset, {*numerator, *denominator}, "/");
}

SyntaxParser::Parsed SyntaxParser::radical(const Token& token) {
    if (token.text != "\\sqrt") {
        // √x² is √(x²), but √(x)² is (√x)².
        const Parsed of = next_is_one_of({"(", "[", "{"}) ? operand() : power();
        if (!of) return of;
        return add_call(*find_function(token.text), token.offset, {*of});
    }
    Parsed degree = 0;
    const bool has_degree = next_is("[");
    if (has_degree) degree = group(take());
    if (!degree) return degree;
    const Parsed of = part();
    if (!of) return of;
    if (!has_degree) return add_call(*find_function("sqrt"), token.offset, {*of});
    return add_call(*find_function("root"), token.offset, {*of, *degree});
}

SyntaxParser::Parsed SyntaxParser::superscript() {
    const Token& token = take();
    std::string digits;
    for (std::size_t at = 0; at < token.text.size();) {
        const CodePoint point = code_point_at(token.text, at);
        digits += superscript_digit(point.code);
        at += point.length;
    }
    const bool negative = digits.starts_with('-');
    const std::string size = digits.substr(digits.starts_with('+') || negative ? 1 : 0);
    if (size.empty() || size.find_first_of("+-") != std::string::npos) {
        return fail(token, tr("this exponent is no whole number"), tr("type ^ before it"));
    }
    const SyntaxId number = add(SyntaxKind::Number, token.offset, {}, {}, size);
    return negative ? add(SyntaxKind::Negate, token.offset, {number}) : number;
}

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
    const Parsed value = bare_argument();
    if (!value) return std::nullopt;
    return std::vector<SyntaxId>{*value};
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
    const SyntaxId result = add_call(function, token.offset, std::move(*values));
    if (!exponent) return result;
    return with_exponent(result, token, function, *exponent);
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
