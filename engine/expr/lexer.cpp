#include "engine/expr/lexer.hpp"

#include "engine/expr/signs.hpp"
#include "engine/expr/spelling.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

namespace zeroset {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '~' || c == '$'; }

/// Length of the run of `text` from `start` on that satisfies the predicate.
template <class Predicate>
std::size_t run_length(std::string_view text, std::size_t start, Predicate predicate) {
    if (start >= text.size()) return 0;
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
        const std::size_t length = run_length(text, digits, is_digit);
        if (length > 0) end = digits + length;
    }
    return end - start;
}

using Done = std::expected<void, ParseError>;

class Lexer {
public:
    explicit Lexer(std::string_view text) : text_(text) {}

    std::expected<std::vector<Token>, ParseError> tokens();

private:
    Done step();
    Done other_character();
    Done command();
    void word(std::size_t begin, std::size_t end);
    void name(std::string_view text, std::size_t length);
    void push_sign(const Sign& sign, std::size_t length);
    void symbol();
    bool word_in_braces(std::size_t at);
    void superscript();
    /// The subscript that starts at `at_`, which moves behind it; empty when there is none.
    std::string subscript();

    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    void push(TokenKind kind, std::string_view text, std::size_t length) {
        tokens_.push_back({kind, text, {}, at_, length});
        at_ += length;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::vector<Token> tokens_;
};

std::expected<std::vector<Token>, ParseError> Lexer::tokens() {
    while (at_ < text_.size()) {
        if (const Done done = step(); !done) return std::unexpected(done.error());
    }
    push(TokenKind::End, {}, 0);
    return std::move(tokens_);
}

Done Lexer::step() {
    const char c = peek();
    if (c == '&' && peek(1) == '&') {
        push(TokenKind::Name, "and", 2);
    } else if (is_space(c) || c == '&') {
        ++at_;
    } else if (c == '\n' || c == ';') {
        push(TokenKind::Break, text_.substr(at_, 1), 1);
    } else if (c == '#') {
        at_ += run_length(text_, at_, [](char d) { return d != '\n'; });
    } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
        const std::size_t length = number_length(text_, at_);
        push(TokenKind::Number, text_.substr(at_, length), length);
    } else if (is_letter(c)) {
        const std::size_t length = run_length(text_, at_, is_letter);
        name(text_.substr(at_, length), length);
    } else if (c == '\\') {
        return command();
    } else if (std::string_view("+-*/^()[]{}|,=<>:").contains(c)) {
        symbol();
    } else {
        return other_character();
    }
    return {};
}

/// An ASCII operator; "**" is "^", "==" and ":=" are "=".
void Lexer::symbol() {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> pairs{
        {{"**", "^"}, {"==", "="}, {":=", "="}, {"<=", "<="}, {">=", ">="}, {"=<", "<="}}};
    for (const auto& [typed, meaning] : pairs) {
        if (text_.substr(at_, 2) == typed) return push(TokenKind::Symbol, meaning, 2);
    }
    push(TokenKind::Symbol, text_.substr(at_, 1), 1);
}

void Lexer::name(std::string_view text, std::size_t length) {
    push(TokenKind::Name, text, length);
    const std::size_t token = tokens_.size() - 1;
    std::string lowered = subscript();
    tokens_[token].subscript = std::move(lowered);
    tokens_[token].length = at_ - tokens_[token].offset;
}

std::string Lexer::subscript() {
    const auto is_part = [](char c) { return is_letter(c) || is_digit(c); };
    std::string result;
    if (peek() == '_') {
        const bool braces = peek(1) == '{';
        const std::size_t begin = at_ + (braces ? 2 : 1);
        // c_1x is the product of c_1 and x.
        const bool digits = !braces && begin < text_.size() && is_digit(text_[begin]);
        const std::size_t length =
            digits ? run_length(text_, begin, is_digit) : run_length(text_, begin, is_part);
        const std::size_t end = begin + length;
        const bool closed = !braces || (end < text_.size() && text_[end] == '}');
        if (length == 0 || !closed) return result;
        result = text_.substr(begin, length);
        at_ = end + (braces ? 1 : 0);
        return result;
    }
    while (at_ < text_.size()) {
        const CodePoint point = code_point_at(text_, at_);
        const char digit = subscript_digit(point.code);
        if (digit == '\0') break;
        result += digit;
        at_ += point.length;
    }
    return result;
}

void Lexer::push_sign(const Sign& sign, std::size_t length) {
    if (sign.text.empty()) {
        at_ += length;
    } else if (sign.kind == TokenKind::Name) {
        name(sign.text, length);
    } else {
        push(sign.kind, sign.text, length);
    }
}

/// A run of raised digits. Its token's text is the run as typed; the parser reads it.
void Lexer::superscript() {
    std::size_t length = 0;
    while (at_ + length < text_.size()) {
        const CodePoint point = code_point_at(text_, at_ + length);
        if (superscript_digit(point.code) == '\0') break;
        length += point.length;
    }
    push(TokenKind::Superscript, text_.substr(at_, length), length);
}

