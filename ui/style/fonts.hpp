#pragma once

#include <cstdint>

struct ImFont;

namespace zeroset::ui {

enum class FontRole : std::uint8_t { Text, Small, Formula, SmallFormula };

/// Rebuilds the font atlas for `content_scale` framebuffer pixels per design unit. The fonts come
/// from ZEROSET_FONT_DIR (set by CMake); ImGui's own font replaces a missing file.
void load_fonts(float content_scale);

/// Returns the font of a role in the current atlas.
ImFont* font(FontRole role);

}  // namespace zeroset::ui
