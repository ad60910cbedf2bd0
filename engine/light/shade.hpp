#pragma once

#include "engine/light/lit_tile.hpp"
#include "engine/trace/trace_frame.hpp"
#include "engine/view/camera.hpp"
#include "engine/view/unit_vector.hpp"

namespace zeroset {

/// Shades the hits of a layer on both sides, with their gradients: in the surface's colours, its
/// front where the viewer stands on the side f > 0, its back on the other; or in the reflectances
/// of the layer. Fills in its hit_rows and light. In upward rounding.
void shade(const TraceFrame& frame, const Tile& tile, LitLayer& layer);

/// Towards the light that makes highlights and shadows, which moves with the camera.
UnitVector key_light(const ViewFrame& view);
/// Towards the other light, which softens the shade of the first one.
UnitVector fill_light(const ViewFrame& view);

/// The lightness of a cap at a point, as a part of its surface's colour: less than 1, and less
/// again on the lines of a fine hatch.
float cap_tone(const ViewFrame& view, int height_px, const glm::dvec3& point,
               const glm::dvec3& normal);

}  // namespace zeroset
