#include "engine/expr/syntax_parser.hpp"

#include "engine/expr/spelling.hpp"

#include <array>

namespace zeroset {
namespace {

constexpr int max_depth = 1000;

}  // namespace

std::expected<SyntaxTree, ParseError> SyntaxParser::text() {
    while (next().kind == TokenKind::Break)
        take();
    if (next().kind == TokenKind::End) {
        ParseError error{next().offset, "there is no formula yet",
                         "type one, for example x^2 + y^2 + z^2 = 1", true};
        return std::unexpected(std::move(error));
    }
    while (next().kind != TokenKind::End) {
        if (!statement()) return std::unexpected(*error_);
        while (next().kind == TokenKind::Break)
            take();
    }
    return std::move(tree_);
}

bool SyntaxParser::statement() {
    statement_start_ = at_;
    if (tree_.statements.size() == ProgramLimits::statements) {
        const std::string most = std::to_string(ProgramLimits::statements);
        refuse({next().offset, "there are more than " + most + " statements", {}});
        return false;
    }
    StatementSyntax statement{0, {}, next().offset};
    const Parsed relation = logic();
    if (!relation) return false;
    statement.relation = *relation;
    while (!at_break()) {
        if (next_is("{")) {
            if (!restrictions_in_braces(statement)) return false;
            continue;
        }
        if (!next_is(",")) {
            refuse(surplus());
            return false;
        }
        take();
        const Parsed restriction = logic();
        if (!restriction) return false;
        statement.restrictions.push_back(*restriction);
    }
    tree_.statements.push_back(std::move(statement));
    return true;
}

bool SyntaxParser::restrictions_in_braces(StatementSyntax& statement) {
    const Token& opener = next();
    const List conditions = arguments();
    if (!conditions) return false;
    statement.restrictions.insert(statement.restrictions.end(), conditions->begin(),
                                  conditions->end());
    return close(opener);
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
    constexpr std::array<std::pair<std::string_view, char>, 5> signs{
        {{"=", '='}, {"<", '<'}, {">", '>'}, {"<=", 'l'}, {">=", 'g'}}};
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
        if (mark == '=' && marks.contains('=')) {
            return fail(next(), "there is a second '='",
                        "keep one, or put the next equation behind ';'");
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

/// Whether the "{" that comes next holds conditions rather than a factor or cases.
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
        compares = compares || is_symbol(token, {"<", ">", "<=", ">=", "="});
    }
    return compares;
}

/// Whether the next token can be a factor without a "*" before it.
bool SyntaxParser::starts_factor() const {
    if (next().kind == TokenKind::Name) return !is_connective(next()) && next().text != "not";
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
        const bool written = next_is_one_of({"*", "/"});
        if (!written && !starts_factor()) break;
        marks += written ? take().text.front() : '*';
        const Parsed further = written ? signed_power() : power();
        if (!further) return further;
        operands.push_back(*further);
    }
    if (marks.empty()) return first;
    return add(SyntaxKind::Product, offset, std::move(operands), marks);
}

bool SyntaxParser::may_nest(int further) {
    if (depth_ + further <= max_depth) return true;
    const std::string most = std::to_string(max_depth);
    refuse({next().offset, "the formula is nested more than " + most + " deep", {}});
    return false;
}

SyntaxParser::Parsed SyntaxParser::signed_power() {
    const std::size_t offset = next().offset;
    bool negative = false;
    int signs = 0;
    for (; next_is_one_of({"+", "-"}); ++signs)
        negative ^= take().text == "-";
    if (!may_nest(signs + 1)) return std::nullopt;
    const Parsed operand = power();
    if (!operand || !negative) return operand;
    return add(SyntaxKind::Negate, offset, {*operand});
}

SyntaxParser::Parsed SyntaxParser::power() {
    const Level level(depth_);
    if (!may_nest()) return std::nullopt;
    Parsed base = operand();
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
    tree_.nodes.push_back(
        {kind, offset, std::string(text), std::move(operands), std::string(marks), nullptr});
    return static_cast<SyntaxId>(tree_.nodes.size() - 1);
}

