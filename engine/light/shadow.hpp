#pragma once

#include "engine/light/lit_tile.hpp"
#include "engine/trace/trace_frame.hpp"
#include "engine/view/unit_vector.hpp"

#include <span>

namespace zeroset {

/// Finds which hits of a tile's layers a light does not reach, by beams from squares of them to the
/// light [Knoll07 5.6, Florez08 5.4.4], or where the tile has places of its own, too far apart for
/// beams, by single rays: nothing that throws a shadow is missed, however thin. The light's rays
/// are parallel. The gradients of the hits are known. What is not found within `limit` is lit.
/// Counts what is not proved, but in parts of pixels. `left_out`: hits that are not asked about. In
/// upward rounding.
ShadowBits find_shadows(std::span<const TraceFrame> surfaces, const UnitVector& to_light,
                        const TimeLimit& limit, const Tile& tile, std::span<const LitLayer> layers,
                        Counters& counters, const TileBits& left_out = {});

/// Whether the hits of small squares of a tile share what is found of the surface before them even
/// where each has a ray of its own: code of theirs, or what its kind knows;
/// of parametric surfaces they share nothing.
bool gains_by_squares(const TraceFrame& surface);

/// Takes the key light from the hits that do not have it.
void darken(const TileBits& dark, std::span<LitLayer> layers);

}  // namespace zeroset
