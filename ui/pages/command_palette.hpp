#pragma once

#include "ui/model/ui_state.hpp"

#include <functional>
#include <string>
#include <vector>

namespace zeroset::ui {

/// A line of the palette.
struct PaletteLine {
    std::string text;
    std::string hint;  ///< its keys, or what kind of line it is
    bool enabled = true;
    bool is_on = false;  ///< a switch that is on
    std::function<void(UiState&)> run = {};
};

/// What `typed` abbreviates, the best first: actions, surfaces of the gallery, recent files. With
/// nothing typed all of them, in that order.
std::vector<PaletteLine> palette_lines(const UiState& state, const std::string& typed);

/// The palette, while `command_palette.open`: a field and the lines it finds. Enter or a click runs
/// one and closes it, Escape closes it.
void draw_command_palette(UiState& state);

}  // namespace zeroset::ui
