#pragma once

#include "engine/view/camera.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/window/texture.hpp"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

#include <optional>

namespace zeroset::ui {

/// Zooms towards the pointer, orbits or pans as the wheel was turned in this frame, or as two
/// fingers pinched. For whatever is over the picture and has no use for the wheel, while the
/// pointer is over it.
void follow_wheel(UiState& state);

/// The point of the surface that the picture shows under the cursor (see PointerMotion), if any.
std::optional<glm::dvec3> surface_under(const ShownPicture& shown, const ViewPoint& cursor);

/// Fills the window between the bars with the picture, stretched if it is coarse; the pointer
/// changes the view. Draw it before the panels. Sets `state.input.viewport_px`.
void draw_viewport(UiState& state, const Texture& picture);

/// Right after the item that the picture is: sets `state.input.pointer`, and `state.wishes.click`
/// where a press was no drag. `cursor` as in PointerMotion.
void follow_picture_pointer(UiState& state, const ViewPoint& cursor);

}  // namespace zeroset::ui
