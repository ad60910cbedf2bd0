#include "engine/language/syntax/syntax_parser.hpp"

#include "engine/base/translation.hpp"
#include "engine/language/vocabulary/words_vocabulary.hpp"
#include "engine/language/words/syntax_bars.hpp"

#include <array>
#include <cassert>

namespace zeroset {
namespace {

constexpr int max_depth = 1000;

}  // namespace

/// Reads condition ? value : condition ? value : value.
SyntaxParser::Parsed SyntaxParser::choice() {
    const std::size_t offset = next().offset;
    Parsed first = logic();
    if (!first || !next_is("?")) return first;
    std::vector<SyntaxId> operands{*first};
    while (next_is("?")) {
        const Level level(depth_);
        if (!may_nest()) return std::nullopt;
        take();
        const Parsed value = choice();
        if (!value) return value;
        operands.push_back(*value);
        if (!next_is(":")) {
            return fail(next(), tr("':' is missing after the value of a choice"),
                        tr("type condition ? a : b"));
        }
        take();
        const Parsed further = logic();
        if (!further) return further;
        operands.push_back(*further);
    }
    return add(SyntaxKind::Cases, offset, std::move(operands), "?");
}

SyntaxParser::Parsed SyntaxParser::joined_by(std::string_view word, SyntaxKind kind, Rule rule) {
    const std::size_t offset = next().offset;
    Parsed first = (this->*rule)();
    if (!first || !next_is_word(word)) return first;
    std::vector<SyntaxId> operands{*first};
    while (next_is_word(word)) {
        take();
        const Parsed further = (this->*rule)();
        if (!further) return further;
        operands.push_back(*further);
    }
    return add(kind, offset, std::move(operands));
}

SyntaxParser::Parsed SyntaxParser::logic() {
    return joined_by("or", SyntaxKind::Or, &SyntaxParser::both);
}

SyntaxParser::Parsed SyntaxParser::both() {
    return joined_by("and", SyntaxKind::And, &SyntaxParser::negation);
}

SyntaxParser::Parsed SyntaxParser::negation() {
    const std::size_t offset = next().offset;
    bool negated = false;
    while (next_is_word("not")) {
        take();
        negated = !negated;
    }
    const Parsed operand = relation();
    if (!operand || !negated) return operand;
    return add(SyntaxKind::Not, offset, {*operand});
}

char SyntaxParser::comparison() const {
    constexpr std::array<std::pair<std::string_view, char>, 8> signs{{{"=", '='},
                                                                      {":=", ':'},
                                                                      {"==", 'e'},
                                                                      {"!=", 'n'},
                                                                      {"<", '<'},
                                                                      {">", '>'},
                                                                      {"<=", 'l'},
                                                                      {">=", 'g'}}};
    if (next().kind != TokenKind::Symbol) return '\0';
    for (const auto& [sign, mark] : signs) {
        if (next().text == sign) return mark;
    }
    return '\0';
}

SyntaxParser::Parsed SyntaxParser::relation() {
    Parsed first = sum();
    if (!first || comparison() == '\0') return first;
    const std::size_t offset = next().offset;
    std::vector<SyntaxId> operands{*first};
    std::string marks;
    while (const char mark = comparison()) {
        const bool equates = mark == '=' || mark == ':';
        if (equates && marks.find_first_of("=:") != std::string::npos) {
            return fail(next(), tr("there is a second '='"),
                        tr("keep one, or put the next equation behind ';'"));
        }
        take();
        marks += mark;
        const Parsed further = sum();
        if (!further) return further;
        operands.push_back(*further);
    }
    return add(SyntaxKind::Compare, offset, std::move(operands), marks);
}

SyntaxParser::Parsed SyntaxParser::sum() {
    const std::size_t offset = next().offset;
    Parsed first = product();
    if (!first || !next_is_one_of({"+", "-"})) return first;
    std::vector<SyntaxId> operands{*first};
    std::string marks;
    while (next_is_one_of({"+", "-"})) {
        marks += take().text;
        const Parsed further = product();
        if (!further) return further;
        operands.push_back(*further);
    }
    return add(SyntaxKind::Sum, offset, std::move(operands), marks);
}

/// Whether the "{" that is next holds restricting conditions rather than a factor or cases.
bool SyntaxParser::restricts() const {
    if (brackets_ > 0) return false;
    int open = 0;
    bool compares = false;
    for (std::size_t i = at_; i < tokens_.size() && tokens_[i].kind != TokenKind::Break; ++i) {
        const Token& token = tokens_[i];
        if (is_symbol(token, {"(", "[", "{"})) ++open;
        if (is_symbol(token, {")", "]", "}"}) && --open == 0) break;
        if (open > 1) continue;
        if (is_symbol(token, {":"})) return false;
        compares = compares || is_symbol(token, {"<", ">", "<=", ">=", "=", "==", "!="});
    }
    return compares;
}

/// Whether the next token can be a factor without a "*" before it.
bool SyntaxParser::starts_factor() const {
    if (next().kind == TokenKind::Name) return !is_connective(next()) && next().text != "not";
    if (next().kind == TokenKind::Volume) return true;
    if (next_is("{")) return !restricts();
    if (next_is("|")) return bars_ == 0;
    return next_is_one_of({"(", "[", "(|", "⌊", "⌈"});
}

SyntaxParser::Parsed SyntaxParser::product() {
    const std::size_t offset = next().offset;
    Parsed first = signed_power();
    if (!first) return first;
    std::vector<SyntaxId> operands{*first};
    std::string marks;
    for (;;) {
        if (next_is("~")) take();
        const bool written = next_is_one_of({"*", "/", "%"}) || next_is_remainder();
        if (!written && !starts_factor()) break;
        if (is_derivative()) {
            return fail(next(), tr("derivatives such as d/dx are not read"),
                        tr("type the derivative as a formula"));
        }
        const bool is_like_index = next_is("[") && adjacent(tokens_[at_ - 1], next());
        const char sign = next_is_word("mod") ? '%' : next().text.front();
        if (written) take();
        marks += written ? sign : is_like_index ? '[' : '*';
        const Parsed further = written ? signed_power() : power();
        if (!further) return further;
        operands.push_back(*further);
    }
    if (marks.empty()) return first;
    return add(SyntaxKind::Product, offset, std::move(operands), marks);
}

/// Whether the word of x mod 2 is next, and no call.
bool SyntaxParser::next_is_remainder() const {
    return next_is_word("mod") && begins_operand(tokens_[at_ + 1]) &&
           !is_symbol(tokens_[at_ + 1], {"(", "["});
}

/// Whether the "/" of d/dx is next, typed without spaces, and d is not a defined name.
bool SyntaxParser::is_derivative() const {
    if (!next_is("/") || at_ == 0 || at_ + 2 >= tokens_.size()) return false;
    const auto is_d = [](const Token& token) {
        return token.kind == TokenKind::Name && token.text == "d" && token.subscript.empty();
    };
    const Token& axis = tokens_[at_ + 2];
    return is_d(tokens_[at_ - 1]) && is_d(tokens_[at_ + 1]) &&
           std::string_view("xyzt").contains(axis.text) && adjacent(tokens_[at_ + 1], axis) &&
           !defined_.defines_value("d");
}

bool SyntaxParser::may_nest(int further) {
    if (depth_ + further <= max_depth) return true;
    const std::string most = std::to_string(max_depth);
    refuse({.offset = next().offset,
            .reason = filled(tr("the formula is nested more than {0} deep"), {most}),
            .hint = {}});
    return false;
}

SyntaxParser::Parsed SyntaxParser::signed_power() {
    const std::size_t offset = next().offset;
    bool negative = false;
    int signs = 0;
    for (; next_is_one_of({"+", "-"}); ++signs)
        negative ^= take().text == "-";
    if (!may_nest(signs + 1)) return std::nullopt;
    const Parsed operand = next_is_one_of({"!", "~"}) ? negated() : power();
    if (!operand || !negative) return operand;
    return add(SyntaxKind::Negate, offset, {*operand});
}

/// Reads !x, which programs write for "not", or ~(x < 1). "~" before anything but a condition is a
/// space.
SyntaxParser::Parsed SyntaxParser::negated() {
    const Level level(depth_);
    if (!may_nest()) return std::nullopt;
    const Token& sign = take();
    const Parsed operand = signed_power();
    if (!operand) return operand;
    if (sign.text == "~") {
        if (!is_condition(tree_[*operand].kind)) return operand;
        tree_.notes.add(sign.offset, tr("~ is read as not; for a space of LaTeX leave it out"));
    }
    return add(SyntaxKind::Not, sign.offset, {*operand});
}

SyntaxParser::Parsed SyntaxParser::power() {
    const Level level(depth_);
    if (!may_nest()) return std::nullopt;
    Parsed base = operand();
    while (base && next().kind == TokenKind::Part)
        base = part_of(*base);
    if (base && next_is("!") && adjacent(tokens_[at_ - 1], next())) base = factorial(*base);
    while (base) {
        const std::size_t offset = next().offset;
        Parsed exponent = 0;
        if (next().kind == TokenKind::Superscript) {
            exponent = superscript();
        } else if (next_is("^")) {
            take();
            exponent = signed_power();
        } else {
            break;
        }
        if (!exponent) return exponent;
        base = add(SyntaxKind::Power, offset, {*base, *exponent});
    }
    return base;
}

bool SyntaxParser::next_is_one_of(std::initializer_list<std::string_view> symbols) const {
    return is_symbol(next(), symbols);
}

SyntaxId SyntaxParser::add(SyntaxKind kind, std::size_t offset, std::vector<SyntaxId> operands,
                           std::string_view marks, std::string_view text) {
    tree_.nodes.push_back({.kind = kind,
                           .offset = offset,
                           .text = std::string(text),
                           .operands = std::move(operands),
                           .marks = std::string(marks),
                           .function = nullptr});
    return static_cast<SyntaxId>(tree_.nodes.size() - 1);
}

SyntaxId SyntaxParser::add_call(const Function& function, std::size_t offset,
                                std::vector<SyntaxId> operands) {
    if (function.is_of_library() && !function.is_thing()) add_library_function(function, offset);
    const SyntaxId call = add(SyntaxKind::Call, offset, std::move(operands));
    tree_.nodes[call].function = &function;
    return call;
}

/// Adds the body of a function of library.def, once for each tree. Errors in it are shown at
/// `offset`.
void SyntaxParser::add_library_function(const Function& function, std::size_t offset) {
    if (tree_.library.contains(&function)) return;
    std::string text = "float F(" + std::string(function.arguments) + ") {";
    text += function.body.contains("return ") ? std::string(function.body)
                                              : "return " + std::string(function.body) + ";";
    auto read = read_syntax(text + "}");
    assert(read);
    const auto base = static_cast<SyntaxId>(tree_.nodes.size());
    for (Syntax& node : read->nodes) {
        node.offset = offset;
        for (SyntaxId& operand : node.operands)
            operand += base;
        tree_.nodes.push_back(std::move(node));
    }
    for (auto& [called, of_library] : read->library) {
        of_library.body += base;
        tree_.library.emplace(called, std::move(of_library));
    }
    const Syntax& definition = tree_[base + read->statements.front().relation];
    LibraryFunction result{.arguments = {}, .body = definition.operands[1]};
    for (const SyntaxId argument : tree_[definition.operands[0]].operands)
        result.arguments.push_back(tree_[argument].text);
    tree_.library.emplace(&function, std::move(result));
}

}  // namespace zeroset
