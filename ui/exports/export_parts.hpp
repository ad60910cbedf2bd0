#pragma once

#include "ui/model/ui_state.hpp"

// The parts of the export page, one for each kind of file.

namespace zeroset::ui {

/// Width of the labels in em.
inline constexpr float export_label_em = 6.2F;

/// Draws what can be chosen. `format`: the chosen one.
void draw_picture_part(UiState& state, const ExportFormat& format);
/// Draws the film's frames as a line on which one is chosen to be shown, or all are played.
void draw_film_timeline(UiState& state);
void draw_film_part(UiState& state, const ExportFormat& format);
void draw_mesh_part(UiState& state, const ExportFormat& format);
void draw_drawing_part(UiState& state);

/// Draws a label in the width of this page; the control that follows fills the rest of the line.
void draw_export_label(const char* label, const char* about);

/// Draws the size in pixels, with a list of usual sizes. `even`: odd
/// numbers become the next even ones.
void draw_size_fields(glm::ivec2& size_px, const glm::ivec2& window_px, int largest,
                      bool even = false);

/// Draws the checkboxes of smooth edges and of a transparent background, where there can be one.
void draw_surface_checks(bool& smooth, bool& alpha, bool has_alpha);

}  // namespace zeroset::ui
