#include "engine/light/shadow_search.hpp"
#include "engine/trace/ways/surface_ways.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace zeroset {
namespace {

/// One item for each pixel of a tile.
struct ShadowScratch {
    std::vector<FollowedRays> blocks, ends;
    std::vector<LightWalls::Entry> entries;
    std::vector<LightRay> rest;
};

void for_each_hit(const TileBits& hits, const auto& take) {
    for (std::size_t pixel = 0; pixel < LightPlaces::pixels; ++pixel) {
        if (is_set(hits, pixel)) take(pixel);
    }
}

/// The ray from where it enters what is visible, to just before the hit.
FollowedRay ray_before(const ShadowSearch& search, std::size_t pixel, double spare,
                       LightWalls::Entry& entry) {
    const LightPlaces& places = search.places;
    const auto u = static_cast<double>(places.u[pixel]);
    const auto v = static_cast<double>(places.v[pixel]);
    entry = search.walls.entry(u, v, places.error, places.error,
                               {.middle = 0.0, .by_u = 0.0, .by_v = 0.0});
    return {
        .u = u, .v = v, .from = entry.first, .to = static_cast<double>(places.s[pixel]) - spare};
}

/// The part of the way from a hit to the light that is left to search, from a depth on.
LightRay rest_of(const ShadowSearch& search, std::size_t pixel, const FollowedRay& ray,
                 double from) {
    const double per_distance = 1.0 / search.rays.distance();
    const auto s = static_cast<double>(search.places.s[pixel]);
    return {.pixel = pixel,
            .u = ray.u * per_distance,
            .v = ray.v * per_distance,
            .s = s,
            .from = std::max(from, ray.from),
            .to = s + search.places.error,
            .left = false,
            .sign = RaySign::Unknown,
            .is_root = is_set(search.roots, pixel)};
}

/// A root that is found may be that of the hit itself, which a ray beside it passes earlier where
/// the light grazes. Looks at the last stretch before the hits: where f has the sign there that
/// hits show the light, it is not.
bool look_before_hits(const ShadowSearch& search, const SurfaceWay& way, double spare,
                      ShadowScratch& scratch, Counters& counters) {
    scratch.ends.assign(scratch.blocks.size(), {});
    for (std::size_t block = 0; block < scratch.blocks.size(); ++block) {
        for (std::size_t i = 0; i < ray_block_rays; ++i) {
            const FollowedRay& ray = scratch.blocks[block][i];
            if (ray.found != RayFinding::Root) continue;
            scratch.ends[block][i] = {.u = ray.u, .v = ray.v, .from = ray.to - spare, .to = ray.to};
        }
    }
    return way.follow(search.light, search.rays, search.finest, scratch.ends, counters);
}

/// Whether a ray surely meets another root than its hit, in what is visible.
bool is_dark(const ShadowSearch& search, ShadowScratch& scratch, std::size_t pixel) {
    const FollowedRay& ray = ray_of(scratch.blocks, pixel);
    if (ray.found != RayFinding::Root || ray.root < scratch.entries[pixel].last) return false;
    if (!is_set(search.roots, pixel)) return true;
    const FollowedRay& end = ray_of(scratch.ends, pixel);
    const int shown = is_set(search.places.outside, pixel) ? 1 : -1;
    return end.found == RayFinding::Free && end.side == shown;
}

/// Searches a surface that is known by its way alone, up to so near before its hits that they are
/// not found again.
void find_by_way_alone(const ShadowSearch& search, const SurfaceWay& way, ShadowScratch& scratch,
                       ShadowBits& found, Counters& counters) {
    const LightPlaces& places = search.places;
    for_each_hit(search.open, [&](std::size_t pixel) {
        ray_of(scratch.blocks, pixel) = {
            .u = static_cast<double>(places.u[pixel]),
            .v = static_cast<double>(places.v[pixel]),
            .from = -std::numeric_limits<double>::infinity(),
            .to = static_cast<double>(places.s[pixel]) - search.bias - places.error};
    });
    const bool is_followed =
        way.follow(search.light, search.rays, search.finest, scratch.blocks, counters);
    for_each_hit(search.open, [&](std::size_t pixel) {
        const RayFinding is = ray_of(scratch.blocks, pixel).found;
        const std::uint64_t hit = std::uint64_t{1} << pixel % tile_size;
        if (is == RayFinding::Root) found.prove_dark(pixel / tile_size, hit);
        if (!is_followed || is == RayFinding::Unknown) found.doubt(pixel / tile_size, hit);
    });
}

/// Searches a level set by its way, and where that leaves something open by single rays through f.
bool find_by_way_and_f(const ShadowSearch& search, const SurfaceWay& way, ShadowScratch& scratch,
                       ShadowBits& found, Counters& counters) {
    scratch.entries.resize(LightPlaces::pixels);
    // Look as near to a hit as single rays do.
    const double spare =
        std::max(search.finest, 4 * (search.places.error + search.rays.depth_error()));
    for_each_hit(search.open, [&](std::size_t pixel) {
        ray_of(scratch.blocks, pixel) = ray_before(search, pixel, spare, scratch.entries[pixel]);
    });
    if (!way.follow(search.light, search.rays, search.finest, scratch.blocks, counters) ||
        !look_before_hits(search, way, spare, scratch, counters))
        return false;
    scratch.rest.clear();
    for_each_hit(search.open, [&](std::size_t pixel) {
        if (is_dark(search, scratch, pixel)) {
            found.prove_dark(pixel / tile_size, std::uint64_t{1} << pixel % tile_size);
            return;
        }
        const FollowedRay& ray = ray_of(scratch.blocks, pixel);
        const double free_to = ray.found == RayFinding::Free   ? ray.to
                               : ray.found == RayFinding::Root ? ray.root
                                                               : ray.from;
        const LightRay rest = rest_of(search, pixel, ray, free_to);
        if (rest.from < rest.to) scratch.rest.push_back(rest);
    });
    search_rays(search, scratch.rest, found, counters);
    return true;
}

}  // namespace

bool find_followed_shadows(const ShadowSearch& search, ShadowBits& found, Counters& counters) {
    const SurfaceWay& way = way_of(search.light.kernel);
    if (!way.follows(search.light)) return false;
    thread_local ShadowScratch scratch;
    scratch.blocks.assign(tile_blocks, {});
    if (!way.is_level_set()) {
        find_by_way_alone(search, way, scratch, found, counters);
        return true;
    }
    return find_by_way_and_f(search, way, scratch, found, counters);
}

}  // namespace zeroset
