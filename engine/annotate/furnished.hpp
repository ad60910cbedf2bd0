#pragma once

#include "engine/annotate/furniture.hpp"
#include "engine/annotate/furniture_colors.hpp"
#include "engine/annotate/label_font.hpp"
#include "engine/image/framebuffer.hpp"

namespace zeroset {

/// The colour of a line or label; what is hidden shines through.
std::uint32_t furniture_color(const FurnitureColors& colors, FurnitureKind kind, bool hidden);

/// Paints furniture over the picture's colours; nothing else of it changes. `em` as in the
/// FurnitureView.
void paint_furniture(Framebuffer& picture, const Furniture& furniture,
                     const FurnitureColors& colors, const LabelFont& font, double em);

/// Size of the labels in a picture of this size.
double label_em(int width_px, int height_px);

}  // namespace zeroset
