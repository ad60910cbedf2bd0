#pragma once

#include "ui/model/ui_state.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace zeroset::ui {

/// A card of the gallery's page.
struct Card {
    std::size_t item;  ///< line of the gallery
    int row;           ///< from 0 through all groups
    int col;
};

/// The cards whose texts have all words of `search`, group by group in the gallery's order; each
/// group begins a row of its own.
std::vector<Card> cards_of(const std::vector<GalleryEntry>& gallery, const std::string& search,
                           int columns);

/// The item selected after a step of so many rows and columns from `selected`; a step along a row
/// goes on in the next one. The first card where `selected` has none. `cards` is not empty.
std::size_t stepped(const std::vector<Card>& cards, std::size_t selected, int rows, int cols);

}  // namespace zeroset::ui
