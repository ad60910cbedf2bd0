#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Private to the words room: the parts of a call as other programs write it.

namespace zeroset {

/// Whether the text is one name.
bool is_word(std::string_view text);
/// The length of the name that the text begins with; 0: it begins with none.
std::size_t word_length(std::string_view text);
/// Where the bracket that the text begins with is closed, as an offset in the text; nullopt: it is
/// not. Quoted text counts as none.
std::optional<std::size_t> closing_bracket(std::string_view text);
/// What stands between marks outside of all brackets and quotes, without blanks around it. A blank
/// as a mark stands for any number of blanks.
std::vector<std::string_view> split_outside(std::string_view text, char mark);
/// What is in the brackets that are all of the text; nullopt: they are not.
std::optional<std::string_view> in_brackets(std::string_view text);

/// A variable and the ends of its range.
struct CommandRange {
    std::string_view name, lo, hi;

    /// As a condition: -1<x<1.
    [[nodiscard]] std::string text() const;
};

/// The range that an argument is: {x, -1, 1}, (x, -1, 1) or x = -1..1.
std::optional<CommandRange> range_of(std::string_view argument);
/// A function without a name, as MATLAB writes it: @(u, v) u + v.
struct CommandHandle {
    std::vector<std::string_view> names;
    std::string_view body;
};
std::optional<CommandHandle> handle_of(std::string_view argument);

}  // namespace zeroset
