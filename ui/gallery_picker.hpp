#pragma once

#include "ui/ui_state.hpp"

namespace zeroset::ui {

/// A drop-down list of `state.gallery`, `width` wide (window coordinates) and as high as the
/// header's buttons; sets `state.surface` to the line that was picked.
void draw_gallery_picker(UiState& state, float width);

}  // namespace zeroset::ui
