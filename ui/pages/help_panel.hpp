#pragma once

#include "ui/model/input.hpp"
#include "ui/model/pages.hpp"
#include "ui/model/shown.hpp"
#include "ui/model/theme.hpp"

#include <vector>

namespace zeroset::ui {

/// Closes the help on Escape, and hides that key press from everything else. Called first in a
/// frame.
void follow_help_keys(HelpPage& page, const Input& input);

/// Draws the help while it is open: the entries of `language` that match the page's filter, and the
/// keys. It takes no keyboard when it opens, so that typing can go on.
void draw_help_panel(HelpPage& page, const std::vector<HelpSection>& language, Theme theme);

}  // namespace zeroset::ui