SyntaxId SyntaxParser::add_call(const Function& function, std::size_t offset,
                                std::vector<SyntaxId> operands) {
    const SyntaxId call = add(SyntaxKind::Call, offset, std::move(operands));
    tree_.nodes[call].function = &function;
    return call;
}

std::nullopt_t SyntaxParser::refuse(ParseError error) {
    if (!error_) error_ = std::move(error);
    return std::nullopt;
}

std::nullopt_t SyntaxParser::fail(const Token& at, std::string reason, std::string hint) {
    const bool unfinished = at.kind == TokenKind::End;
    return refuse({at.offset, std::move(reason), std::move(hint), unfinished});
}

ParseError SyntaxParser::missing_operand() const {
    const Token& here = next();
    const bool at_start = at_ == statement_start_;
    const std::string place =
        at_start ? "before " + quoted(here.text) : "after " + quoted(before());
    const bool bar = !at_start && (before() == "|" || next_is("|"));
    return {here.offset, "a number, a variable or '(' is missing " + place,
            bar ? "inside | | type a product with *: |x - 2*|y||" : "",
            here.kind == TokenKind::End};
}

/// Why the next token cannot follow a finished operand.
ParseError SyntaxParser::surplus() const {
    const Token& here = next();
    const std::string text(here.text);
    if (text == ")" || text == "]" || text == "}") {
        const std::string opener = text == ")" ? "(" : text == "]" ? "[" : "{";
        return {here.offset, "this " + quoted(text) + " closes nothing",
                "delete it or add a " + quoted(opener) + " before"};
    }
    if (text == ",") {
        return {here.offset, "a ',' stands outside a function's arguments",
                "write decimals with a point, 1.5"};
    }
    const Token& left = tokens_[at_ - 1];
    const bool adjacent = left.end() == here.offset;
    if (here.kind == TokenKind::Number && left.kind == TokenKind::Number) {
        return {
            here.offset,
            "one number follows another: " + quoted(left.text) + " and " + quoted(text),
            adjacent ? "a number has one point" : "write numbers without spaces, products with *"};
    }
    const std::string reason =
        "an operator is missing between " + quoted(left.text) + " and " + quoted(text);
    if (here.kind == TokenKind::Number && adjacent) {
        const std::string l(left.text);
        const bool is_short = left.kind == TokenKind::Name && l.size() + text.size() < 20;
        return {here.offset, reason,
                is_short
                    ? "type " + l + "*" + text + ", " + l + "^" + text + " or " + l + "_" + text
                    : "type ^ before it for a power, * for a product"};
    }
    return {here.offset, reason, "for a product type *"};
}

bool SyntaxParser::close(const Token& opener) {
    const std::string_view closer = opener.text == "("    ? ")"
                                    : opener.text == "["  ? "]"
                                    : opener.text == "{"  ? "}"
                                    : opener.text == "(|" ? "|)"
                                    : opener.text == "⌊"  ? "⌋"
                                    : opener.text == "⌈"  ? "⌉"
                                                          : "|";
    if (next_is(closer)) {
        take();
        return true;
    }
    const std::string shown = quoted(opener.text == "(|" ? "|" : opener.text);
    const std::string missing = quoted(closer == "|)" ? "|" : closer);
    if (at_break()) {
        refuse({opener.offset, "this " + shown + " is not closed", "add a " + missing,
                next().kind == TokenKind::End});
    } else if (next_is_one_of({")", "]", "}", "|", "|)"})) {
        refuse({opener.offset, "this " + shown + " is not closed before the " + quoted(next().text),
                "add a " + missing + " there"});
    } else {
        refuse(surplus());
    }
    return false;
}

std::expected<SyntaxTree, ParseError> read_syntax(std::string_view text) {
    if (text.size() > longest_text) {
        return std::unexpected(
            ParseError{longest_text,
                       "the text is longer than " + std::to_string(longest_text) + " bytes",
                       {}});
    }
    auto tokens = tokenize(text);
    if (!tokens) return std::unexpected(tokens.error());
    const Words words(*tokens);
    return SyntaxParser(words.split(*tokens), words).text();
}

}  // namespace zeroset
