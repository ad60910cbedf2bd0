#pragma once

#include <span>
#include <string_view>

namespace zeroset {

/// The word with the fewest insertions, deletions, replacements and swaps of neighbours away
/// from `typed`; the first of equals. `words` must not be empty.
std::string_view nearest_word(std::string_view typed, std::span<const std::string_view> words);

}  // namespace zeroset
