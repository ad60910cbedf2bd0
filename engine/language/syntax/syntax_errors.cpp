// Errors in a text, each with a hint what to type instead.

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
    const std::string place =
        at_start ? "before " + quoted(here.text) : "after " + quoted(before());
    const bool bar = !at_start && (before() == "|" || next_is("|"));
    return {.offset = here.offset,
            .reason = "a number, a variable or '(' is missing " + place,
            .hint = bar ? "inside | | type a product with *: |x - 2*|y||" : "",
            .unfinished = here.kind == TokenKind::End};
}

/// The error for a next token that cannot follow a complete operand.
ParseError SyntaxParser::surplus() const {
    const Token& here = next();
    const std::string text(here.text);
    if (text == ")" || text == "]" || text == "}") {
        const std::string opener = text == ")" ? "(" : text == "]" ? "[" : "{";
        return {.offset = here.offset,
                .reason = "this " + quoted(text) + " closes nothing",
                .hint = "delete it or add a " + quoted(opener) + " before"};
    }
    if (text == ",") {
        return {.offset = here.offset,
                .reason = "a ',' stands outside a function's arguments",
                .hint = "write decimals with a point, 1.5"};
    }
    const Token& left = tokens_[at_ - 1];
    const bool adjacent = left.end() == here.offset;
    if (here.kind == TokenKind::Number && left.kind == TokenKind::Number) {
        return {
            .offset = here.offset,
            .reason = "one number follows another: " + quoted(left.text) + " and " + quoted(text),
            .hint = adjacent ? "a number has one point"
                             : "write numbers without spaces, products with *"};
    }
    if (text == "!") {
        return {.offset = here.offset,
                .reason = "'!' stands before a condition, not behind a number",
                .hint = "for n! type prod(i, i, 1, n)"};
    }
    const std::string reason =
        "an operator is missing between " + quoted(left.text) + " and " + quoted(text);
    if (here.kind == TokenKind::Number && adjacent) {
        const std::string l(left.text);
        const bool is_short = left.kind == TokenKind::Name && l.size() + text.size() < 20;
        return {.offset = here.offset,
                .reason = reason,
                .hint = is_short ? "type " + l + "*" + text + ", " + l + "^" + text + " or " + l +
                                       "_" + text
                                 : "type ^ before it for a power, * for a product"};
    }
    return {.offset = here.offset, .reason = reason, .hint = "for a product type *"};
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
                .reason = "this " + shown + " is not closed",
                .hint = "add a " + missing,
                .unfinished = next().kind == TokenKind::End});
    } else if (next_is_one_of({")", "]", "}", "|", "|)"})) {
        refuse({.offset = opener.offset,
                .reason = "this " + shown + " is not closed before the " + quoted(next().text),
                .hint = "add a " + missing + " there"});
    } else {
        refuse(surplus());
    }
    return false;
}

ParseError SyntaxParser::no_function(const Token& name) const {
    const std::string full = full_name(name);
    if (auto foreign = error_for_foreign(full, name.offset)) return std::move(*foreign);
    std::string hint = hint_for_unknown(full);
    const bool is_letter = is_built_in_value(full) || is_parameter_name(full);
    if (is_letter && !hint.starts_with("did you mean f_"))
        hint = "define it, as in f(u, v) = u^2 + v^2";
    if (hint.starts_with("define")) hint = "define it, as in " + full + "(u, v) = u^2 + v^2";
    return {.offset = name.offset, .reason = quoted(full) + " is not a function", .hint = hint};
}

ParseError SyntaxParser::wrong_count(const Token& token, const Function& function,
                                     std::size_t count) {
    const std::string name(function.name);
    return {.offset = token.offset,
            .reason = name + " takes " + function.arity_text() + ", not " + std::to_string(count),
            .hint = "type " + name + "(" + std::string(function.arguments) + ")"};
}

}  // namespace zeroset
