#pragma once

#include <string>

namespace zeroset::ui {

/// Explains the item before while the pointer is over it, in lines of at most `width` em.
void draw_tooltip(const std::string& text, float width = 22.0F);

/// The text as one item, cut with an ellipsis to `width`. Whether it was cut.
bool draw_elided(const std::string& text, float width);

/// The text in one line: each line break becomes "; ".
std::string in_one_line(const std::string& text);

}  // namespace zeroset::ui
