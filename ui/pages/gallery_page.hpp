#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// The gallery, while `gallery_page.open`: cards in groups over the picture, or over all where that
/// is narrow. A click or Enter sets `surface`; arrows select, letters search, Escape closes.
void draw_gallery_page(UiState& state);

}  // namespace zeroset::ui
