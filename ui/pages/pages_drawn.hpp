#pragma once

#include "ui/model/dialog_state.hpp"
#include "ui/model/input.hpp"
#include "ui/model/pages.hpp"
#include "ui/model/shown.hpp"
#include "ui/model/theme.hpp"
#include "ui/model/ui_state.hpp"

#include <cstddef>
#include <vector>

// The pages over the picture: each is drawn while it is open. Each has a source of its own.

namespace zeroset::ui {

/// Draws the question or the file choice, if there is one. Escape cancels it.
void draw_dialogs(Dialogs& dialogs, Theme theme);

/// Draws the gallery while `gallery_page.open`: groups of cards over the picture, or over the whole
/// window if the picture is narrow. A click or Enter sets `surface`; arrows select, letters search,
/// Escape closes.
void draw_gallery_page(UiState& state);

/// Closes the help on Escape, and hides that key press from everything else. Called first in a
/// frame.
void follow_help_keys(HelpPage& page, const Input& input);

/// Draws the help while it is open: the entries of `language` that match the page's filter, and the
/// keys. It takes no keyboard when it opens, so that typing can go on.
void draw_help_panel(HelpPage& page, const std::vector<HelpSection>& language, Theme theme);

inline constexpr std::size_t tour_steps = 5;

/// Ends the tour at Escape, unless the key is for something else. Called before the panels.
void follow_tour_keys(UiState& state);

/// Draws the step of the tour that the user is at: a card beside the part of the window that it is
/// about, with a frame around that. Everything else stays usable.
void draw_tour(UiState& state);

}  // namespace zeroset::ui
