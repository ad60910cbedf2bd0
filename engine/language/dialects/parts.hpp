#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

// Words, brackets and lists of texts as programs write them. Brackets in quotes and remarks do not
// count.

namespace zeroset {

/// Signs that end a line; \v does within a row.
inline constexpr std::string_view line_ends = "\n\v\r";
/// Bytes of a remark that is passed over.
inline constexpr std::size_t longest_remark = 5'000;

/// Finds where remarks end, in a text that is gone through forwards.
class RemarkEnds {
public:
    explicit RemarkEnds(std::string_view mark) : mark_(mark) {}

    /// The length of the remark at the start of a text, which begins with two signs; 0: it has no
    /// end nearby.
    std::size_t length(std::string_view text);

private:
    std::string_view mark_;
    const char* none_before_ = nullptr;  ///< up to where there is no end
};

/// The length of the word at the start of a text: letters, digits and "_", no digit first.
std::size_t word_length(std::string_view text);
/// Whether all of a text is one word.
bool is_word(std::string_view text);
/// Whether all of a text is one word or a sign of Mathematica, as \[Theta].
bool is_name(std::string_view text);
/// The number of blanks (no line ends) at the start of a text.
std::size_t blank_length(std::string_view text);

/// The index of the bracket that closes the one at the start of a text; nothing where none does.
std::optional<std::size_t> closing_bracket(std::string_view text);
/// The parts of a text between signs outside brackets, trimmed; one at least.
std::vector<std::string_view> split_outside(std::string_view text, char sign);
/// The index of the first of `words` that stands by itself outside brackets; npos: none.
std::size_t find_outside(std::string_view text, std::string_view word);
/// The inside of a text that is one pair of brackets: (...), [...] or {...}.
std::optional<std::string_view> in_brackets(std::string_view text);
/// The inside of a text in quotation marks.
std::optional<std::string_view> in_quotes(std::string_view text);

/// The end of the statement that starts at `begin`: a line end or ";" outside brackets, or the end
/// of the text.
std::size_t end_of_statement(std::string_view text, std::size_t begin);

/// A variable and its ends: {x, -1, 1}, (x, -1, 1), [x, -1, 1], x = -1..1.
struct NamedRange {
    std::string_view name, lo, hi;
};
std::optional<NamedRange> named_range(std::string_view argument);

/// A function without a name: @(x, y) x - y, lambda x, y: x - y, (x, y) -> x - y, x -> x^2,
/// Function[{x, y}, x - y].
struct UnnamedFunction {
    std::vector<std::string_view> names;
    std::string_view body;
};
std::optional<UnnamedFunction> unnamed_function(std::string_view text);

}  // namespace zeroset
