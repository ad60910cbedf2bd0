#include "engine/trace/patch/patch_way.hpp"

#include "engine/kernel/patch_code.hpp"
#include "engine/trace/patch/patch_rays.hpp"
#include "engine/trace/patch/patch_tracer.hpp"
#include "engine/trace/patch/patch_tree.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>

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

constexpr auto blocks_across = static_cast<std::size_t>(tile_size / ray_block_side);

/// The rays of blocks, one item for each pixel of a tile.
struct PatchScratch {
    std::vector<double> u, v, to;
    std::vector<PatchBlock> blocks;
};

/// Calls `take` with the number of each pixel of a tile and its ray in the blocks.
void for_each_ray(std::span<FollowedRays> blocks, const auto& take) {
    for (int row = 0; row < tile_size; ++row) {
        for (int col = 0; col < tile_size; ++col) {
            const auto block = static_cast<std::size_t>(row / ray_block_side) * blocks_across +
                               static_cast<std::size_t>(col / ray_block_side);
            take(pixel_index(col, row),
                 blocks[block][place_in_block(col % ray_block_side, row % ray_block_side)]);
        }
    }
}

RayFinding finding_of(PatchBlock block) {
    switch (block) {
        case PatchBlock::None: return RayFinding::Free;
        case PatchBlock::Proved: return RayFinding::Root;
        case PatchBlock::Unknown: return RayFinding::Unknown;
    }
    return RayFinding::Unknown;
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
    assert(blocks.size() == blocks_across * blocks_across);
    thread_local PatchScratch scratch;
    scratch.u.resize(tile_pixels);
    scratch.v.resize(tile_pixels);
    scratch.to.resize(tile_pixels);
    scratch.blocks.assign(tile_pixels, PatchBlock::None);
    const double per_distance = 1.0 / rays.distance();
    for_each_ray(blocks, [&](std::size_t pixel, const FollowedRay& ray) {
        const bool is_wanted = ray.from < ray.to;
        scratch.u[pixel] = is_wanted ? ray.u * per_distance : 0.0;
        scratch.v[pixel] = is_wanted ? ray.v * per_distance : 0.0;
        scratch.to[pixel] = is_wanted ? ray.to : -std::numeric_limits<double>::infinity();
    });
    find_patch_blocks(frame, rays, scratch.u, scratch.v, scratch.to, scratch.blocks, counters);
    for_each_ray(blocks, [&](std::size_t pixel, FollowedRay& ray) {
        ray.found = finding_of(scratch.blocks[pixel]);
    });
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
