#pragma once

#include "ui/ui_state.hpp"

#include <string>

namespace zeroset::ui {

/// Opens or closes ImGui's popup `name` as `popup.open` says, which becomes false when a click
/// beside it or another popup has closed it. Whether it is there; then call ImGui::BeginPopup.
bool follow_popup(TypingPopup& popup, const char* name);

/// The popup's field, in the line where it stands; has the keyboard when the popup opens. Whether
/// the text was changed.
bool draw_popup_field(TypingPopup& popup, const char* hint, std::string& text);

/// Whether a field is about to get the keyboard: keys are to be held until then.
bool awaits_keyboard(const UiState& state);

}  // namespace zeroset::ui
