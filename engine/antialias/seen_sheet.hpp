#pragma once

#include "engine/antialias/cover_sample.hpp"
#include "engine/light/lit_tile.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/view/unit_vector.hpp"

#include <glm/glm.hpp>

#include <cstdint>

namespace zeroset {

/// A smooth sheet as the ray of a hit on it sees it.
struct SeenSheet {
    glm::dvec3 gradient;  ///< of f at the hit
    double slope;         ///< of f along the ray, times some number above 0
    /// How far from the hit, along rays, the sheet may be in the pixels around.
    double reach;

    /// `col`, `row`: of the ray, from the tile's first pixel; `distance`: of the hit along it.
    SeenSheet(const TileRays& rays, double col, double row, double distance,
              const glm::dvec3& gradient_of_f);

    /// Whether the sheet shows the eye the same side as what is in that direction.
    [[nodiscard]] bool shows_side_to(const glm::dvec3& direction) const {
        return slope * glm::dot(gradient, direction) < 0.0;
    }
    /// Whether a hit beside this one may be on the sheet, so far from it along rays.
    [[nodiscard]] bool may_be_apart(double depths) const { return depths <= reach; }
};

/// Whether the light reaches a sample.
enum class SampleShadow : std::uint8_t { Unknown, Lit, Dark };

/// The shadow that a sample has by the pixels around its own: those on its sheet, if there are
/// several and they agree. Unknown, too, where the light is on the sheet's other side. `layer`: the
/// hits of the sample's surface in the tile.
SampleShadow shadow_around(const LitLayer& layer, const Tile& tile, const TileRays& rays,
                           const UnitVector& to_light, const CoverSample& sample);

}  // namespace zeroset
