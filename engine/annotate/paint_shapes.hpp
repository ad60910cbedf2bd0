#pragma once

#include "engine/annotate/label_font.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/image/framebuffer.hpp"

namespace zeroset {

/// Paints shapes over a picture, whose pixels are the canvas's; nothing but its colours changes,
/// and what is beyond it is left out. Edges are smooth but for those of a MapBar.
void paint_shapes(Framebuffer& picture, const Shapes& shapes, const LabelFont& font);

}  // namespace zeroset
