#pragma once

#include "engine/view/camera.hpp"
#include "ui/model/clip_handles.hpp"

#include <glm/ext/vector_double3.hpp>

#include <string>
#include <vector>

namespace zeroset::ui {

/// The part that the handle moves, as a closed line: a face, the ball's outline, where a section
/// cuts the box.
std::vector<glm::dvec3> outline_of(const HandleId& id, const Clipping& clipping,
                                   const ViewFrame& view);

/// The value that it changes: "x = 1.25", "radius 2", "z < 0.3".
std::string handle_text(const Handle& handle, const Clipping& clipping, const ViewFrame& view,
                        int height_px);

}  // namespace zeroset::ui
