#include "engine/trace/patch/patch_way.hpp"

#include "engine/kernel/patch_code.hpp"
#include "engine/trace/patch/patch_tracer.hpp"
#include "engine/trace/patch/patch_tree.hpp"

#include <algorithm>
#include <cstddef>

namespace zeroset {
namespace {

/// The ray as far as it may meet the patch. One that begins on the patch leaves it first.
PatchRay wanted(const TraceFrame& frame, std::uint8_t number, const SceneRay& ray, double to) {
    const double leaves = ray.own == number ? patch_bias(frame) + ray.own_error : 0.0;
    return {.origin = ray.origin,
            .direction = ray.direction,
            .from = ray.from + leaves,
            .to = std::min(ray.to, to)};
}

}  // namespace

bool PatchWay::is_of(const Kernel& surface) const { return is_patch(surface); }

std::shared_ptr<const PreparedSurface> PatchWay::prepare(const Kernel& surface,
                                                         const Uniforms& uniforms) const {
    return patch_tree(surface, uniforms);
}

bool PatchWay::trace_tile(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                          Counters& counters) const {
    trace_tile_patch(frame, tile, hits, counters);
    return true;
}

bool PatchWay::find_first(const TraceFrame& frame, std::uint8_t number,
                          std::span<const SceneRay> rays, std::span<RayHit> hits,
                          Counters& counters) const {
    for (std::size_t i = 0; i < rays.size() && !frame.stopped(); ++i) {
        RayHit& hit = hits[i];
        const PatchHit found =
            find_patch_hit(frame, wanted(frame, number, rays[i], hit.t), false, counters);
        const bool is_unsettled = found.unsettled < std::min(found.s, hit.t);
        if (is_unsettled) hit.certificate = Certificate::Undecided;
        if (!found.is_hit() || !(found.s < hit.t)) continue;
        const bool is_proved = found.is_proved && hit.certificate != Certificate::Undecided;
        hit = {.t = found.s,
               .surface = number,
               .certificate = is_proved ? Certificate::Certified : Certificate::Undecided,
               .error = found.s_radius,
               .gradient = found.normal};
    }
    return true;
}

bool PatchWay::find_blocked(const TraceFrame& frame, std::uint8_t number,
                            std::span<const SceneRay> rays, std::span<std::uint8_t> blocked,
                            Counters& counters) const {
    for (std::size_t i = 0; i < rays.size() && !frame.stopped(); ++i) {
        const SceneRay& ray = rays[i];
        if (blocked[i] != 0 || !(ray.from < ray.to)) continue;
        const PatchHit found =
            find_patch_hit(frame, wanted(frame, number, ray, ray.to), true, counters);
        blocked[i] = found.is_hit() || found.unsettled < ray.to ? 1 : 0;
    }
    return true;
}

bool PatchWay::follow(const TraceFrame& frame, const TileRays& rays, double /*bracket*/,
                      std::span<FollowedRays> blocks, Counters& counters) const {
    follow_patch(frame, rays, blocks, counters);
    return true;
}

std::optional<std::vector<Box>> PatchWay::boxes(const Kernel& surface,
                                                const Uniforms& uniforms) const {
    return patch_tree(surface, uniforms)->boxes();
}

std::optional<RayHit> PatchWay::hit_on(const Kernel& surface, const Uniforms& uniforms,
                                       const SceneRay& ray, double tolerance) const {
    const PatchHit found = find_patch_hit(
        *patch_tree(surface, uniforms),
        {.origin = ray.origin, .direction = ray.direction, .from = ray.from, .to = ray.to},
        tolerance);
    RayHit hit{.gradient = found.normal};
    if (!found.is_hit()) return hit;
    const bool is_proved = found.is_proved && !(found.unsettled < found.s);
    hit.t = found.s;
    hit.surface = 0;
    hit.certificate = is_proved ? Certificate::Certified : Certificate::Undecided;
    hit.error = found.s_radius;
    return hit;
}

}  // namespace zeroset
