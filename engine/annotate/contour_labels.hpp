#pragma once

#include "engine/annotate/card_style.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/kernel/uniforms.hpp"
#include "engine/scene/surface_lines.hpp"
#include "engine/view/camera.hpp"

#include <glm/ext/vector_double2.hpp>

namespace zeroset {

/// A picture whose contour lines get labels.
struct ContouredPicture {
    const Framebuffer& frame;  ///< in any resolution
    const Camera& camera;      ///< that it was drawn with
    const SurfaceLines& lines;
    const Uniforms& uniforms;  ///< of the numbers' code
    glm::dvec2 size;           ///< of the canvas, pixels
};

/// The numbers of contour lines, upright, each in the middle of its line where that runs across and
/// others are far enough: none over another one, a line's own ones far apart. Of several numbers
/// each has its coordinate's name before it. None where `lines` want none.
Shapes contour_label_shapes(const ContouredPicture& picture, const CardStyle& style);

}  // namespace zeroset
