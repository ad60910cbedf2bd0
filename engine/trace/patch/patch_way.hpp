#pragma once

#include "engine/trace/surface_way.hpp"

namespace zeroset {

/// Parametric surfaces, curves and points (PatchCode): all by their trees of boxes (PatchTree).
class PatchWay final : public SurfaceWay {
public:
    [[nodiscard]] bool is_of(const Kernel& surface) const override;
    [[nodiscard]] bool is_level_set() const override { return false; }
    [[nodiscard]] std::shared_ptr<const PreparedSurface> prepare(
        const Kernel& surface, const Uniforms& uniforms) const override;
    bool trace_tile(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                    Counters& counters) const override;
    bool find_first(const TraceFrame& frame, std::uint8_t number, std::span<const SceneRay> rays,
                    std::span<RayHit> hits, Counters& counters) const override;
    bool find_blocked(const TraceFrame& frame, std::uint8_t number, std::span<const SceneRay> rays,
                      std::span<std::uint8_t> blocked, Counters& counters) const override;
    [[nodiscard]] bool follows(const TraceFrame&) const override { return true; }
    bool follow(const TraceFrame& frame, const TileRays& rays, double bracket,
                std::span<FollowedRays> blocks, Counters& counters) const override;
    [[nodiscard]] std::optional<std::vector<Box>> boxes(const Kernel& surface,
                                                        const Uniforms& uniforms) const override;
    [[nodiscard]] std::optional<RayHit> hit_on(const Kernel& surface, const Uniforms& uniforms,
                                               const SceneRay& ray,
                                               double tolerance) const override;
};

}  // namespace zeroset
