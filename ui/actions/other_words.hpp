#pragma once

#include <span>
#include <string_view>

namespace zeroset::ui {

/// Words by which people look for an action whose name has none of them.
struct OtherWords {
    std::string_view action;  ///< its name
    std::string_view words;   ///< apart by ", "; small letters
};

/// The words of all actions that have some, in the order of the actions.
std::span<const OtherWords> other_words();

/// The words of the action of this name; empty if it has none.
std::string_view other_words_of(std::string_view action);

}  // namespace zeroset::ui
