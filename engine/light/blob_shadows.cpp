#include "engine/light/blob_shadows.hpp"

#include "engine/trace/blobs/blob_surface.hpp"
#include "engine/trace/blobs/blob_ways.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t blocks_across = tile_size / ball_block_side;

/// One item for each pixel of a tile.
struct Room {
    std::vector<BlobRays> blocks, ends;
    std::vector<LightWalls::Entry> entries;
    std::vector<LightRay> rest;
};

BlobRay& ray_of(std::vector<BlobRays>& blocks, std::size_t pixel) {
    const auto col = static_cast<int>(pixel % tile_size);
    const auto row = static_cast<int>(pixel / tile_size);
    const auto block = static_cast<std::size_t>(row / ball_block_side) * blocks_across +
                       static_cast<std::size_t>(col / ball_block_side);
    return blocks[block][place_in_block(col % ball_block_side, row % ball_block_side)];
}

void for_each_hit(const TileBits& hits, const auto& take) {
    for (std::size_t pixel = 0; pixel < LightPlaces::pixels; ++pixel) {
        if (is_set(hits, pixel)) take(pixel);
    }
}

/// The ray from where it enters what is visible, to just before the hit.
BlobRay ray_before(const ShadowSearch& search, std::size_t pixel, double spare,
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
LightRay rest_of(const ShadowSearch& search, std::size_t pixel, const BlobRay& ray, double from) {
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
bool look_before_hits(const ShadowSearch& search, double spare, Room& room, Counters& counters) {
    room.ends.assign(room.blocks.size(), {});
    for (std::size_t block = 0; block < room.blocks.size(); ++block) {
        for (std::size_t i = 0; i < ball_block_rays; ++i) {
            const BlobRay& ray = room.blocks[block][i];
            if (ray.way != BlobWay::Root) continue;
            room.ends[block][i] = {.u = ray.u, .v = ray.v, .from = ray.to - spare, .to = ray.to};
        }
    }
    return follow_blob_rays(search.light, search.rays, search.finest, room.ends, counters);
}

/// Whether a ray surely meets another root than its hit, in what is visible.
bool is_dark(const ShadowSearch& search, Room& room, std::size_t pixel) {
    const BlobRay& ray = ray_of(room.blocks, pixel);
    if (ray.way != BlobWay::Root || ray.root < room.entries[pixel].last) return false;
    if (!is_set(search.roots, pixel)) return true;
    const BlobRay& end = ray_of(room.ends, pixel);
    const int shown = is_set(search.places.outside, pixel) ? 1 : -1;
    return end.way == BlobWay::Free && end.side == shown;
}

}  // namespace

bool find_blob_shadows(const ShadowSearch& search, ShadowBits& found, Counters& counters) {
    const bool takes = search.way == ShadowWay::Beams || search.way == ShadowWay::Apart;
    if (!takes || !blob_surface(search.light)) return false;
    thread_local Room room;
    room.blocks.assign(blocks_across * blocks_across, {});
    room.entries.resize(LightPlaces::pixels);
    // Look as near to a hit as single rays do.
    const double spare =
        std::max(search.finest, 4 * (search.places.error + search.rays.depth_error()));
    for_each_hit(search.open, [&](std::size_t pixel) {
        ray_of(room.blocks, pixel) = ray_before(search, pixel, spare, room.entries[pixel]);
    });
    if (!follow_blob_rays(search.light, search.rays, search.finest, room.blocks, counters) ||
        !look_before_hits(search, spare, room, counters))
        return false;
    room.rest.clear();
    for_each_hit(search.open, [&](std::size_t pixel) {
        if (is_dark(search, room, pixel)) {
            found.prove_dark(pixel / tile_size, std::uint64_t{1} << pixel % tile_size);
            return;
        }
        const BlobRay& ray = ray_of(room.blocks, pixel);
        const double free_to = ray.way == BlobWay::Free   ? ray.to
                               : ray.way == BlobWay::Root ? ray.root
                                                          : ray.from;
        const LightRay rest = rest_of(search, pixel, ray, free_to);
        if (rest.from < rest.to) room.rest.push_back(rest);
    });
    found.single_rays += room.rest.size();
    search_rays(search, room.rest, found, counters);
    return true;
}

}  // namespace zeroset
