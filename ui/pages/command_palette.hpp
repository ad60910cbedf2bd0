#pragma once

#include "ui/model/ui_state.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset::ui {

/// One entry of the command palette.
struct PaletteLine {
    std::string text;
    std::string hint;  ///< keys of the action, or the kind of the entry
    bool enabled = true;
    bool is_on = false;            ///< true for a switch that is on
    bool replaces = false;         ///< the document: not found by scattered letters
    bool is_control = false;       ///< of the panel; commands that match as well come first
    std::string other_words = {};  ///< by which it is found, too, see ui/actions/other_words.hpp
    std::string found_by = {};     ///< the one of them by which it was found; or empty
    std::function<void(UiState&)> run = {};
};

/// Returns the entries that `typed` abbreviates, best match first: actions and controls of the
/// panel, by other words that tell of them, too, gallery surfaces and recent files; where a point
/// is typed, first the way there. If `typed` is empty, returns all of them in that order, without
/// the controls.
std::vector<PaletteLine> palette_lines(const UiState& state, const std::string& typed);

/// Draws the command palette while `command_palette.open`: a text field and the matching entries.
/// Enter or a click runs an entry and closes the palette; Escape closes it.
void draw_command_palette(UiState& state);

}  // namespace zeroset::ui
