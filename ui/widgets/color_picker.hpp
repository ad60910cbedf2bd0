#pragma once

#include "document/document.hpp"
#include "ui/style/theme.hpp"

#include <cstdint>

struct ImDrawList;
struct ImVec2;

namespace zeroset::ui {

/// Draws the colour of a surface as a disc, or as a ring where the surface is hidden.
void draw_color_dot(ImDrawList& canvas, const ImVec2& centre, float radius,
                    const Statement& statement, const Palette& colors, bool hovered);

/// The kind of a surface, which decides what its popup offers.
struct SurfaceKind {
    bool is_thick = false;  ///< it is a curve or a point
    Box clip;               ///< the document's clip box
};

/// Draws the popup `id` if it is open: the palette's colours, a picker of any other colour, how
/// opaque the surface is, the side that is solid or how thick the curve is, and a clip box of its
/// own. Edits these in `statement`.
void draw_surface_popup(const char* id, Statement& statement, const SurfaceKind& kind,
                        const Palette& colors);

/// Draws a field that shows a colour 0xRRGGBB; a click opens a picker. True when another one was
/// picked.
bool draw_color_field(const char* id, std::uint32_t& color, const char* about);

}  // namespace zeroset::ui
