#pragma once

#include "engine/annotate/card_style.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/view/camera.hpp"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

#include <span>
#include <string>

namespace zeroset {

/// A point of the world that is marked in the picture.
struct MarkedPoint {
    glm::dvec3 at{0.0};
    std::string words;      ///< beside it, in one line
    bool selected = false;  ///< has a ring about it
    bool dot = true;        ///< else it is in the picture itself, and has its words alone
};

/// The canvas over a picture: the picture fills it, whatever its own size is.
struct MarkedPicture {
    const Framebuffer& frame;
    const Camera& camera;  ///< that the picture was taken with
    glm::dvec2 size{0.0};  ///< of the canvas
};

/// Dots with their words, faint behind surfaces; nothing for points beyond the picture.
Shapes marker_shapes(std::span<const MarkedPoint> points, const MarkedPicture& picture,
                     const CardStyle& style);

/// A few words `gap` beside a dot, at the left of it where they would leave the canvas.
Shapes tag_shapes(const std::string& words, const glm::dvec2& dot, double gap,
                  const glm::dvec2& canvas, const CardStyle& style, double opacity = 1.0);

}  // namespace zeroset
