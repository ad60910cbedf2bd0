#include "engine/trace/blobs/blob_way.hpp"

#include "engine/blobs/blobs.hpp"
#include "engine/render/render.hpp"
#include "tests/support/alike_frames.hpp"
#include "tests/support/blob_scenes.hpp"
#include "tests/support/rays.hpp"
#include "tests/support/voxel_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

// Surfaces of soft balls by those near each ray, against the same by beams, which know nothing of
// single balls: all kinds, views from all sides, from within, cut, behind others; and against the
// closed form of a ball alone. The exact reference is in tests/oracle/noise_oracle_test.cpp.

namespace zeroset::test::blob_way_test {
namespace {

constexpr std::array kinds{BlobKind::Wyvill, BlobKind::Metaball, BlobKind::Blinn};

/// field(x, y, z) = (w + large) - large, which is w, but not in doubles.
Expr level_beside(const std::shared_ptr<const Field>& field, double large) {
    ExprBuilder nodes;
    const NodeId f = nodes.look_up(field, nodes.variable(0), nodes.variable(1), nodes.variable(2));
    const NodeId moved = nodes.apply(Op::Add, nodes.variable(variable_w), nodes.constant(large));
    const NodeId level = nodes.apply(Op::Subtract, moved, nodes.constant(large));
    return nodes.finish(nodes.apply(Op::Subtract, f, level));
}

Framebuffer drawn(const Scene& scene, const Camera& camera, int side = 70, double d_stop = 16) {
    Framebuffer frame(side, side);
    render_frame(scene, camera, settings_at("beams", d_stop), frame);
    return frame;
}

/// Both draw the same; what one has proved the other does not contradict.
void expect_alike(const Both& both, const Camera& camera, const std::string& what,
                  double scale = 1) {
    SCOPED_TRACE(what);
    const Framebuffer balls = drawn(both.balls, camera);
    const Framebuffer beams = drawn(both.beams, camera);
    Comparison seen;
    ASSERT_NO_FATAL_FAILURE(compare_frames(balls, beams, 4e-4 * scale, seen));
    EXPECT_GT(seen.certified, 300);
    EXPECT_LT(seen.undecided, 5);
    EXPECT_LT(seen.difference / seen.certified, 0.5) << "they are lit alike";
}

const Camera usual{{2.5, -2, 1.5}, {0, 0, 0}, {0, 0, 1}, 0.7};

TEST(BlobWay, AgreeWithBeamsFromAllSides) {
    for (const BlobKind kind : kinds) {
        const Both both = both_of(kind, {}, 0.8);
        for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
            for (const glm::dvec3& eye :
                 {glm::dvec3(4, 0.3, 0.2), {0.4, -3, -0.3}, {0.2, 0.1, 4}, {-2, 2.5, -3}}) {
                const Camera camera{eye, {0, 0, 0}, {0, 0.1, 1}, 0.7, projection};
                expect_alike(both, camera,
                             std::string(blob_name(kind)) + " from x = " + std::to_string(eye.x));
            }
        }
    }
}

TEST(BlobWay, AgreeFromWithin) {
    for (const BlobKind kind : kinds) {
        const Both both = both_of(kind, {.count = 400}, 1);
        for (const glm::dvec3& eye : {glm::dvec3(0.1, 0.2, 0.05), {0.9, 0.1, 0.1}, {0, 0, -0.8}}) {
            const Camera camera{eye, eye + glm::dvec3(-1, 0.4, 0.3), {0, 0, 1}, 2.2};
            expect_alike(both, camera, std::to_string(eye.x));
        }
    }
}

TEST(BlobWay, AgreeAtOtherLevelsAndSizes) {
    expect_alike(both_of(BlobKind::Wyvill, {.hollow = 0.5}, -0.5), usual, "below 0");
    expect_alike(both_of(BlobKind::Blinn, {.count = 30}, 3), usual, "within");
    expect_alike(both_of(BlobKind::Metaball, {.count = 30, .least = 0.01, .largest = 1}, 0.3),
                 usual, "unequal radii");
    const Cloud small{.scale = 1e-3, .middle = {0.1, 0.2, 0.3}};
    const Camera near{small.middle + 1e-3 * usual.eye, small.middle, {0, 0, 1}, 0.7};
    expect_alike(both_of(BlobKind::Wyvill, small, 1), near, "small, away from the origin", 1e-2);
    const Cloud large{.scale = 1e5};
    const Camera far{1e5 * usual.eye, {0, 0, 0}, {0, 0, 1}, 0.7};
    expect_alike(both_of(BlobKind::Wyvill, large, 1), far, "large", 1e5);
}

TEST(BlobWay, AgreeWhereRegionsAreCut) {
    for (const BlobKind kind : kinds) {
        Both both = both_of(kind, {.count = 300}, 1);
        for (Scene* const scene : {&both.balls, &both.beams}) {
            scene->clip.lo.x += 0.4;
            scene->region.ball = Ball{.centre = {0.1, 0, 0}, .radius = 0.9};
            scene->region.sections = {make_section({1, -2, 0.5}, 0.3, false)};
        }
        expect_alike(both, usual, "cut");
    }
}

TEST(BlobWay, AgreeWhereThereAreSeveralSurfaces) {
    Both both = both_of(BlobKind::Wyvill, {}, 1);
    const Both other = both_of(BlobKind::Metaball, {.count = 60}, 0.5);
    both.balls.surfaces.push_back(other.balls.surfaces[0]);
    both.beams.surfaces.push_back(other.beams.surfaces[0]);
    expect_alike(both, usual, "two");
}

// Far more balls than one slab of depth takes.
TEST(BlobWay, AgreeOnManyBallsBehindEachOther) {
    const Both both = both_of(BlobKind::Wyvill, {.count = 4000, .least = 0.01, .largest = 0.03}, 1);
    expect_alike(both, {{8, -5, 4}, {0, 0, 0}, {0, 0, 1}, 0.2}, "many");
}

// Rays of a block leave the box at very different depths, among balls of two slabs.
TEST(BlobWay, AgreeOnManyBallsWhereRaysLeaveTheBox) {
    Both both = both_of(BlobKind::Wyvill, {.count = 100000, .least = 0.004, .largest = 0.007}, 0.7);
    both.balls.clip = both.beams.clip = Box::cube(0.85);
    const auto look = [&](const glm::dvec3& eye, const glm::dvec3& at) {
        const Camera camera{eye, at, {0, 0, 1}, 1.2};
        const Framebuffer balls = drawn(both.balls, camera, 240);
        const Framebuffer beams = drawn(both.beams, camera, 240);
        int missed = 0;
        for (std::size_t i = 0; i < balls.depth.size(); ++i) {
            missed += balls.certificate[i] == Certificate::Miss &&
                              beams.certificate[i] == Certificate::Certified
                          ? 1
                          : 0;
        }
        EXPECT_EQ(missed, 0) << eye.x;
    };
    look({0, 0, 0}, {1, 0.3, 0.1});
    look({0.1, -0.2, -0.5}, {0.8, 0.2, -0.9});
    look({-0.6, -0.6, 0.5}, {0.8, 0.9, 0.9});
}

TEST(BlobWay, AreRoundAlone) {
    for (const BlobKind kind : kinds) {
        const Blob ball{.center = {0.3, -0.2, 0.1}, .radius = 0.7};
        const Expr f = level_of(blobs_field(kind, std::span(&ball, 1), "one"), 1);
        Scene scene{{{.kernel = kernel_with_level(f)}}, Box::cube(2), {}};
        scene.uniforms.set(0, 0.0);
        const Framebuffer frame = drawn(scene, usual, 120, 22);
        const glm::dvec3 middle(0.3, -0.2, 0.1);
        int hits = 0;
        for (int row = 0; row < frame.height; ++row) {
            for (int col = 0; col < frame.width; ++col) {
                const Ray ray(usual, scene.clip, col, row, frame);
                const double along = glm::dot(middle - ray.eye, ray.direction);
                const double aside = glm::length(middle - ray.eye - along * ray.direction);
                const std::size_t i = frame.index(col, row);
                const bool meets = aside < 0.7;
                ASSERT_EQ(frame.certificate[i], meets ? Certificate::Certified : Certificate::Miss);
                if (!meets) continue;
                ++hits;
                const double depth = along - std::sqrt(0.49 - aside * aside);
                ASSERT_NEAR(frame.depth[i], depth, 3e-6);
            }
        }
        EXPECT_GT(hits, 1000);
    }
}

// Two balls that touch in one point, seen along their common tangent plane; and a ray that grazes.
TEST(BlobWay, LeaveTouchesUndecided) {
    const std::vector<Blob> one{{.center = {0, 0, 0}, .radius = 1}};
    const Expr f = level_of(blobs_field(BlobKind::Wyvill, one, "one"), 1);
    Scene scene{{{.kernel = kernel_with_level(f)}}, Box::cube(3), {}};
    scene.uniforms.set(0, 0.0);
    // Parallel rays one unit apart, of which one passes at a distance of exactly 1.
    Camera camera{{0, -10, 0}, {0, 0, 0}, {0, 0, 1}, 0.0, Projection::Orthographic};
    camera.fov_rad = 2 * std::atan(2.5 / 10);
    const Framebuffer frame = drawn(scene, camera, 5);
    EXPECT_EQ(frame.certificate[frame.index(2, 2)], Certificate::Certified);
    EXPECT_NEAR(frame.depth[frame.index(2, 2)], 9, 1e-4);
    EXPECT_EQ(frame.certificate[frame.index(0, 2)], Certificate::Miss);
    EXPECT_NE(frame.certificate[frame.index(3, 2)], Certificate::Certified);
}

// Metaballs are 8/3 - 2 q within q = 4/9: a ball alone is a ball of radius sqrt((8/3 - level) / 2).
TEST(BlobWay, EncloseTheLevelOfTheSurface) {
    constexpr double level = 2.1000004;
    const double square = (8.0 / 3 - level) / 2;
    const Blob ball{.center = {0, 0, 0}, .radius = 1};
    const auto field = blobs_field(BlobKind::Metaball, std::span(&ball, 1), "one");
    // The level is off by 2e-8 in doubles, then by 2e-5.
    for (const double large : {1e9, 1e12}) {
        Scene scene{{{.kernel = kernel_with_level(level_beside(field, large))}}, Box::cube(2), {}};
        scene.uniforms.set(0, level);
        const double off = std::abs((level + large) - large - level);
        ASSERT_GT(off, 1e-17 * large) << "the test looks at nothing";
        const Framebuffer frame = drawn(scene, usual, 60, 30);
        for (int row = 0; row < frame.height; ++row) {
            for (int col = 0; col < frame.width; ++col) {
                const Ray ray(usual, scene.clip, col, row, frame);
                const double along = glm::dot(-ray.eye, ray.direction);
                const double aside = glm::length(-ray.eye - along * ray.direction);
                const double half = square - aside * aside;
                const std::size_t i = frame.index(col, row);
                if (frame.certificate[i] == Certificate::Miss) {
                    ASSERT_LT(half, 1e-12);
                } else if (frame.certificate[i] == Certificate::Certified) {
                    ASSERT_GT(half, -1e-12);
                    ASSERT_NEAR(frame.depth[i], along - std::sqrt(std::max(half, 0.0)), 2e-8);
                }
            }
        }
    }
}

TEST(BlobWay, LeaveOthersToBeams) {
    const Scene scene = both_of(BlobKind::Wyvill, {}, 1).balls;
    const ViewFrame view(usual);
    TileHits hits;
    Counters counters;
    const Tile tile{.col = 0, .row = 0, .cols = tile_size, .rows = tile_size};
    const UpwardRegisters upward;
    const auto takes = [&](const Scene& of) {
        const TraceFrame frame = trace_frame(of, of.surfaces[0], view, {.width = 64, .height = 64},
                                             {.rule = StopRule::DStop, .value = 14});
        hits.clear();
        return BlobWay().trace_tile(frame, tile, hits, counters);
    };
    EXPECT_TRUE(takes(scene));
    EXPECT_FALSE(takes(both_of(BlobKind::Wyvill, {}, 1).beams));
    EXPECT_FALSE(takes(both_of(BlobKind::Wyvill, {}, 0).balls)) << "all of space is at the level";
    const auto beside = [&](double large) {
        const Expr f = level_beside(blobs_field(BlobKind::Wyvill, balls_of({}), "test"), large);
        Scene of{{{.kernel = kernel_with_level(f)}}, scene.clip, {}};
        of.uniforms.set(0, 0.8);
        return of;
    };
    EXPECT_TRUE(takes(beside(1e3)));
    EXPECT_FALSE(takes(beside(1e12))) << "the level is known to 2e-4";
}

}  // namespace
}  // namespace zeroset::test::blob_way_test
