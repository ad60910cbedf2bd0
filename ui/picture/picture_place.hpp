#pragma once

#include "engine/image/framebuffer.hpp"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_int2.hpp>

#include <cmath>

namespace zeroset::ui {

/// The pixel of a picture, stretched over the picture's area, under a cursor (see
/// PointerMotion::cursor); it may lie outside.
inline glm::ivec2 pixel_under(const Framebuffer& frame, const glm::dvec2& cursor) {
    return {static_cast<int>(std::floor(0.5 * frame.width + cursor.x * frame.height)),
            static_cast<int>(std::floor((0.5 - cursor.y) * frame.height))};
}

}  // namespace zeroset::ui
