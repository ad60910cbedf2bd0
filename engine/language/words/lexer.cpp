#include "engine/language/words/lexer.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/vocabulary/foreign.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/vocabulary/parse_notes.hpp"
#include "engine/language/words/lexer_reader.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

namespace zeroset {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '~' || c == '$'; }

/// Length of the decimal literal at `start`: 12, .5, 1.5e+2. An "e" without digits after it is
/// not part of the number.
std::size_t number_length(std::string_view text, std::size_t start) {
    std::size_t end = start + run_length(text, start, is_digit);
    // LaTeX writes a decimal comma as {,}.
    const bool comma =
        end + 3 < text.size() && text.substr(end, 3) == "{,}" && is_digit(text[end + 3]);
    if (comma) {
        end += 3 + run_length(text, end + 3, is_digit);
    } else if (end < text.size() && text[end] == '.') {
        end += 1 + run_length(text, end + 1, is_digit);
    }
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        const bool sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
        const std::size_t digits = end + (sign ? 2 : 1);
        const std::size_t length = run_length(text, digits, is_digit);
        if (length > 0) end = digits + length;
    }
    return end - start;
}

}  // namespace

std::expected<std::vector<Token>, ParseError> Lexer::tokens() {
    while (at_ < text_.size()) {
        if (const Done done = step(); !done) return std::unexpected(done.error());
    }
    push(TokenKind::End, {}, 0);
    return std::move(tokens_);
}

Done Lexer::step() {
    const char c = peek();
    if (at_ == macro_end_) {
        macro_end_ = std::string_view::npos;
        push(TokenKind::Symbol, ":=", 0);
        return {};
    }
    if (may_negate()) {
        push(TokenKind::Symbol, "~", 1);
        return {};
    }
    if (is_space(c) || is_elementwise_dot()) {
        ++at_;
        return {};
    }
    if (starts_remark()) return remark();
    line_start_ = c == '\n' || c == '\v';
    if (starts_volume()) return volume();
    if (c == '&' && peek(1) == '&') {
        push(TokenKind::Name, "and", 2);
    } else if (line_start_ || c == ';') {
        push(TokenKind::Break, text_.substr(at_, 1), 1);
    } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
        const std::size_t length = number_length(text_, at_);
        push(TokenKind::Number, text_.substr(at_, length), length);
    } else if (is_letter(c) || c == '_' || is_greek(code_point_at(text_, at_).code)) {
        if (!identifier()) return other_character();
    } else if (c == '\\') {
        return command();
    } else if (std::string_view("+-*/%^()[]{}|&,=<>:!?").contains(c) ||
               (c == '@' && peek(1) == '(')) {
        symbol();
    } else {
        return other_character();
    }
    return {};
}

/// In MATLAB x.^2 applies to each element; every operator does so here.
bool Lexer::is_elementwise_dot() const {
    return peek() == '.' && (peek(1) == '^' || peek(1) == '*' || peek(1) == '/');
}

bool Lexer::starts_remark() const {
    const char c = peek();
    return c == '#' || (c == '%' && line_start_) ||
           (c == '/' && (peek(1) == '/' || peek(1) == '*'));
}

/// Skips a remark: up to the end of the line, or from /* to */.
Done Lexer::remark() {
    if (declaration()) return {};
    if (peek() == '/' && peek(1) == '*') {
        const std::size_t end = text_.find("*/", at_ + 2);
        if (end == std::string_view::npos) {
            return std::unexpected(ParseError{.offset = at_,
                                              .reason = tr("this remark is not closed"),
                                              .hint = tr("add */ where it ends"),
                                              .unfinished = true});
        }
        const bool has_lines = text_.substr(at_, end - at_).contains('\n');
        at_ = end + 2;
        if (line_start_ && has_lines) push(TokenKind::Break, "\n", 0);
        return {};
    }
    if (peek() == '/') note_short_remark();
    at_ += run_length(text_, at_, [](char c) { return c != '\n' && c != '\v'; });
    return {};
}

/// Reads the start of a definition of POV-Ray (#declare, #local) or of C (#define).
bool Lexer::declaration() {
    for (const std::string_view word : {"#declare", "#local", "#define"}) {
        if (!text_.substr(at_).starts_with(word) || is_letter(peek(word.size()))) continue;
        if (word == "#define" && !find_end_of_macro(at_ + word.size())) return false;
        push(TokenKind::Name, "declare", word.size());
        return true;
    }
    return false;
}

/// Finds the end of a macro's name and arguments, which start at `at`, where an "=" is to be added.
/// False if nothing follows.
bool Lexer::find_end_of_macro(std::size_t at) {
    at = std::min(text_.find_first_not_of(" \t", at), text_.size());
    const std::size_t length = name_length(text_, at);
    std::size_t end = at + length;
    if (text_.substr(end).starts_with('(')) end = text_.find_first_of(")(#\n", end + 1);
    if (length == 0 || end >= text_.size()) return false;
    if (text_[end] == ')') ++end;
    const std::size_t value = text_.find_first_not_of(" \t\r", end);
    if (value == std::string_view::npos || text_[value] == '\n') return false;
    if (text_.substr(value).starts_with("//")) return false;
    macro_end_ = end;
    return true;
}

/// The "~" of ~(x < 1) is Python's "not"; elsewhere, and beside commands, it is a space of LaTeX.
bool Lexer::may_negate() const {
    if (peek() != '~' || peek(1) != '(' || is_latex_ || tokens_.empty()) return false;
    const Token& last = tokens_.back();
    return is_connective(last) || is_symbol(last, {"(", "[", "{", "|", "&", ",", "?"});
}

