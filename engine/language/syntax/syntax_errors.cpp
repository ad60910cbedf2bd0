// Errors in a text, each with a hint what to type instead.

#include "engine/expr/spelling.hpp"
#include "engine/language/syntax/syntax_parser.hpp"
#include "engine/language/vocabulary/foreign.hpp"
#include "engine/language/words/words.hpp"

namespace zeroset {

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

/// The error for a next token that cannot follow a complete operand.
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
    if (text == "!") {
        return {here.offset, "'!' stands before a condition, not behind a number",
                "for n! type prod(i, i, 1, n)"};
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

ParseError SyntaxParser::no_function(const Token& name) const {
    const std::string full = full_name(name);
    if (auto foreign = error_for_foreign(full, name.offset)) return std::move(*foreign);
    std::string hint = hint_for_unknown(full);
    const bool is_letter = is_built_in_value(full) || is_parameter_name(full);
    if (is_letter && !hint.starts_with("did you mean f_"))
        hint = "define it, as in f(u, v) = u^2 + v^2";
    if (hint.starts_with("define")) hint = "define it, as in " + full + "(u, v) = u^2 + v^2";
    return {name.offset, quoted(full) + " is not a function", hint};
}

ParseError SyntaxParser::wrong_count(const Token& token, const Function& function,
                                     std::size_t count) {
    const std::string name(function.name);
    return {token.offset,
            name + " takes " + function.arity_text() + ", not " + std::to_string(count),
            "type " + name + "(" + std::string(function.arguments) + ")"};
}

}  // namespace zeroset
