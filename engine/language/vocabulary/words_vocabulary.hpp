#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

// The names that runs of letters in a text can be split into.

namespace zeroset {

/// A transparent hash, so that a set of strings can be searched for a view.
struct TextHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
        return std::hash<std::string_view>()(text);
    }
};
using NameSet = std::unordered_set<std::string, TextHash, std::equal_to<>>;
template <class Value>
using NameMap = std::unordered_map<std::string, Value, TextHash, std::equal_to<>>;

/// The names with a value in every text: x y z w t, r rho theta phi, pi tau e golden.
std::span<const std::string_view> built_in_values();
bool is_built_in_value(std::string_view name);
/// Whether the value depends on the point: x, y, z, r, rho, theta, phi.
bool is_place(std::string_view name);
/// Whether the word is a built-in value, a function or a connective.
bool is_built_in(std::string_view word);
/// Whether the word joins or negates conditions: and, or, not.
bool is_logic_word(std::string_view word);
/// The word with its capital letters made small.
std::string in_small_letters(std::string_view word);

/// The letters and words that runs of letters are split into: xsiny into x, sin, y.
class Vocabulary {
public:
    Vocabulary();

    /// Adds a letter that stands alone somewhere in the text.
    void add_letter(char letter) { letters_.at(static_cast<unsigned char>(letter)) = true; }
    void add_word(std::string_view word);

    [[nodiscard]] bool has_letter(char letter) const {
        return letters_.at(static_cast<unsigned char>(letter));
    }
    [[nodiscard]] bool knows_letter(char letter) const;
    [[nodiscard]] bool knows_word(std::string_view word) const;
    /// Lengths of the fewest known names that the run can be split into; empty if it cannot. Before
    /// a subscript the last name is a single letter.
    [[nodiscard]] std::vector<std::size_t> pieces(std::string_view run, bool subscript) const;

private:
    /// A letter or a word.
    [[nodiscard]] bool knows(std::string_view name) const;
    [[nodiscard]] bool may_know(std::string_view word) const;
    void expect_word(std::string_view word);

    std::array<bool, 256> letters_{};
    std::array<std::uint32_t, 256> lengths_{};  ///< bit n: some word with this first letter has n
                                                ///< letters
    NameSet words_;
};

}  // namespace zeroset