Done Lexer::other_character() {
    const CodePoint point = code_point_at(text_, at_);
    if (superscript_digit(point.code) != '\0') {
        superscript();
        return {};
    }
    if (const std::optional<Sign> sign = sign_of(point.code)) {
        push_sign(*sign, point.length);
        return {};
    }
    std::string hint = "type + - * / ^ ( ) and names such as x, y, z, sqrt";
    if (peek() == '!') hint = "for n! type prod(i, i, 1, n)";
    if (peek() == '!' && peek(1) == '=') hint = "compare with < <= > >=";
    if (peek() == '%') hint = "for the remainder type mod(a, b)";
    if (peek() == '_') hint = "a subscript stands right behind a letter: c_1, c_{12}";
    if (point.code == U'\u2260') hint = "compare with < <= > >=";
    const bool printable = point.length > 1 || (peek() > ' ' && peek() < '\x7F');
    const std::string shown =
        printable ? quoted(text_.substr(at_, point.length))
                  : "the byte " + std::to_string(static_cast<unsigned char>(peek()));
    return std::unexpected(ParseError{at_, shown + " has no meaning here", hint});
}

/// `{letters}` from `at` on as one name, as in \operatorname{sgn}.
bool Lexer::word_in_braces(std::size_t at) {
    if (at >= text_.size() || text_[at] != '{') return false;
    const std::size_t length = run_length(text_, at + 1, is_letter);
    const std::size_t end = at + 1 + length;
    if (length == 0 || end >= text_.size() || text_[end] != '}') return false;
    const std::size_t begin = at_;
    name(text_.substr(at + 1, length), end + 1 - begin);
    return true;
}

Done Lexer::command() {
    const std::size_t letters = run_length(text_, at_ + 1, is_letter);
    const std::string_view word = text_.substr(at_ + 1, letters);
    if (letters == 0) {  // one sign: \\ is a line end, \{ a brace, \, and \( nothing
        const char sign = peek(1);
        if (sign == '\\') {
            push(TokenKind::Break, "\n", 2);
        } else if (sign == '{' || sign == '}') {
            push(TokenKind::Symbol, text_.substr(at_ + 1, 1), 2);
        } else {
            at_ = std::min(at_ + 2, text_.size());
        }
        return {};
    }
    const std::size_t length = 1 + letters;
    const char next = peek(length);
    if ((word == "left" || word == "right") && (next == '|' || next == '.')) {
        if (next == '.') {
            at_ += length + 1;
        } else {
            push(TokenKind::Symbol, word == "left" ? "(|" : "|)", length + 1);
        }
        return {};
    }
    if (word == "begin" || word == "end") {
        at_ += length + run_length(text_, at_ + length, [](char c) { return c != '}'; });
        at_ = std::min(at_ + 1, text_.size());
        return {};
    }
    const std::optional<Sign> sign = sign_of_command(word);
    if (!sign) {
        return std::unexpected(ParseError{
            at_, "the LaTeX command " + quoted(text_.substr(at_, length)) + " is not known here",
            "leave it out or type its meaning"});
    }
    if (sign->text.empty() && word_in_braces(at_ + length)) return {};
    push_sign(*sign, length);
    return {};
}

/// Whether a statement cannot end before this token.
bool goes_on(const Token& token) {
    return token.kind == TokenKind::Superscript || is_connective(token) ||
           is_symbol(token, {"*", "/", "^", ")", "]", "}", ",", "=", "<", ">", "<=", ">=", "|)"});
}

/// Whether a statement cannot end after this token.
bool wants_more(const Token& token) {
    return is_connective(token) ||
           is_symbol(token, {"+", "-", "*", "/", "^", ",", "=", "<", ">", "<=", ">="});
}

/// Leaves out the line ends that separate nothing.
class LineJoiner {
public:
    explicit LineJoiner(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

    std::vector<Token> joined() {
        joined_.reserve(tokens_.size());
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (!is_line_end(tokens_[i]) || !joins(i)) take(tokens_[i]);
        }
        return std::move(joined_);
    }

private:
    static bool is_line_end(const Token& token) {
        return token.kind == TokenKind::Break && token.text == "\n";
    }
    void take(const Token& token) {
        if (is_symbol(token, {"(", "[", "{"})) ++open_;
        if (is_symbol(token, {")", "]", "}"}) && open_ > 0) --open_;
        if (is_symbol(token, {"="})) has_equals_ = true;
        if (token.kind == TokenKind::Break) {
            open_ = 0;
            has_equals_ = false;
        }
        joined_.push_back(token);
    }
    /// Whether the statement goes on behind the line end `at`. A line that starts with a sign goes
    /// on with the one before it, unless both are equations.
    [[nodiscard]] bool joins(std::size_t at) const {
        const Token& next = tokens_[at + 1];
        if (open_ > 0 || joined_.empty() || joined_.back().kind == TokenKind::Break) return true;
        if (wants_more(joined_.back()) || goes_on(next)) return true;
        return is_symbol(next, {"+", "-"}) && !(has_equals_ && equation_starts(at + 1));
    }
    /// Whether an "=" stands between `at` and the next break.
    [[nodiscard]] bool equation_starts(std::size_t at) const {
        while (tokens_[at].kind != TokenKind::Break && tokens_[at].kind != TokenKind::End) {
            if (is_symbol(tokens_[at++], {"="})) return true;
        }
        return false;
    }

    std::vector<Token> tokens_;
    std::vector<Token> joined_;
    int open_ = 0;             ///< brackets
    bool has_equals_ = false;  ///< in the statement so far
};

}  // namespace

bool is_symbol(const Token& token, std::initializer_list<std::string_view> symbols) {
    return token.kind == TokenKind::Symbol &&
           std::ranges::find(symbols, token.text) != symbols.end();
}

bool is_connective(const Token& token) {
    return token.kind == TokenKind::Name && (token.text == "and" || token.text == "or");
}

std::expected<std::vector<Token>, ParseError> tokenize(std::string_view text) {
    auto tokens = Lexer(text).tokens();
    if (!tokens) return tokens;
    return LineJoiner(std::move(*tokens)).joined();
}

}  // namespace zeroset
