#pragma once

#include <cstddef>
#include <string_view>

namespace zeroset {

/// The prompts of a text that was copied out of a program's window, and the program's answers.
class Prompts {
public:
    explicit Prompts(std::string_view typed) : typed_(typed) {}

    /// The offset behind the prompt at `at`, if there is one: sage:, >>>, In[1]:=, (%i1); also
    /// behind Maple's with(plots): and restart:, which more may follow.
    [[nodiscard]] std::size_t behind(std::size_t at) const;
    /// Whether the line at `at` is what a program answered: it has no prompt, as others have.
    [[nodiscard]] bool is_output(std::size_t at) const;

private:
    [[nodiscard]] bool has(std::string_view prompt) const;

    std::string_view typed_;
};

}  // namespace zeroset
