#pragma once

#include "engine/language/dialects/parts.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

namespace zeroset {

/// Goes through a text step by step.
class TextCursor {
public:
    explicit TextCursor(std::string_view text, std::size_t at = 0) : text_(text), at_(at) {}

    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] bool is_at_end() const { return at_ >= text_.size(); }
    [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }
    [[nodiscard]] std::string_view text() const { return text_; }
    void skip(std::size_t length) { at_ = std::min(at_ + length, text_.size()); }
    void skip_blanks() { skip(blank_length(rest())); }
    void skip_any(std::string_view signs) {
        skip(std::min(rest().find_first_not_of(signs), rest().size()));
    }
    bool take(std::string_view sign) {
        if (!rest().starts_with(sign)) return false;
        skip(sign.size());
        return true;
    }
    /// The word that stands here; empty: none.
    [[nodiscard]] std::string_view word() const { return rest().substr(0, word_length(rest())); }
    bool take_word(std::string_view word) {
        if (this->word() != word) return false;
        skip(word.size());
        skip_blanks();
        return true;
    }
    /// Takes what is in the brackets that open here.
    std::optional<std::string_view> take_brackets(char opener) {
        if (is_at_end() || rest().front() != opener) return std::nullopt;
        const auto closer = closing_bracket(rest());
        if (!closer) return std::nullopt;
        const std::string_view inside = rest().substr(1, *closer - 1);
        skip(*closer + 1);
        return inside;
    }

private:
    std::string_view text_;
    std::size_t at_;
};

}  // namespace zeroset
