#pragma once

#include "engine/annotate/label_font.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/image/framebuffer.hpp"

#include <glm/glm.hpp>

#include <cstdint>

namespace zeroset {

/// `over` on `under`, colours not multiplied by their alpha: as much of it as its opacity times
/// `coverage` says.
std::uint32_t blended(std::uint32_t under, std::uint32_t over, double coverage);

/// A line of the picture's colours with smooth edges, its ends cut straight: lines that go on where
/// another ends join without a seam. Places in pixels (a pixel's centre is at (i + 0.5, j + 0.5)),
/// `width` in pixels. Parts beyond the picture are left out.
void paint_line(Framebuffer& picture, const glm::dvec2& from, const glm::dvec2& to, double width,
                std::uint32_t color);

/// Paints shapes over a picture, whose pixels are the canvas's; nothing but its colours changes,
/// and what is beyond it is left out. Edges are smooth but for those of a MapBar.
void paint_shapes(Framebuffer& picture, const Shapes& shapes, const LabelFont& font);

}  // namespace zeroset
