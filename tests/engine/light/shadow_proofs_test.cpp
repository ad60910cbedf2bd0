#include "engine/light/shade.hpp"
#include "engine/view/pixel_ray.hpp"
#include "tests/support/only_target.hpp"
#include "tests/support/rays.hpp"
#include "tests/support/shadow_tile.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

// Shadows on a plane, pixel by pixel, against what throws them in closed form: proved lit and
// proved dark hits are, and only hits beside the shadow's edge are left unproved.

namespace zeroset::test::shadow_proofs_test {
namespace {

/// A point of the plane and the direction to the light, to how far the ray between them is from
/// what throws shadows: below 0 where it is hidden.
using Clearance = std::function<double(const glm::dvec3& from, const glm::dvec3& to_light)>;

struct Case {
    std::string name;
    std::string occluder;
    Clearance clearance;
};

double of_sphere(const glm::dvec3& from, const glm::dvec3& to_light) {
    const double along = -glm::dot(from, to_light);
    return glm::length(from + along * to_light) - 0.5;
}

/// About the z axis, radii 0.6 and 0.2: the least of its function along the ray, by samples.
double of_torus(const glm::dvec3& from, const glm::dvec3& to_light) {
    double least = 1e9;
    for (int i = 0; i <= 2000; ++i) {
        const glm::dvec3 at = from + 4.0 * i / 2000.0 * to_light;
        least = std::min(least, std::hypot(std::hypot(at.x, at.y) - 0.6, at.z) - 0.2);
    }
    return least;
}

/// Balls in a row, as the least of them.
constexpr int balls = 12;
glm::dvec3 ball(int i) { return {0.25 * i - 1.375, 0.1 * (i % 3), 0.2 * (i % 4) - 0.3}; }

std::string union_text() {
    std::string text = "min(";
    for (int i = 0; i < balls; ++i) {
        const glm::dvec3 at = ball(i);
        text += std::string(i > 0 ? ", " : "") + "sqrt((x - (" + std::to_string(at.x) +
                "))^2 + (y - (" + std::to_string(at.y) + "))^2 + (z - (" + std::to_string(at.z) +
                "))^2) - 0.15";
    }
    return text + ")";
}

double of_union(const glm::dvec3& from, const glm::dvec3& to_light) {
    double least = 1e9;
    for (int i = 0; i < balls; ++i) {
        const double along = glm::dot(ball(i) - from, to_light);
        least = std::min(least, glm::length(from + along * to_light - ball(i)) - 0.15);
    }
    return least;
}

/// The half x < 0 of a plate about z = 0, in the clip box.
double of_edge(const glm::dvec3& from, const glm::dvec3& to_light) {
    double least = 1e9;
    for (int i = -100; i <= 100; ++i) {
        const glm::dvec3 at = from + (1e-4 * i - from.z) / to_light.z * to_light;
        least = std::min(least, std::max({at.x, std::abs(at.x) - 2.0, std::abs(at.y) - 2.0}));
    }
    return least;
}

struct Counts {
    int lit = 0, dark = 0, unproved = 0;
    std::uint64_t cells = 0;
};

/// Checks the hits of the plane, the frame's first surface, in a tile.
void check(const Case& of, const std::vector<TraceFrame>& frames, const Tile& tile, bool singly,
           Counts& counts) {
    const ShadowTile found = shadow_tile(frames, tile, singly);
    counts.cells += found.cells;
    const TraceFrame& plane = frames.front();
    const glm::dvec3 to_light = key_light(plane.view);
    for (std::size_t at = 0; at < found.hits[0].depth.size(); ++at) {
        const auto depth = static_cast<double>(found.hits[0].depth[at]);
        if (!std::isfinite(depth)) continue;
        const PixelPoint pixel = pixel_centre(tile.col + static_cast<int>(at % tile_size),
                                              tile.row + static_cast<int>(at / tile_size));
        const double clear =
            of.clearance(pixel_ray(plane.view, pixel, plane.image).at(depth), to_light);
        if (has_bit(found.shadows.unproved, at)) {
            ++counts.unproved;
            EXPECT_LT(std::abs(clear), 4e-3);
            continue;
        }
        if (std::abs(clear) < 1e-4) continue;
        const bool is_dark = has_bit(found.shadows.dark, at);
        EXPECT_EQ(is_dark, clear < 0) << "at " << pixel.col << ", " << pixel.row << ": " << clear;
        ++(is_dark ? counts.dark : counts.lit);
    }
}

Counts check_picture(const Case& of, Projection projection, double d_stop, bool singly) {
    Scene scene = scene_of("z = -1", Box::cube(2));
    scene.surfaces.push_back(scene_of(of.occluder, Box::cube(2)).surfaces[0]);
    Camera camera = default_camera(scene.clip);
    camera.eye = {1.0, -2.0, 6.0};
    camera.projection = projection;
    constexpr int side = 2 * tile_size;
    const StopCriterion stop{.value = d_stop};
    std::vector<TraceFrame> frames;
    for (const Surface& surface : scene.surfaces)
        frames.push_back(trace_frame(scene, surface, ViewFrame(camera), {side, side}, stop));
    Counts counts;
    for (const int row : {0, tile_size}) {
        for (const int col : {0, tile_size})
            check(of, frames, {.col = col, .row = row, .cols = tile_size, .rows = tile_size},
                  singly, counts);
    }
    EXPECT_GT(counts.dark, 100);
    EXPECT_GT(counts.lit, 1000);
    EXPECT_LT(counts.unproved, 30);
    return counts;
}

class ShadowProofs : public testing::TestWithParam<Case> {};

TEST_P(ShadowProofs, HoldAndFailOnlyBesideTheEdge) {
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        for (const double d_stop : {14.0, 24.0}) {
            for (const bool singly : {false, true})
                check_picture(GetParam(), projection, d_stop, singly);
        }
    }
}

/// Both ways promise the same; beams tell of many rays at once.
TEST_P(ShadowProofs, TakeFewerCellsByBeams) {
    const auto cells = [&](bool singly) {
        return check_picture(GetParam(), Projection::Perspective, 14.0, singly).cells;
    };
    const std::uint64_t by_rays = cells(true);
    EXPECT_GT(by_rays, 3000U);
    EXPECT_LT(2 * cells(false), by_rays);
}

TEST_P(ShadowProofs, HoldBySingleRaysWithEachInstructionSet) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        const OnlyTarget only(target);
        for (const double d_stop : {14.0, 24.0})
            check_picture(GetParam(), Projection::Perspective, d_stop, true);
    }
}

INSTANTIATE_TEST_SUITE_P(All, ShadowProofs,
                         testing::Values(Case{"Sphere", "x^2 + y^2 + z^2 = 0.25", of_sphere},
                                         Case{"Torus", "(sqrt(x^2 + y^2) - 0.6)^2 + z^2 = 0.04",
                                              of_torus},
                                         Case{"Union", union_text(), of_union},
                                         Case{"Edge", "max(abs(z) - 0.01, x)", of_edge}),
                         [](const auto& given) { return given.param.name; });

}  // namespace
}  // namespace zeroset::test::shadow_proofs_test
