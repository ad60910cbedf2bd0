#pragma once

#include "document/look.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/style/theme.hpp"

struct ImDrawList;
struct ImVec2;

namespace zeroset::ui {

/// What the colours of a picture tell. `coloring`: its own, with the range if it has one;
/// `expression`: for ColorBy::Expression.
Legend legend_of(const Coloring& coloring, const std::string& expression);

/// "mean curvature": how a choice is called.
const char* shown_name(ColorBy by);

/// The map's colours from left to right over a rectangle, in window coordinates.
void draw_map_bar(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi, ColorMap map);

/// What of the pixels is marked.
enum class Mark : std::uint8_t { UndecidedDrawn, UndecidedNotDrawn, Coarse };

/// A square as such pixels look.
void draw_mark_swatch(ImDrawList& canvas, const ImVec2& lo, float size, Mark mark,
                      const Palette& colors);

/// What is to be said in the picture's corner.
struct CornerLegend {
    const Legend* legend = nullptr;  ///< nullptr: the colours need no words
    bool undecided = false;          ///< undecided pixels are marked
    bool coarse = false;             ///< and there are certified ones with a coarse bracket
};

/// A card whose right lower corner is `corner`, no wider than `room` (window coordinates); nothing
/// where there is nothing to say or no room.
void draw_corner_legend(ImDrawList& canvas, const ImVec2& corner, const ImVec2& room,
                        const CornerLegend& what, const Palette& colors);

}  // namespace zeroset::ui
