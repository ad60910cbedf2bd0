#include "engine/rays/patch_rays.hpp"

#include "engine/trace/patch/patch_rays.hpp"

#include <algorithm>
#include <cstddef>

namespace zeroset {
namespace {

/// The ray as far as it may meet the patch. One that begins on the patch leaves it first.
PatchRay wanted(const TraceFrame& surface, std::uint8_t number, const SceneRay& ray, double to) {
    const double leaves = ray.own == number ? patch_bias(surface) + ray.own_error : 0.0;
    return {.origin = ray.origin,
            .direction = ray.direction,
            .from = ray.from + leaves,
            .to = std::min(ray.to, to)};
}

}  // namespace

void find_on_patch(const TraceFrame& surface, std::uint8_t number, std::span<const SceneRay> rays,
                   std::span<RayHit> hits, Counters& counters) {
    for (std::size_t i = 0; i < rays.size() && !surface.stopped(); ++i) {
        RayHit& hit = hits[i];
        const PatchHit found =
            find_patch_hit(surface, wanted(surface, number, rays[i], hit.t), false, counters);
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
}

void block_by_patch(const TraceFrame& surface, std::uint8_t number, std::span<const SceneRay> rays,
                    std::span<std::uint8_t> blocked, Counters& counters) {
    for (std::size_t i = 0; i < rays.size() && !surface.stopped(); ++i) {
        const SceneRay& ray = rays[i];
        if (blocked[i] != 0 || !(ray.from < ray.to)) continue;
        const PatchHit found =
            find_patch_hit(surface, wanted(surface, number, ray, ray.to), true, counters);
        blocked[i] = found.is_hit() || found.unsettled < ray.to ? 1 : 0;
    }
}

}  // namespace zeroset
