#include "document/import/script_tokens.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

bool is_letter(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '_';
}

/// The reader of one text.
class Splitter {
public:
    Splitter(std::string_view text, bool nested) : text_(text), nested_(nested) {}

    std::vector<ScriptToken> run() {
        std::vector<ScriptToken> tokens;
        while (skip_blanks(), at_ < text_.size())
            tokens.push_back(token());
        tokens.push_back({.line = line_});
        return tokens;
    }

private:
    [[nodiscard]] char at(std::size_t ahead) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }

    void pass() {
        if (text_[at_] == '\n') ++line_;
        ++at_;
    }

    void skip_remark() {
        int depth = 0;
        while (at_ < text_.size()) {
            const bool opens = at(0) == '/' && at(1) == '*' && (nested_ || depth == 0);
            const bool closes = at(0) == '*' && at(1) == '/';
            if (opens || closes) at_ += 2;
            depth += opens ? 1 : closes ? -1 : 0;
            if (depth == 0) return;
            if (!opens && !closes) pass();
        }
    }

    void skip_blanks() {
        while (at_ < text_.size()) {
            if (at(0) == '/' && at(1) == '/') {
                while (at_ < text_.size() && text_[at_] != '\n')
                    ++at_;
            } else if (at(0) == '/' && at(1) == '*') {
                skip_remark();
            } else if (static_cast<unsigned char>(text_[at_]) <= ' ') {
                pass();
            } else {
                return;
            }
        }
    }

    [[nodiscard]] std::size_t number_end() const {
        std::size_t end = at_;
        const auto digits = [&] {
            while (end < text_.size() && is_digit(text_[end]))
                ++end;
        };
        digits();
        if (end < text_.size() && text_[end] == '.') ++end;
        digits();
        if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
            std::size_t exponent = end + 1;
            if (exponent < text_.size() && (text_[exponent] == '-' || text_[exponent] == '+'))
                ++exponent;
            if (exponent < text_.size() && is_digit(text_[exponent])) {
                end = exponent;
                digits();
            }
        }
        return end;
    }

    ScriptToken cut(ScriptKind kind, std::size_t end) {
        const ScriptToken token{.kind = kind, .text = text_.substr(at_, end - at_), .line = line_};
        at_ = end;
        return token;
    }

    ScriptToken quoted() {
        ScriptToken token{.kind = ScriptKind::Text, .line = line_};
        const std::size_t begin = ++at_;
        while (at_ < text_.size() && text_[at_] != '"')
            pass();
        token.text = text_.substr(begin, at_ - begin);
        if (at_ < text_.size()) ++at_;
        return token;
    }

    ScriptToken token() {
        const char letter = text_[at_];
        if (letter == '"') return quoted();
        if (is_digit(letter) || (letter == '.' && is_digit(at(1))))
            return cut(ScriptKind::Number, number_end());
        if (is_letter(letter)) {
            std::size_t end = at_;
            while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end])))
                ++end;
            return cut(ScriptKind::Name, end);
        }
        static constexpr std::array<std::string_view, 6> pairs{"==", "!=", "<=", ">=", "&&", "||"};
        const bool pair = std::ranges::find(pairs, text_.substr(at_, 2)) != pairs.end();
        return cut(ScriptKind::Sign, at_ + (pair ? 2 : 1));
    }

    std::string_view text_;
    bool nested_;
    std::size_t at_ = 0, line_ = 1;
};

}  // namespace

std::vector<ScriptToken> script_tokens(std::string_view text, bool nested) {
    return Splitter(text, nested).run();
}

const ScriptToken& TokenReader::peek(std::size_t ahead) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

const ScriptToken& TokenReader::next() {
    const ScriptToken& token = peek();
    if (at_ + 1 < tokens_.size()) ++at_;
    return token;
}

bool TokenReader::at_sign(std::string_view sign, std::size_t ahead) const {
    return peek(ahead).kind == ScriptKind::Sign && peek(ahead).text == sign;
}

bool TokenReader::at_name(std::string_view name, std::size_t ahead) const {
    return peek(ahead).kind == ScriptKind::Name && peek(ahead).text == name;
}

bool TokenReader::take_sign(std::string_view sign) {
    if (!at_sign(sign)) return false;
    next();
    return true;
}

bool TokenReader::take_name(std::string_view name) {
    if (!at_name(name)) return false;
    next();
    return true;
}

void TokenReader::append(std::span<const ScriptToken> tokens) {
    tokens_.insert(tokens_.end(), tokens.begin(), tokens.end());
}

void TokenReader::replace_from(std::size_t begin, std::span<const ScriptToken> tokens) {
    const auto first = tokens_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = tokens_.begin() + static_cast<std::ptrdiff_t>(at_);
    tokens_.insert(tokens_.erase(first, last), tokens.begin(), tokens.end());
    at_ = begin;
}

void TokenReader::skip_block(std::string_view open, std::string_view close) {
    if (!take_sign(open)) return;
    for (std::size_t depth = 1; depth > 0 && !at_end(); next()) {
        if (at_sign(open)) ++depth;
        if (at_sign(close)) --depth;
    }
}

}  // namespace zeroset
