// Where a line continues the statement of the line before it.

#include "engine/base/translation.hpp"
#include "engine/language/vocabulary/parse_notes.hpp"
#include "engine/language/words/lexer.hpp"
#include "engine/language/words/words_defined.hpp"

#include <span>
#include <utility>

namespace zeroset {
namespace {

/// Whether no statement can begin with this token. "%" is missing: at the start of a line it begins
/// a remark.
bool goes_on(const Token& token) {
    return token.kind == TokenKind::Superscript || is_connective(token) ||
           is_symbol(token, {"*", "/", "^", ")", "]", "}", ",", "=", "==", ":=", "<", ">",
                             "<=", ">=", "!=", "|)", "&", "?"});
}

/// Whether no statement can end with this token.
bool wants_more(const Token& token) {
    return is_connective(token) ||
           is_symbol(token, {"+", "-", "*", "/", "%", "^", ",", "=", "==", ":=", "<", ">",
                             "<=", ">=", "!=", "!", "&", "?"});
}

/// Whether the tokens are the head of a function as programs write it: `float f(vec2 u, float v)`.
bool is_program_head(std::span<const Token> tokens) {
    std::size_t at = 0;
    while (at + 1 < tokens.size() && declares(tokens[at], tokens[at + 1]))
        ++at;
    if (at == 0 || at + 1 >= tokens.size() || !is_symbol(tokens[at + 1], {"("})) return false;
    at += 2;
    while (at < tokens.size() &&
           (tokens[at].kind == TokenKind::Name || is_symbol(tokens[at], {","})))
        ++at;
    return at + 1 == tokens.size() && is_symbol(tokens[at], {")"});
}

class LineJoiner {
public:
    LineJoiner(std::vector<Token> tokens, Notes& notes)
        : tokens_(std::move(tokens)), notes_(notes) {}

    std::vector<Token> joined() {
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (!is_line_end(tokens_[i]) || (!joins(i) && !joins_sign(i))) take(tokens_[i]);
        }
        tokens_.resize(kept_);
        return std::move(tokens_);
    }

private:
    static bool is_line_end(const Token& token) {
        return token.kind == TokenKind::Break && token.text != ";";
    }
    void take(const Token& token) {
        if (is_symbol(token, {"(", "[", "{"})) ++open_;
        if (is_symbol(token, {")", "]", "}"}) && open_ > 0) --open_;
        if (is_symbol(token, {"=", "==", ":="})) has_equals_ = true;
        if (is_symbol(token, {"?"})) ++choices_;
        if (token.kind == TokenKind::Break) {
            open_ = 0;
            choices_ = 0;
            has_equals_ = false;
            statement_ = kept_ + 1;
        }
        tokens_[kept_++] = token;
    }
    /// Whether the next line that is not empty begins with the "{" of a function whose head was
    /// before it.
    [[nodiscard]] bool opens_body(std::size_t at) const {
        while (is_line_end(tokens_[at]))
            ++at;
        return is_symbol(tokens_[at], {"{"}) &&
               is_program_head(std::span(tokens_).first(kept_).subspan(statement_));
    }
    /// Whether the statement continues after the line end at index `at`.
    [[nodiscard]] bool joins(std::size_t at) const {
        const Token& next = tokens_[at + 1];
        if (open_ > 0 || kept_ == 0) return true;
        const Token& last = tokens_[kept_ - 1];
        if (last.kind == TokenKind::Break || wants_more(last) || goes_on(next)) return true;
        if (opens_body(at)) return true;
        const bool between_values = is_symbol(last, {":"}) || is_symbol(next, {":"});
        return between_values && choices_ > 0;
    }
    /// Whether the line after `at` starts with a sign and continues the statement.
    bool joins_sign(std::size_t at) {
        const Token& next = tokens_[at + 1];
        if (!is_symbol(next, {"+", "-"})) return false;
        const bool within_row = tokens_[at].text == "\v";
        const bool joins = within_row ? !has_equals_ || !equation_starts(at + 1)
                                      : !has_equals_ && is_symbol(next, {"+"});
        if (joins && (has_equals_ || !within_row)) {
            notes_.add(next.offset,
                       tr("this line goes on with the one above; to part them put ; between"));
        }
        return joins;
    }
    /// Whether an "=" stands between `at` and the next break.
    [[nodiscard]] bool equation_starts(std::size_t at) const {
        while (tokens_[at].kind != TokenKind::Break && tokens_[at].kind != TokenKind::End) {
            if (is_symbol(tokens_[at++], {"=", "==", ":="})) return true;
        }
        return false;
    }

    std::vector<Token> tokens_;
    Notes& notes_;
    std::size_t kept_ = 0;       ///< number of tokens kept so far, at the front of tokens_
    std::size_t statement_ = 0;  ///< index of the statement's first token
    int open_ = 0;               ///< open brackets
    int choices_ = 0;            ///< "?" in the statement so far
    bool has_equals_ = false;    ///< the statement so far has an "="
};

}  // namespace

std::vector<Token> without_inner_line_ends(std::vector<Token> tokens, Notes& notes) {
    return LineJoiner(std::move(tokens), notes).joined();
}

}  // namespace zeroset
