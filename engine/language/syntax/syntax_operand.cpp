// Operands of formulas: numbers, names, brackets.

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
    if (token.kind == TokenKind::Superscript && tokens_[at_ + 1].text == "√") {
        const Parsed degree = superscript();  // ³√x
        if (!degree) return degree;
        take();
        const Parsed of = radical_operand();
        return of ? Parsed(add_call(*find_function("root"), token.offset, {*of, *degree})) : of;
    }
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

/// Remarks where a letter that often names a function is a factor: f, g, h, and with a number P_0.
void SyntaxParser::note_product(const Token& token, const std::string& name) {
    const bool numbered = !token.subscript.empty() && is_digit(subscript_text(token)[0]) &&
                          std::string_view("fghFGHHLPTUψ").contains(token.text);
    const bool means_call =
        (numbered || std::string_view("fghFGHKE").contains(name)) && next_is("(");
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
    if (const auto by_letter = call_by_letter(token, full)) return *by_letter;
    if (called && !defined && !is_letter_name) return refuse_call(token, full);
    note_product(token, full);
    return add(SyntaxKind::Name, token.offset, {}, {}, name_in_branch(full));
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

/// Reads what stands behind √: √x² is √(x²), but √(x)² is (√x)².
SyntaxParser::Parsed SyntaxParser::radical_operand() {
    return next_is_one_of({"(", "[", "{"}) ? operand() : power();
}

SyntaxParser::Parsed SyntaxParser::radical(const Token& token) {
    if (token.text != "\\sqrt") {
        const Parsed of = radical_operand();
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
        const char digit = superscript_digit(point.code);
        if (digit != '(' && digit != ')') digits += digit;
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

}  // namespace zeroset
