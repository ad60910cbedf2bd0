#pragma once

#include <string>

namespace zeroset::ui {

/// The text as ImGui's label: `id` begins with "##", or with "###" where it is all of the control's
/// name, whatever the language of the text.
std::string labelled(const char* text, const char* id);

/// Shows a tooltip while the pointer is over the last item, in lines of at most `width` em.
void draw_tooltip(const std::string& text, float width = 22.0F);

/// Marks the last item while the keyboard is at it. ImGui's own controls do so by themselves, an
/// invisible button does not.
void draw_focus_ring();

/// Draws the text as one item, cut with an ellipsis at `width` (window coordinates). Returns true
/// if it was cut.
bool draw_elided(const std::string& text, float width);

/// The text, with an ellipsis at its end where it is wider than `width` in the current font (window
/// coordinates).
std::string elided(const std::string& text, float width);

/// The text of a list's closed box that fills the next item's width, as `elided`.
std::string elided_in_combo(const std::string& text);

/// Goes on in the line of the last item, `gap` behind it, where `width` is left there; else in the
/// next line, at `column` (as of ImGui::SetCursorPosX).
void flow(float width, float gap, float column);

/// Returns the text in one line: each line break becomes "; ".
std::string in_one_line(const std::string& text);

}  // namespace zeroset::ui
