// Names in a text: defined names, runs of letters, subscripts.

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/vocabulary/field_source.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/words/lexer_reader.hpp"
#include "engine/language/words/words_defined.hpp"

#include <array>

namespace zeroset {
namespace {

/// Whether the run can be letters with subscripts and numbers. If not, as f_hex_y, it is a single
/// name, known or not.
bool has_pieces(std::string_view run) {
    std::size_t at = 0;
    while (at < run.size()) {
        if (run[at] == '_') return false;
        const CodePoint point = code_point_at(run, at);
        const bool letters = is_letter(run[at]);
        at += point.length;
        if (!letters && !is_greek(point.code)) continue;
        if (letters) at += run_length(run, at, is_letter);
        if (at == run.size() || run[at] != '_') continue;
        if (++at == run.size() || run[at] == '_') return false;
        const auto is_part = [](char c) { return is_letter(c) || is_digit(c); };
        at += is_digit(run[at]) ? run_length(run, at, is_digit) : run_length(run, at, is_part);
        if (run.substr(at).starts_with('{')) at = run.find('}', at) + 1;
    }
    return true;
}

bool is_bracket(char c) { return c == '(' || c == '['; }

}  // namespace

std::size_t name_length(std::string_view text, std::size_t start) {
    const auto is_part = [](char c) { return is_letter(c) || is_digit(c); };
    std::size_t at = start;
    while (at < text.size()) {
        const char c = text[at];
        const char next = at + 1 < text.size() ? text[at + 1] : '\0';
        if (is_part(c) || (c == '_' && (is_part(next) || next == '_'))) {
            ++at;
        } else if (c == '_' && next == '{') {
            const std::size_t length = run_length(text, at + 2, is_part);
            const std::size_t end = at + 2 + length;
            if (length == 0 || end == text.size() || text[end] != '}') break;
            at = end + 1;
        } else if ((static_cast<unsigned char>(c) & 0x80U) != 0) {
            const CodePoint point = code_point_at(text, at);
            if (!is_greek(point.code) && subscript_digit(point.code) == '\0') break;
            at += point.length;
        } else {
            break;
        }
    }
    return at - start;
}

/// Reads a defined name, or the letters up to the next digit or sign.
bool Lexer::identifier() {
    const bool within = at_ < run_end_;  // this is the rest of a run that is no name as a whole
    if (!within) run_end_ = at_ + name_length(text_, at_);
    const std::string_view run = text_.substr(at_, run_end_ - at_);
    if (run.empty()) return skip_pattern_mark();
    constexpr std::size_t longest_rest = 64;
    const bool may_be_defined = !within || run.size() <= longest_rest;
    if (library_prefix(run) || (may_be_defined && defined_name(run))) return true;
    const Function* const numbered = !within && is_digit(run.back()) ? find_function(run) : nullptr;
    if (numbered != nullptr && (!numbered->is_word() || is_bracket(peek(run.size())))) {
        push(TokenKind::Name, run, run.size());  // as vec3
        return true;
    }
    if (defined_ == nullptr || (!within && !has_pieces(run))) {
        push(TokenKind::Name, run, run.size());
    } else {
        const std::size_t letters = run_length(run, 0, is_letter);
        if (letters == 0) return false;
        name(run.substr(0, letters), letters);
    }
    return true;
}

/// Skips the "_" of Mathematica's f[x_, y_].
bool Lexer::skip_pattern_mark() {
    const bool behind_name =
        !tokens_.empty() && tokens_.back().end() == at_ && tokens_.back().kind == TokenKind::Name;
    const bool is_mark = peek() == '_' && behind_name && peek(1) != '\0' &&
                         std::string_view(",])").contains(peek(1));
    if (is_mark) ++at_;
    return is_mark;
}

/// Skips the prefix of a library's name: np.sin, std::sqrt, Math.PI; of any other name where a call
/// follows, as in sp.sqrt(x) and scipy.special.erf(x), since parts of vectors are not called.
bool Lexer::library_prefix(std::string_view run) {
    static constexpr std::array<std::string_view, 7> libraries{"np",    "numpy", "math", "Math",
                                                               "cmath", "std",   "glm"};
    const std::string_view rest = text_.substr(at_ + run.size());
    const std::size_t mark = rest.starts_with("::") ? 2 : rest.starts_with('.') ? 1 : 0;
    if (mark == 0 || mark == rest.size() || !is_letter(rest[mark])) return false;
    const bool is_library = std::ranges::find(libraries, run) != libraries.end();
    const std::size_t length = name_length(rest, mark);
    const std::string_view name = rest.substr(mark, length);
    const std::string_view behind = rest.substr(mark + length);
    const bool is_part = name.find_first_not_of("xyzw") == std::string_view::npos;
    const bool calls =
        !is_part && (behind.starts_with('(') ||
                     (behind.size() > 1 && behind[0] == '.' && is_letter(behind[1])));
    if (!is_library && !calls) return false;
    at_ += run.size() + mark;
    return true;
}

/// Reads the run if it is a defined name, or a defined name at its start that ends in a digit: x2y2
/// is x2*y2.
bool Lexer::defined_name(std::string_view run) {
    if (defined_ == nullptr) return false;
    if (const auto whole = defined_->find(run, at_)) {
        push(TokenKind::Name, *whole, run.size());
        return true;
    }
    constexpr std::size_t longest_start = 64;
    for (std::size_t length = std::min(run.size() - 1, longest_start); length > 1; --length) {
        if (!is_digit(run[length - 1]) || !is_letter(run[length])) continue;
        if (const auto start = defined_->find(run.substr(0, length), at_)) {
            push(TokenKind::Name, *start, length);
            return true;
        }
    }
    return false;
}

bool Lexer::starts_volume() const {
    const bool within = at_ < run_end_;
    return !within && !read_field_call(text_.substr(at_)).call.text.empty();
}

Done Lexer::volume() {
    const FieldCallStart start = read_field_call(text_.substr(at_));
    const std::size_t end = at_ + start.call.text.size();
    if (!start.quotes_closed) {
        return std::unexpected(ParseError{.offset = end - 1,
                                          .reason = tr("the file's name is not closed"),
                                          .hint = tr("add a \" where it ends"),
                                          .unfinished = true});
    }
    if (!start.closed) {
        return std::unexpected(ParseError{.offset = end,
                                          .reason = tr("a ')' is missing behind the file's name"),
                                          .hint = tr("add a ')'"),
                                          .unfinished = end == text_.size()});
    }
    push(TokenKind::Volume, start.call.text, start.call.text.size());
    return {};
}

void Lexer::name(std::string_view text, std::size_t length) {
    push(TokenKind::Name, text, length);
    const std::size_t token = tokens_.size() - 1;
    tokens_[token].subscript = subscript();
    tokens_[token].length = at_ - tokens_[token].offset;
}

std::string_view Lexer::subscript() {
    const auto is_part = [](char c) { return is_letter(c) || is_digit(c); };
    if (peek() == '_') {
        const bool braces = peek(1) == '{';
        const std::size_t begin = at_ + (braces ? 2 : 1);
        // c_1x is the product of c_1 and x.
        const bool digits = !braces && begin < text_.size() && is_digit(text_[begin]);
        const std::size_t length =
            digits ? run_length(text_, begin, is_digit) : run_length(text_, begin, is_part);
        const std::size_t end = begin + length;
        const bool closed = !braces || (end < text_.size() && text_[end] == '}');
        if (length == 0 || !closed) return {};
        at_ = end + (braces ? 1 : 0);
        return text_.substr(begin, length);
    }
    const std::size_t begin = at_;
    while (at_ < text_.size()) {
        const CodePoint point = code_point_at(text_, at_);
        if (subscript_digit(point.code) == '\0') break;
        at_ += point.length;
    }
    return text_.substr(begin, at_ - begin);
}

/// Reads `{letters}` at `at` as one name, as in \operatorname{sgn}.
bool Lexer::word_in_braces(std::size_t at) {
    if (at >= text_.size() || text_[at] != '{') return false;
    const std::size_t length = run_length(text_, at + 1, is_letter);
    const std::size_t end = at + 1 + length;
    if (length == 0 || end >= text_.size() || text_[end] != '}') return false;
    const std::size_t begin = at_;
    name(text_.substr(at + 1, length), end + 1 - begin);
    return true;
}

}  // namespace zeroset
