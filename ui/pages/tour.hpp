#pragma once

#include "ui/model/ui_state.hpp"

#include <cstddef>

namespace zeroset::ui {

inline constexpr std::size_t tour_steps = 5;

/// Ends the tour at Escape, unless the key is for something else. Called before the panels.
void follow_tour_keys(UiState& state);

/// Draws the step of the tour that the user is at: a card beside the part of the window that it is
/// about, with a frame around that. Everything else stays usable.
void draw_tour(UiState& state);

}  // namespace zeroset::ui
