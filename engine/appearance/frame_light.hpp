#pragma once

#include "engine/appearance/shade_hit.hpp"
#include "engine/light/lit_tile.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// Hits of which it is known beforehand whether the key light reaches them.
struct KnownShadows {
    TileBits known{};
    TileBits dark{};  ///< the others are lit
};

/// The light of a frame's surfaces: what all tiles share. Lives while the frame is drawn;
/// read-only.
class FrameLight {
public:
    /// `fineness`: pixels across one of the picture, if this is a finer one of it.
    FrameLight(const Scene& scene, const ViewFrame& view, const TraceSettings& settings,
               int fineness);

    /// Lights the hits of a tile; item i of `hits`: of surface i, with their gradients. What is not
    /// found within `limit` is left out: shadows, mirrors. In upward rounding.
    void light(std::span<const TraceFrame> surfaces, const TimeLimit& limit, const Tile& tile,
               std::span<const TileHits> hits, LitTile& out, Counters& counters,
               const KnownShadows& known = {}) const;

    [[nodiscard]] const TraceSettings& settings() const { return settings_; }
    /// Whether all that is asked of shadows is which hits the key light reaches.
    [[nodiscard]] bool takes_known_shadows() const { return settings_.shadows && !by_rays_; }
    /// Whether smooth surfaces may show edges that are not shadows of the key light.
    [[nodiscard]] bool shows_contrasts() const { return by_rays_; }
    [[nodiscard]] const HitShader& shader() const { return shader_; }
    [[nodiscard]] Look look(std::size_t surface) const { return look_of(scene_, surface); }
    /// How opaque a surface is, 0 to 1.
    [[nodiscard]] float opacity(std::size_t surface) const;
    /// Whether a ray is in the surface's solid behind a place where df/dt is `slope`.
    [[nodiscard]] bool enters_solid(std::size_t surface, double slope) const {
        return slope * solid_signs_[surface] > 0.0;
    }

private:
    void light_hits(std::span<const TraceFrame> surfaces, const TimeLimit& limit, const Tile& tile,
                    LitTile& out, Counters& counters, const KnownShadows& known) const;

    const Scene& scene_;
    TraceSettings settings_;
    int fineness_;
    HitShader shader_;
    bool by_rays_;  ///< more than the standard look without mirrors
    std::vector<int>
        solid_signs_;  ///< of f, inside the surfaces' solids; empty: they swallow nothing
};

}  // namespace zeroset
