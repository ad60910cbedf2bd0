#pragma once

#include "ui/model/ui_state.hpp"

#include <functional>
#include <string>

namespace zeroset::ui {

/// Opens or closes ImGui's popup `name` as `popup.open` says, which becomes false when a click
/// beside it or another popup has closed it. Whether it is there; then call draw_popup.
bool follow_popup(TypingPopup& popup, const char* name);

/// Draws such a popup, which ends when it says so; placed and sized by the caller.
void draw_popup(const TypingPopup& popup, const char* name, const std::function<void()>& draw);

/// The popup's field, in the line where it stands; has the keyboard when the popup opens. Whether
/// the text was changed.
bool draw_popup_field(TypingPopup& popup, const char* hint, std::string& text);

/// Whether a field is about to get the keyboard: keys are to be held until then.
bool awaits_keyboard(const UiState& state);

}  // namespace zeroset::ui
