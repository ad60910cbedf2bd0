#include "engine/expr/lexer.hpp"

#include <algorithm>

namespace zeroset {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Length of the run of `text` from `start` on that satisfies the predicate.
template <class Predicate>
std::size_t run_length(std::string_view text, std::size_t start, Predicate predicate) {
    const auto rest = text.substr(start);
    const auto* const end = std::ranges::find_if_not(rest, predicate);
    return static_cast<std::size_t>(end - rest.begin());
}

/// Length of the decimal literal at `start`: 12, .5, 1.5e+2. An "e" without digits after it is
/// not part of the number.
std::size_t number_length(std::string_view text, std::size_t start) {
    std::size_t end = start + run_length(text, start, is_digit);
    if (end < text.size() && text[end] == '.') end += 1 + run_length(text, end + 1, is_digit);
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        const bool sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
        const std::size_t digits = end + (sign ? 2 : 1);
        const std::size_t length = digits < text.size() ? run_length(text, digits, is_digit) : 0;
        if (length > 0) end = digits + length;
    }
    return end - start;
}

/// Length in bytes of the UTF-8 character at `start`.
std::size_t character_length(std::string_view text, std::size_t start) {
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    return 1 + run_length(text, start + 1, continues);
}

}  // namespace

std::expected<std::vector<Token>, ParseError> tokenize(std::string_view text) {
    constexpr std::string_view symbols = "+-*/^(),=";
    std::vector<Token> tokens;
    std::size_t at = 0;
    const auto push = [&](TokenKind kind, std::size_t length) {
        tokens.push_back({kind, text.substr(at, length), at});
        at += length;
    };
    while (at < text.size()) {
        const char c = text[at];
        const bool point = c == '.' && at + 1 < text.size() && is_digit(text[at + 1]);
        if (is_space(c)) {
            ++at;
        } else if (is_digit(c) || point) {
            push(TokenKind::Number, number_length(text, at));
        } else if (is_letter(c)) {
            push(TokenKind::Name,
                 run_length(text, at, [](char d) { return is_letter(d) || is_digit(d); }));
        } else if (symbols.contains(c)) {
            push(TokenKind::Symbol, 1);
        } else {
            const std::string_view character = text.substr(at, character_length(text, at));
            return std::unexpected(
                ParseError{at, "'" + std::string(character) + "' has no meaning here",
                           "type + - * / ^ ( ) and names such as x, y, z, sqrt"});
        }
    }
    push(TokenKind::End, 0);
    return tokens;
}

}  // namespace zeroset
