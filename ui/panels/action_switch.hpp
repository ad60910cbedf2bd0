#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// A checkbox that runs the action of this name, which must have a state to show.
void draw_action_switch(UiState& state, const char* label, const char* name);

}  // namespace zeroset::ui
