// Shadows of soft balls by those near each ray, against the same by beams, for the same hits.

#include "engine/light/shadow.hpp"
#include "engine/render/tracers.hpp"
#include "engine/trace/hit_gradients.hpp"
#include "tests/support/blob_scenes.hpp"
#include "tests/support/rays.hpp"
#include "tests/support/shadow_tile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace zeroset::test::followed_shadows_test {
namespace {

constexpr glm::ivec2 size_px(192, 192);

struct Seen {
    int dark = 0, lit = 0, unproved = 0, unproved_by_beams = 0;
};

/// Compares what both prove of a tile's hits.
void add(const TileHits& hits, const ShadowBits& by_balls, const ShadowBits& by_beams, Seen& seen) {
    for (std::size_t pixel = 0; pixel < hits.depth.size(); ++pixel) {
        if (!std::isfinite(hits.depth[pixel])) continue;
        const bool unsure = has_bit(by_balls.unproved, pixel);
        const bool unsure_beams = has_bit(by_beams.unproved, pixel);
        seen.unproved += unsure ? 1 : 0;
        seen.unproved_by_beams += unsure_beams ? 1 : 0;
        if (unsure || unsure_beams) continue;
        const bool dark = has_bit(by_balls.dark, pixel);
        (dark ? seen.dark : seen.lit) += 1;
        ASSERT_EQ(dark, has_bit(by_beams.dark, pixel)) << pixel;
    }
}

/// Compares what both prove of the hits of a view.
void compare(const Scene& balls, const Scene& beams, const Camera& camera, Seen& seen) {
    const UpwardRegisters upward;
    const ViewFrame view(camera);
    const ImageSize image{.width = size_px.x, .height = size_px.y};
    const StopCriterion stop{.rule = StopRule::DStop, .value = 18};
    const std::vector<TraceFrame> of_balls{
        trace_frame(balls, balls.surfaces[0], view, image, stop)};
    const std::vector<TraceFrame> of_beams{
        trace_frame(beams, beams.surfaces[0], view, image, stop)};
    const UnitVector to_light = key_light(view);
    for (int row = 0; row < size_px.y; row += tile_size) {
        for (int col = 0; col < size_px.x; col += tile_size) {
            const Tile tile{.col = col, .row = row, .cols = tile_size, .rows = tile_size};
            std::vector<TileHits> hits(1);
            Counters counters;
            find_tracer("beams")->trace_tile(of_balls[0], tile, hits[0], counters);
            find_gradients(of_balls[0], tile, hits[0], counters);
            LitTile lit;
            lit.begin(hits);
            const ShadowBits by_balls =
                find_shadows(of_balls, to_light, {}, tile, lit.layers(), counters);
            const ShadowBits by_beams =
                find_shadows(of_beams, to_light, {}, tile, lit.layers(), counters);
            ASSERT_NO_FATAL_FAILURE(add(hits[0], by_balls, by_beams, seen)) << col << ", " << row;
        }
    }
}

void expect_alike(const Both& both, const Camera& camera) {
    Seen seen;
    ASSERT_NO_FATAL_FAILURE(compare(both.balls, both.beams, camera, seen));
    EXPECT_GT(seen.dark, 300);
    EXPECT_GT(seen.lit, 1000);
    EXPECT_LE(seen.unproved, seen.unproved_by_beams + (seen.dark + seen.lit) / 200);
}

const Camera usual{{2.5, -2, 1.5}, {0, 0, 0}, {0, 0, 1}, 0.9};

TEST(FollowedShadows, AreThoseOfBeams) {
    for (const BlobKind kind : {BlobKind::Wyvill, BlobKind::Metaball, BlobKind::Blinn}) {
        SCOPED_TRACE(blob_name(kind));
        expect_alike(both_of(kind, {}, 0.8), usual);
        expect_alike(both_of(kind, {.hollow = 0.5}, 0.5),
                     {{-1, 3, 2}, {0, 0, 0}, {0, 0, 1}, 0.9, Projection::Orthographic});
    }
}

TEST(FollowedShadows, AreThoseOfBeamsAmongManySmallBalls) {
    expect_alike(both_of(BlobKind::Wyvill, {.count = 3000, .least = 0.02, .largest = 0.05}, 1),
                 usual);
}

TEST(FollowedShadows, AreThoseOfBeamsFromWithin) {
    expect_alike(both_of(BlobKind::Metaball, {.count = 300}, 1),
                 {{0.1, 0.2, 0.05}, {-0.9, 0.6, 0.35}, {0, 0, 1}, 2.2});
}

/// Parts of balls that are cut away throw no shadow: rays begin within balls there.
TEST(FollowedShadows, AreThoseOfBeamsWhereRegionsAreCut) {
    Both both = both_of(BlobKind::Wyvill, {.count = 300}, 1);
    for (Scene* const scene : {&both.balls, &both.beams}) {
        scene->clip.hi.z -= 0.7;
        scene->region.ball = Ball{.centre = {0.1, 0, 0}, .radius = 1.0};
        scene->region.sections = {make_section({1, -2, 0.5}, 0.5, false)};
    }
    expect_alike(both, usual);
}

/// Hits of another surface.
TEST(FollowedShadows, FallOnOtherSurfaces) {
    const Both both = both_of(BlobKind::Wyvill, {.count = 60}, 1);
    Scene plane = scene_of("z + 1.1", Box::cube(1.2));
    const auto compare_on_plane = [&](const Camera& camera) {
        const UpwardRegisters upward;
        const ViewFrame view(camera);
        const ImageSize image{.width = size_px.x, .height = size_px.y};
        const StopCriterion stop{.rule = StopRule::DStop, .value = 18};
        const Tile tile{.col = 64, .row = 64, .cols = tile_size, .rows = tile_size};
        std::vector<TileHits> hits(2);
        Counters counters;
        const TraceFrame ground = trace_frame(plane, plane.surfaces[0], view, image, stop);
        find_tracer("beams")->trace_tile(ground, tile, hits[1], counters);
        find_gradients(ground, tile, hits[1], counters);
        LitTile lit;
        lit.begin(hits);
        const auto shadows = [&](const Scene& scene) {
            return find_shadows(
                std::vector<TraceFrame>{trace_frame(scene, scene.surfaces[0], view, image, stop),
                                        ground},
                key_light(view), {}, tile, lit.layers(), counters);
        };
        const ShadowBits by_balls = shadows(both.balls);
        const ShadowBits by_beams = shadows(both.beams);
        int dark = 0;
        for (std::size_t pixel = 0; pixel < hits[1].depth.size(); ++pixel) {
            if (has_bit(by_balls.unproved, pixel) || has_bit(by_beams.unproved, pixel)) continue;
            ASSERT_EQ(has_bit(by_balls.dark, pixel), has_bit(by_beams.dark, pixel)) << pixel;
            dark += has_bit(by_balls.dark, pixel) ? 1 : 0;
        }
        EXPECT_GT(dark, 100);
    };
    compare_on_plane({{0.5, -1.5, 2.5}, {0, 0, -1}, {0, 0, 1}, 0.9});
}

}  // namespace
}  // namespace zeroset::test::followed_shadows_test
