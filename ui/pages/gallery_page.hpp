#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws the gallery while `gallery_page.open`: groups of cards over the picture, or over the whole
/// window if the picture is narrow. A click or Enter sets `surface`; arrows select, letters search,
/// Escape closes.
void draw_gallery_page(UiState& state);

}  // namespace zeroset::ui
