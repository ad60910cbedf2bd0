#pragma once

#include "document/document.hpp"
#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws the settings of what surfaces look as if they were made of, mirrors, the background, and
/// lights. Edits the document's `light`.
void draw_light_section(UiState& state);
/// Height of the section's contents in window coordinates.
float light_section_height(const Document& document);

}  // namespace zeroset::ui