/// Notes that x//2, read as a remark, may have been meant as a quotient without its fraction.
void Lexer::note_short_remark() {
    const auto is_part = [](char c) { return is_letter(c) || is_digit(c); };
    const char before = at_ > 0 ? text_[at_ - 1] : ' ';
    if (!is_part(before) && before != ')') return;
    if (!is_part(peek(2)) && peek(2) != '(') return;
    notes_.add(at_ - 1,
               tr("what stands behind // is a remark; for a whole quotient type floor(a/b)"));
}

/// Reads an ASCII operator; "**" becomes "^".
void Lexer::symbol() {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 10> pairs{
        {{"===", "=="},
         {"!==", "!="},
         {"**", "^"},
         {"==", "=="},
         {":=", ":="},
         {"<=", "<="},
         {">=", ">="},
         {"=<", "<="},
         {"!=", "!="},
         {"<>", "!="}}};
    for (const auto& [typed, meaning] : pairs) {
        if (text_.substr(at_).starts_with(typed))
            return push(TokenKind::Symbol, meaning, typed.size());
    }
    push(TokenKind::Symbol, text_.substr(at_, 1), 1);
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

/// Reads a run of raised digits. The token's text is the run as typed; the parser converts it.
void Lexer::superscript() {
    std::size_t length = 0;
    while (at_ + length < text_.size()) {
        const CodePoint point = code_point_at(text_, at_ + length);
        if (superscript_digit(point.code) == '\0') break;
        length += point.length;
    }
    push(TokenKind::Superscript, text_.substr(at_, length), length);
}

/// Reads letters in italics and the like: a function's name, or one letter after the other.
void Lexer::letters_of_mathematics() {
    static constexpr std::string_view alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    std::string run;
    std::vector<std::pair<char32_t, std::size_t>> letters;
    std::size_t end = at_;
    while (end < text_.size()) {
        const CodePoint point = code_point_at(text_, end);
        const char32_t letter = plain_letter(point.code);
        if (letter == 0) break;
        run += letter < 0x80 ? static_cast<char>(letter) : '?';
        letters.emplace_back(letter, point.length);
        end += point.length;
    }
    const Function* const function = run.size() > 1 ? find_fixed_function(run) : nullptr;
    if (function != nullptr) return push(TokenKind::Name, function->name, end - at_);
    for (const auto& [letter, length] : letters) {
        if (const std::optional<Sign> sign = sign_of(letter)) {
            push_sign(*sign, length);
        } else if (const std::size_t at = alphabet.find(static_cast<char>(letter));
                   at < alphabet.size()) {
            name(alphabet.substr(at, 1), length);
        } else {
            at_ += length;
        }
    }
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
    if (plain_letter(point.code) != 0) {
        letters_of_mathematics();
        return {};
    }
    std::string hint = hint_for_sign(point.code);
    if (peek() == '_') hint = tr("a subscript stands right behind a letter: c_1, c_{12}");
    const bool behind_value =
        !tokens_.empty() && tokens_.back().end() == at_ &&
        (tokens_.back().kind == TokenKind::Name || tokens_.back().kind == TokenKind::Part ||
         is_symbol(tokens_.back(), {")", "]"}));
    if (peek() == '.' && behind_value && is_letter(peek(1))) return part();
    const bool printable = point.length > 1 || (peek() > ' ' && peek() < '\x7F');
    const std::string reason =
        printable ? filled(tr("{0} has no meaning here"), {quoted(text_.substr(at_, point.length))})
                  : filled(tr("the byte {0} has no meaning here"),
                           {std::to_string(static_cast<unsigned char>(peek()))});
    return std::unexpected(ParseError{.offset = at_, .reason = reason, .hint = hint});
}

/// Reads a part of a vector, as .x or .xz.
Done Lexer::part() {
    constexpr std::size_t most_parts = 4;
    const std::size_t length = run_length(text_, at_ + 1, is_letter);
    const std::string_view letters = text_.substr(at_ + 1, length);
    const bool names_parts =
        length <= most_parts && letters.find_first_not_of("xyzw") == std::string_view::npos;
    if (!names_parts) return std::unexpected(error_for_part(letters, at_));
    push(TokenKind::Part, letters, 1 + length);
    return {};
}

Done Lexer::command() {
    const std::size_t letters = run_length(text_, at_ + 1, is_letter);
    const std::string_view word = text_.substr(at_ + 1, letters);
    if (letters == 0) {  // a single sign: \\ ends a line, \{ is a brace, \, and \( mean nothing
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
    if (word == "begin" || word == "end") return environment(word);
    const std::optional<Sign> sign = sign_of_command(word);
    if (!sign) {
        const char32_t of = sign_without_meaning(word);
        return std::unexpected(ParseError{
            .offset = at_,
            .reason = filled(tr("the LaTeX command {0} is not known here"),
                             {quoted(text_.substr(at_, length))}),
            .hint = of != 0 ? hint_for_sign(of) : tr("leave it out or type its meaning")});
    }
    if (sign->text.empty() && word_in_braces(at_ + length)) return {};
    push_sign(*sign, length);
    return {};
}

bool is_symbol(const Token& token, std::initializer_list<std::string_view> symbols) {
    return token.kind == TokenKind::Symbol &&
           std::ranges::find(symbols, token.text) != symbols.end();
}

bool is_connective(const Token& token) {
    return token.kind == TokenKind::Name && (token.text == "and" || token.text == "or");
}

bool adjacent(const Token& first, const Token& second) { return first.end() == second.offset; }

std::expected<std::vector<Token>, ParseError> tokenize(std::string_view text,
                                                       const DefinedNames* defined, Notes& notes) {
    auto tokens = Lexer(text, defined, notes).tokens();
    if (!tokens) return tokens;
    tokens = with_plain_functions(std::move(*tokens));
    return without_inner_line_ends(std::move(*tokens), notes);
}

}  // namespace zeroset
