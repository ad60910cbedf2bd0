#pragma once

#include "ui/model/shown.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <cstddef>
#include <string>
#include <vector>

namespace zeroset::ui {

/// Place of one gallery entry on the gallery page.
struct Card {
    std::size_t item;  ///< index of the entry in the gallery
    int row;           ///< counted from 0 through all groups
    int col;
};

/// Returns the cards of the entries that contain all words of `search`, group by group in the
/// gallery's order, those of other documents first; each group begins a new row. Where a title has
/// what is searched, its group and the entry in it come first.
std::vector<Card> cards_of(const std::vector<GalleryEntry>& gallery, const std::string& search,
                           int columns);

/// Returns the item selected after a step of `rows` and `cols` from `selected`; a step along a row
/// continues in the next one. Returns the first item if `selected` has no card. `cards` is not
/// empty.
std::size_t stepped(const std::vector<Card>& cards, std::size_t selected, int rows, int cols);

/// Draws a small picture of surfaces over a sky; three dots while there is none. `name`: OpenGL's
/// of its texture; 0: none.
void draw_thumbnail(unsigned int name, const ImVec2& lo, const ImVec2& hi, const Palette& colors);

}  // namespace zeroset::ui
