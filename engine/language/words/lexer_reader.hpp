#pragma once

#include "engine/language/words/lexer.hpp"
#include "engine/language/words/signs.hpp"

#include <algorithm>
#include <cstddef>
#include <expected>
#include <string_view>
#include <vector>

// Private to tokenize(): reads a text character by character.

namespace zeroset {

/// The number of characters from `start` on that satisfy the predicate, up to the first that does
/// not.
template <class Predicate>
std::size_t run_length(std::string_view text, std::size_t start, Predicate predicate) {
    if (start >= text.size()) return 0;
    const auto rest = text.substr(start);
    const auto* const end = std::ranges::find_if_not(rest, predicate);
    return static_cast<std::size_t>(end - rest.begin());
}

/// The length of the run of letters, digits and subscripts at `start`: Iso_2, c_{12}, α1, x₁.
std::size_t name_length(std::string_view text, std::size_t start);

using Done = std::expected<void, ParseError>;

class Lexer {
public:
    Lexer(std::string_view text, const DefinedNames* defined, Notes& notes)
        : text_(text), defined_(defined), notes_(notes), is_latex_(text.contains('\\')) {}

    std::expected<std::vector<Token>, ParseError> tokens();

private:
    Done step();
    void letters_of_mathematics();
    Done other_character();
    Done command();
    Done environment(std::string_view word);
    Done begin_cases(std::size_t length);
    Done end_cases(std::size_t length);
    Done part();
    [[nodiscard]] bool starts_volume() const;
    Done volume();
    [[nodiscard]] bool is_elementwise_dot() const;
    [[nodiscard]] bool starts_remark() const;
    Done remark();
    bool declaration();
    bool find_end_of_macro(std::size_t at);
    [[nodiscard]] bool may_negate() const;
    void note_short_remark();
    bool identifier();
    bool library_prefix(std::string_view run);
    bool defined_name(std::string_view run);
    bool skip_pattern_mark();
    void name(std::string_view text, std::size_t length);
    void push_sign(const Sign& sign, std::size_t length);
    void symbol();
    bool word_in_braces(std::size_t at);
    void superscript();
    /// Reads the subscript at `at_`, if there is one; else returns an empty text.
    std::string_view subscript();

    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    void push(TokenKind kind, std::string_view text, std::size_t length) {
        tokens_.push_back({.kind = kind, .text = text, .offset = at_, .length = length});
        at_ += length;
    }

    std::string_view text_;
    const DefinedNames* defined_;
    Notes& notes_;
    bool is_latex_;  ///< the text has LaTeX commands
    std::size_t at_ = 0;
    std::size_t macro_end_ = std::string_view::npos;  ///< where the missing "=" of a #define
                                                      ///< belongs
    std::size_t run_end_ = 0;                         ///< end of the last run of letters and digits
    bool line_start_ = true;  ///< only spaces and remarks since the last line end
    std::vector<Token> tokens_;
    std::vector<std::size_t> cases_;  ///< indices of the first tokens of open cases of LaTeX
};

}  // namespace zeroset
