// Errors in a text, each with a hint what to type instead.

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/syntax/syntax_parser.hpp"
#include "engine/language/vocabulary/foreign.hpp"
#include "engine/language/words/words.hpp"

namespace zeroset {
namespace {

std::string_view closer_of(std::string_view opener) {
    return opener == "("    ? ")"
           : opener == "["  ? "]"
           : opener == "{"  ? "}"
           : opener == "(|" ? "|)"
           : opener == "⌊"  ? "⌋"
           : opener == "⌈"  ? "⌉"
                            : "|";
}

}  // namespace

std::nullopt_t SyntaxParser::refuse(ParseError error) {
    if (!error_) error_ = std::move(error);
    return std::nullopt;
}

std::nullopt_t SyntaxParser::fail(const Token& at, std::string reason, std::string hint) {
    const bool unfinished = at.kind == TokenKind::End;
    return refuse({.offset = at.offset,
                   .reason = std::move(reason),
                   .hint = std::move(hint),
                   .unfinished = unfinished});
}

ParseError SyntaxParser::missing_operand() const {
    const Token& here = next();
    const bool at_start = at_ == statement_start_;
    const char* const reason = at_start ? tr("a number, a variable or '(' is missing before {0}")
                                        : tr("a number, a variable or '(' is missing after {0}");
    const bool bar = !at_start && (before() == "|" || next_is("|"));
    return {.offset = here.offset,
            .reason = filled(reason, {quoted(tokens_[at_start ? at_ : at_ - 1].text)}),
            .hint = bar ? tr("inside | | type a product with *: |x - 2*|y||") : "",
            .unfinished = here.kind == TokenKind::End};
}

/// The error for a next token that cannot follow a complete operand.
ParseError SyntaxParser::surplus() const {
    const Token& here = next();
    const std::string text(here.text);
    if (text == ")" || text == "]" || text == "}") {
        const std::string opener = text == ")" ? "(" : text == "]" ? "[" : "{";
        return {.offset = here.offset,
                .reason = filled(tr("this {0} closes nothing"), {quoted(text)}),
                .hint = filled(tr("delete it or add a {0} before"), {quoted(opener)})};
    }
    if (text == ",") {
        return {.offset = here.offset,
                .reason = tr("a ',' stands outside a function's arguments"),
                .hint = tr("write decimals with a point, 1.5")};
    }
    const Token& left = tokens_[at_ - 1];
    const bool adjacent = left.end() == here.offset;
    if (here.kind == TokenKind::Number && left.kind == TokenKind::Number) {
        return {.offset = here.offset,
                .reason = filled(tr("one number follows another: {0} and {1}"),
                                 {quoted(left.text), quoted(text)}),
                .hint = adjacent ? tr("a number has one point")
                                 : tr("write numbers without spaces, products with *")};
    }
    if (text == "!") {
        return {.offset = here.offset,
                .reason = tr("'!' stands before a condition, not behind a number"),
                .hint = tr("for n! type prod(i, i, 1, n)")};
    }
    const std::string reason =
        filled(tr("an operator is missing between {0} and {1}"), {quoted(left.text), quoted(text)});
    if (here.kind == TokenKind::Number && adjacent) {
        const std::string l(left.text);
        const bool is_short = left.kind == TokenKind::Name && l.size() + text.size() < 20;
        return {.offset = here.offset,
                .reason = reason,
                .hint = is_short ? filled(tr("type {0}, {1} or {2}"),
                                          {l + "*" + text, l + "^" + text, l + "_" + text})
                                 : tr("type ^ before it for a power, * for a product")};
    }
    return {.offset = here.offset, .reason = reason, .hint = tr("for a product type *")};
}

bool SyntaxParser::close(const Token& opener) {
    const std::string_view closer = closer_of(opener.text);
    if (next_is(closer)) {
        take();
        return true;
    }
    const std::string shown = quoted(opener.text == "(|" ? "|" : opener.text);
    const std::string missing = quoted(closer == "|)" ? "|" : closer);
    if (at_break()) {
        refuse({.offset = opener.offset,
                .reason = filled(tr("this {0} is not closed"), {shown}),
                .hint = filled(tr("add a {0}"), {missing}),
                .unfinished = next().kind == TokenKind::End});
    } else if (next_is_one_of({")", "]", "}", "|", "|)"})) {
        refuse({.offset = opener.offset,
                .reason = filled(tr("this {0} is not closed before the {1}"),
                                 {shown, quoted(next().text)}),
                .hint = filled(tr("add a {0} there"), {missing})});
    } else {
        refuse(surplus());
    }
    return false;
}

ParseError SyntaxParser::no_function(const Token& name) const {
    const std::string full = full_name(name);
    if (auto foreign = error_for_foreign(full, name.offset)) return std::move(*foreign);
    const auto meant = nearest_known_name(full);
    const bool is_letter = is_built_in_value(full) || is_parameter_name(full);
    const bool defines = is_letter && !(meant && meant->starts_with("f_"));
    return {
        .offset = name.offset,
        .reason = filled(tr("{0} is not a function"), {quoted(full)}),
        .hint = defines ? hint_to_define(full) : hint_for_unknown_function(full),
        .mend = defines || !meant ? std::nullopt : std::optional(Mend{.word = full, .by = *meant})};
}

ParseError SyntaxParser::wrong_count(const Token& token, const Function& function,
                                     std::size_t count) {
    const std::string call =
        std::string(function.name) + "(" + std::string(function.arguments) + ")";
    return {.offset = token.offset,
            .reason = function.refusal(count),
            .hint = filled(tr("type {0}"), {call})};
}

}  // namespace zeroset
