#include "engine/expr/parse.hpp"

#include "engine/expr/lexer.hpp"
#include "engine/expr/nearest_word.hpp"
#include "engine/expr/number.hpp"
#include "engine/expr/simplify.hpp"

#include <numeric>
#include <optional>
#include <utility>
#include <vector>

// Grammar (^ is right-associative and binds tighter than a sign on its left):
//   equation = sum [ "=" sum ]
//   sum      = product { ("+" | "-") product }
//   product  = signed { ("*" | "/") signed }
//   signed   = ("+" | "-") signed | power
//   power    = atom [ "^" signed ]
//   atom     = number | variable | function "(" sum { "," sum } ")" | "(" sum ")"

namespace zeroset {
namespace {

constexpr int max_depth = 1000;
constexpr std::size_t max_text = 100'000;
constexpr double largest_number = 1e300;

using Parsed = std::expected<NodeId, ParseError>;

class Parser {
public:
    explicit Parser(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

    std::expected<Expr, ParseError> equation();

private:
    Parsed sum();
    Parsed product();
    Parsed signed_power();
    Parsed power();
    Parsed atom();
    Parsed name(const Token& token);
    Parsed call(const Token& token, Op function);
    std::expected<std::vector<NodeId>, ParseError> arguments();
    std::optional<ParseError> close(const Token& opener);

    /// `first` and then all `operand`s joined by infix operators of `spellings`.
    template <class Operand, class Make>
    Parsed chain(std::string_view spellings, Operand operand, Make make);

    [[nodiscard]] const Token& next() const { return tokens_[at_]; }
    [[nodiscard]] bool next_is(std::string_view symbol) const {
        return next().kind == TokenKind::Symbol && next().text == symbol;
    }
    const Token& take() { return tokens_[next().kind == TokenKind::End ? at_ : at_++]; }
    [[nodiscard]] ParseError missing_operand() const;
    [[nodiscard]] ParseError after_end() const;

    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    int depth_ = 0;
    ExprBuilder builder_;
};

std::unexpected<ParseError> fail(std::size_t offset, std::string reason, std::string hint = {}) {
    return std::unexpected(ParseError{offset, std::move(reason), std::move(hint)});
}

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

ParseError Parser::missing_operand() const {
    const Token& here = next();
    const bool at_start = at_ == 0;
    if (here.kind == TokenKind::End && at_start) {
        return {here.offset, "there is no formula yet",
                "type one, for example x^2 + y^2 + z^2 = 1"};
    }
    const std::string place =
        at_start ? "before " + quoted(here.text) : "after " + quoted(tokens_[at_ - 1].text);
    return {here.offset, "a number, a variable or '(' is missing " + place, {}};
}

ParseError Parser::after_end() const {
    const Token& here = next();
    if (here.text == "=") return {here.offset, "there is a second '='", "keep one"};
    if (here.text == ")") {
        return {here.offset, "this ')' closes nothing", "delete it or add a '(' before"};
    }
    if (here.text == ",") return {here.offset, "a ',' stands outside a function's arguments", {}};
    const std::string left(tokens_[at_ - 1].text);
    return {here.offset,
            "an operator is missing between " + quoted(left) + " and " + quoted(here.text),
            "for a product type " + left + "*" + std::string(here.text)};
}

std::expected<Expr, ParseError> Parser::equation() {
    Parsed left = sum();
    if (!left) return std::unexpected(left.error());
    NodeId root = *left;
    if (next_is("=")) {
        take();
        const Parsed right = sum();
        if (!right) return std::unexpected(right.error());
        root = make_subtract(builder_, root, *right);
    }
    if (next().kind != TokenKind::End) return std::unexpected(after_end());
    return builder_.finish(root);
}

template <class Operand, class Make>
Parsed Parser::chain(std::string_view spellings, Operand operand, Make make) {
    Parsed left = (this->*operand)();
    while (left && next().kind == TokenKind::Symbol && spellings.contains(next().text)) {
        const char spelling = take().text.front();
        const Parsed right = (this->*operand)();
        if (!right) return right;
        left = make(builder_, spelling, *left, *right);
    }
    return left;
}

Parsed Parser::sum() {
    return chain("+-", &Parser::product, [](ExprBuilder& builder, char op, NodeId a, NodeId b) {
        return op == '+' ? make_add(builder, a, b) : make_subtract(builder, a, b);
    });
}

Parsed Parser::product() {
    return chain("*/", &Parser::signed_power,
                 [](ExprBuilder& builder, char op, NodeId a, NodeId b) {
                     return op == '*' ? make_multiply(builder, a, b) : make_divide(builder, a, b);
                 });
}

Parsed Parser::signed_power() {
    // Every nesting passes here, so here it is counted.
    struct Level {
        int& depth;
        explicit Level(int& d) : depth(d) { ++depth; }
        ~Level() { --depth; }
    };
    const Level level(depth_);
    if (depth_ > max_depth) {
        return fail(next().offset,
                    "the formula is nested more than " + std::to_string(max_depth) + " deep");
    }
    if (next_is("+")) {
        take();
        return signed_power();
    }
    if (next_is("-")) {
        take();
        const Parsed operand = signed_power();
        if (!operand) return operand;
        return make_negate(builder_, *operand);
    }
    return power();
}

Parsed Parser::power() {
    const Parsed base = atom();
    if (!base || !next_is("^")) return base;
    take();
    const Parsed exponent = signed_power();
    if (!exponent) return exponent;
    return make_power(builder_, *base, *exponent);
}

Parsed Parser::atom() {
    const Token token = next();
    if (token.kind == TokenKind::Number) {
        take();
        const NumberEnclosure number = enclose_number(token.text);
        if (number.hi > largest_number) {
            return fail(token.offset, "the number " + std::string(token.text) + " is too large",
                        "stay below 1e300");
        }
        return builder_.constant(number.lo, number.hi);
    }
    if (token.kind == TokenKind::Name) {
        take();
        return name(token);
    }
    if (!next_is("(")) return std::unexpected(missing_operand());
    take();
    Parsed inside = sum();
    if (!inside) return inside;
    if (const std::optional<ParseError> error = close(token)) return std::unexpected(*error);
    return inside;
}

std::optional<ParseError> Parser::close(const Token& opener) {
    if (next_is(")")) {
        take();
        return std::nullopt;
    }
    if (next().kind == TokenKind::End) {
        return ParseError{opener.offset, "this '(' is not closed", "add a ')'"};
    }
    return after_end();
}

Parsed Parser::name(const Token& token) {
    for (int variable = 0; variable <= variable_w; ++variable) {
        if (token.text == variable_name(variable, {})) return builder_.variable(variable);
    }
    if (const std::optional<Op> function = function_named(token.text)) {
        return call(token, *function);
    }
    std::vector<std::string_view> words{"x", "y", "z", "w"};
    for (const OpInfo& info : operators()) {
        if (info.notation == Notation::Call) words.push_back(info.spelling);
    }
    const std::optional<std::string_view> meant = meant_word(token.text, words);
    std::string hint;
    if (meant) {
        hint = "did you mean " + std::string(*meant) + "?";
    } else {
        hint = "known are:";
        for (const std::string_view word : words)
            hint += " " + std::string(word);
    }
    return fail(token.offset, quoted(token.text) + " is not known", std::move(hint));
}

std::expected<std::vector<NodeId>, ParseError> Parser::arguments() {
    std::vector<NodeId> values;
    do {
        take();  // "(" or ","
        const Parsed value = sum();
        if (!value) return std::unexpected(value.error());
        values.push_back(*value);
    } while (next_is(","));
    return values;
}

Parsed Parser::call(const Token& token, Op function) {
    const Token opener = next();
    if (!next_is("(")) {
        return fail(opener.offset, "'(' is missing after " + quoted(token.text),
                    "type " + std::string(token.text) + "(...)");
    }
    const auto values = arguments();
    if (!values) return std::unexpected(values.error());
    if (const std::optional<ParseError> error = close(opener)) return std::unexpected(*error);

    const auto arity = static_cast<std::size_t>(op_info(function).arity);
    const bool foldable = function == Op::Min || function == Op::Max;
    if (values->size() != arity && !(foldable && values->size() > arity)) {
        return fail(token.offset, std::string(token.text) + " takes " + std::to_string(arity) +
                                      (foldable ? " or more" : "") +
                                      (arity == 1 ? " argument, not " : " arguments, not ") +
                                      std::to_string(values->size()));
    }
    if (arity == 1) return make_call(builder_, function, values->front(), 0);
    return std::accumulate(values->begin() + 1, values->end(), values->front(),
                           [&](NodeId a, NodeId b) { return make_call(builder_, function, a, b); });
}

}  // namespace

std::expected<Expr, ParseError> parse(std::string_view text) {
    if (text.size() > max_text) {
        return fail(max_text, "the text is longer than " + std::to_string(max_text) + " bytes");
    }
    auto tokens = tokenize(text);
    if (!tokens) return std::unexpected(tokens.error());
    return Parser(std::move(*tokens)).equation();
}

}  // namespace zeroset
