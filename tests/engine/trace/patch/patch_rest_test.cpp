#include "engine/real/rounding.hpp"
#include "engine/trace/patch/patch_tile.hpp"
#include "engine/trace/patch/patch_tree.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"
#include "tests/support/patch_scenes.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <limits>
#include <string>

// The parts that are kept for the end of a tile stay few, whatever is not known of a patch.

namespace zeroset::test {
namespace {

/// A room with the rays of the whole tile, on which all is wanted.
PatchTile::Room room_for(const TileRays& rays) {
    PatchTile::Room room;
    for (int i = 0; i < tile_size; ++i) {
        room.u.push_back(rays.u(i));
        room.v.push_back(rays.v(i));
    }
    room.reach.assign(std::size_t{tile_size} * tile_size, std::numeric_limits<double>::infinity());
    return room;
}

TEST(PatchRest, StaysSmallWhereAPatchIsUndefinedEverywhere) {
    const UpwardRounding upward;
    const std::string nowhere = "x / (1 + y + ln(x - x))";
    const Scene scene = patch_scene({nowhere, nowhere, nowhere}, Way::WithoutModels, Box::cube(2));
    const TimeLimit limit{.until = std::chrono::steady_clock::now() + std::chrono::seconds(2)};
    const ViewFrame view(default_camera(scene.clip));
    const Kernel& surface = scene.surfaces.front();
    TraceFrame frame =
        trace_frame(scene, surface, view, {.width = tile_size, .height = tile_size}, {})
            .with(surface, limit);
    const auto tree = patch_tree(surface, scene.uniforms);
    frame.prepared = tree.get();
    const Tile tile{.col = 0, .row = 0, .cols = tile_size, .rows = tile_size};
    const TileRays rays(frame, tile);
    PatchTile::Room room = room_for(rays);
    Counters counters;
    PatchTile(frame, rays, tile_size, tile_size, PatchTile::Wish::FirstHits, counters, room).run();
    EXPECT_GT(room.rest.capacity(), 10'000U);
    EXPECT_LE(room.rest.capacity(), 1'000'000U);
}

}  // namespace
}  // namespace zeroset::test
