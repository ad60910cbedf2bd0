#pragma once

#include "engine/light/lit_tile.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/trace_frame.hpp"

#include <span>

namespace zeroset {

/// Draws lines over the light of a tile's layers: the scene's contour lines and those where
/// surfaces meet; and on surfaces of the technical look silhouettes, creases, and edges of the clip
/// box and the region. A line covers a part of each pixel, as far as the pixel is from it on the
/// surface's tangent plane. Lines get thinner where the surface is seen from aside, contours fade
/// where they are too close to be told apart. `fineness`: pixels of the tile across one of the
/// picture. In upward rounding.
void draw_lines(std::span<const TraceFrame> surfaces, int fineness, const Tile& tile,
                std::span<LitLayer> layers, Counters& counters);

}  // namespace zeroset
