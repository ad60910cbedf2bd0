#pragma once

#include "document/document.hpp"
#include "engine/scene/settings.hpp"
#include "ui/model/edited.hpp"
#include "ui/model/shown.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/model/wishes.hpp"

#include <string>

// The sections of the side panel, in the order of the alphabet: each is drawn, and tells how high
// its contents are, in window coordinates (..._section_height). Each has a source of its own.

namespace zeroset::ui {

/// The tracer that draws, another one to compare it with, and what pixels cost.
void draw_advanced_section(UiState& state);
float advanced_section_height(const UiState& state);

/// Draws the saved views, each with a small picture that a click goes to, and the camera as numbers
/// that can be typed.
void draw_camera_section(UiState& state);
float camera_section_height(const UiState& state);

/// Draws the settings of the clip region: box, sphere, sections. Edits the document's `clip` and
/// `region` and how sections show values; wishes to frame the box once a number of it is typed.
void draw_clip_section(Edited& edited, const Shown& shown, Wishes& wishes);
float clip_section_height(const Edited& edited);

/// Returns `box` scaled about its centre so that its longest edge is 2 * half.
Box resized(const Box& box, double half);

/// The search depth, marks of what is not proved, and the figures of the last full picture: its
/// time and size, how many pixels are certified and how many undecided, how wide the view is and in
/// what precision it was traced.
void draw_details_section(Edited& edited, const Shown& shown);
float details_section_height(const Document& document, const Shown& shown);

/// True where so many pixels are undecided that a person who looks at the picture should know.
bool many_undecided(const PictureFigures& figures);

/// "1 234 undecided, 7 of them not drawn".
std::string undecided_text(const PictureFigures& figures);
/// "12.5 ms".
std::string frame_time(double ms);

/// Draws the settings of what surfaces look as if they were made of, mirrors, the background, and
/// lights. Edits the document's `light`.
void draw_light_section(UiState& state);
float light_section_height(const Document& document);

/// Draws the settings of surface colours: the coloured quantity, colour map, range, contour
/// lines. Edits the document's `coloring`.
void draw_look_section(Edited& edited, const Shown& shown);
float look_section_height(const Document& document, const ReadingFacts& reading);

/// Draws a field into which a point is typed, the list of markers with coordinates, to the digits
/// that their labels in the picture have, and distances from the selected one, and the selected
/// one's label. Markers can be selected, copied, snapped to special points and removed. Edits the
/// document's `markers` and `selected_marker`.
void draw_marker_section(UiState& state);
float marker_section_height(const UiState& state);

/// Draws how one moves: the up direction, how dragging turns the view, what the wheel does.
void draw_space_section(UiState& state);
float space_section_height();

/// Draws what most people set: axes, box, grid and names, views along the axes, smooth edges,
/// shadows, perspective, first view and theme.
void draw_view_section(UiState& state);
float view_section_height();

}  // namespace zeroset::ui
