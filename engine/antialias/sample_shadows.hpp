#pragma once

#include "engine/antialias/cover_sample.hpp"
#include "engine/light/lit_tile.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/view/unit_vector.hpp"

#include <cstdint>

namespace zeroset {

/// Whether the light reaches a sample.
enum class SampleShadow : std::uint8_t { Unknown, Lit, Dark };

/// The shadow that a sample has by the pixels around its own: those on its sheet, if there are
/// several and they agree. Unknown, too, where the light is on the sheet's other side. `layer`: the
/// hits of the sample's surface in the tile.
SampleShadow shadow_around(const LitLayer& layer, const Tile& tile, const TileRays& rays,
                           const UnitVector& to_light, const CoverSample& sample);

}  // namespace zeroset
