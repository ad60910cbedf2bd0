#pragma once

#include "engine/annotate/card_style.hpp"
#include "engine/annotate/shapes.hpp"
#include "ui/model/theme.hpp"

struct ImDrawList;
struct ImVec2;

namespace zeroset::ui {

/// Draws shapes on a canvas whose left upper corner is `origin`; their pixels are window
/// coordinates.
void draw_shapes(ImDrawList& list, const ImVec2& origin, const Shapes& shapes);

/// Size of the small font, as the em of a Text.
double small_em();

/// How legend, markers and tags look in the window: of the theme's colours, in the small font.
CardStyle card_style(Theme theme);

}  // namespace zeroset::ui
