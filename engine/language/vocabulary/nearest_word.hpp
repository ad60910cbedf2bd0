#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace zeroset {

/// The word that the fewest insertions, deletions, replacements and swaps of neighbours turn
/// `typed` into, regardless of case; of several, the first one. `words` must not be empty.
std::string_view nearest_word(std::string_view typed, std::span<const std::string_view> words);

/// The nearest word if it is near enough to have been meant: at most half of `typed` is wrong.
std::optional<std::string_view> meant_word(std::string_view typed,
                                           std::span<const std::string_view> words);

}  // namespace zeroset
