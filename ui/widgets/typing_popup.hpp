#pragma once

#include "ui/model/pages.hpp"
#include "ui/model/wishes.hpp"

#include <functional>
#include <string>

namespace zeroset::ui {

/// Opens or closes ImGui's popup `name` to match `popup.open`, and clears that flag when a click
/// outside or another popup has closed it. Returns true while it is open; then call draw_popup.
bool follow_popup(TypingPopup& popup, const char* name);

/// Draws the popup `name` by `draw` and closes it once `popup.open` is false. The caller sets place
/// and size.
void draw_popup(const TypingPopup& popup, const char* name, const std::function<void()>& draw);

/// The popup's text field, at the current line; it takes the keyboard when the popup appears,
/// with its text selected, and again where nothing else has it.
/// Returns true if the text was changed.
bool draw_popup_field(TypingPopup& popup, const char* hint, std::string& text);

/// True while a field is about to get the keyboard; keys must be held back until it has it.
bool awaits_keyboard(const Wishes& wishes, const Pages& pages);

}  // namespace zeroset::ui
