#pragma once

#include <string>

namespace zeroset::ui {

/// Shows a tooltip while the pointer is over the last item, in lines of at most `width` em.
void draw_tooltip(const std::string& text, float width = 22.0F);

/// Draws the text as one item, cut with an ellipsis at `width` (window coordinates). Returns true
/// if it was cut.
bool draw_elided(const std::string& text, float width);

/// Returns the text in one line: each line break becomes "; ".
std::string in_one_line(const std::string& text);

}  // namespace zeroset::ui
