#pragma once

#include <cstdint>

struct ImFont;

namespace zeroset::ui {

enum class FontRole : std::uint8_t { Text, Small, Formula, SmallFormula };

/// Builds the atlas anew with glyphs for `content_scale` framebuffer pixels per design unit. The
/// fonts come from ZEROSET_FONT_DIR (set by CMake); without them ImGui's own font is used.
void load_fonts(float content_scale);

/// A font of the current atlas.
ImFont* font(FontRole role);

}  // namespace zeroset::ui
