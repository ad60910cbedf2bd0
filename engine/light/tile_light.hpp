#pragma once

#include "engine/light/encode.hpp"
#include "engine/light/lit_tile.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/trace_frame.hpp"

#include <span>

// Steps from the hits of a tile to its light, beside shade.hpp and encode.hpp. Each has a source of
// its own.

namespace zeroset {

/// Draws lines over the light of a tile's layers: the scene's contour lines and those where
/// surfaces meet; and on surfaces of the technical look silhouettes, creases, and edges of the clip
/// box and the region. A line covers a part of each pixel, as far as the pixel is from it on the
/// surface's tangent plane. Lines get thinner where the surface is seen from aside, contours fade
/// where they are too close to be told apart. `fineness`: pixels of the tile across one of the
/// picture. In upward rounding.
void draw_lines(std::span<const TraceFrame> surfaces, int fineness, const Tile& tile,
                std::span<LitLayer> layers, Counters& counters);

/// Copies the light of a tile into Framebuffer::light and the directions of its hits' gradients
/// into Framebuffer::normal, as far as the canvas keeps them. After encode_tile, of the same hits.
void keep_planes(const Tile& tile, std::span<const TileHits> hits, const LitTile& lit,
                 const Canvas& out);

/// Gives a layer's hits on sections that show values the colours of these (Scene::section_values),
/// unlit, and the surface's colour where f = 0: a line of some 1.5 pixels of the picture.
/// `fineness`: pixels across one of the picture. In upward rounding.
void show_section_values(const TraceFrame& frame, const Tile& tile, int fineness, LitLayer& layer,
                         Counters& counters);

/// Fills in the reflectances of a layer's hits, whose gradients are known, as the scene's coloring
/// says; empties them where it is plain. In upward rounding.
void find_colors(const TraceFrame& frame, const Tile& tile, LitLayer& layer, Counters& counters);

}  // namespace zeroset
