#include "engine/real/rounding.hpp"
#include "engine/trace/beam/beam_tracer.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"
#include "tests/support/rays.hpp"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>

// The cover of whole pixels near the walls of the clip box, against planes.

namespace zeroset::test::cover_at_walls_test {
namespace {

constexpr int side = 64;
constexpr Tile tile{.col = 0, .row = 0, .cols = side, .rows = side};
constexpr int rays_across = 9;

struct Plane {
    glm::dvec3 normal;
    double offset;

    [[nodiscard]] std::string text() const {
        const auto number = [](double x) { return "(" + std::to_string(x) + ")"; };
        return number(normal.x) + " x + " + number(normal.y) + " y + " + number(normal.z) +
               " z = " + number(offset);
    }
};

/// The text has all digits of these.
constexpr std::array<Plane, 5> planes{{{{0.0, 0.0, 1.0}, 0.25},
                                       {{1.0, 0.5, 0.0}, 0.125},
                                       {{0.5, 0.75, 1.0}, 1.0},
                                       {{-0.25, 1.0, 0.5}, -0.5},
                                       {{1.0, 1.0, 1.0}, 1.75}}};

/// The places where the rays of a pixel meet a plane.
struct Met {
    int inside = 0, outside = 0;  ///< of the clip box
    double first = std::numeric_limits<double>::infinity();
    double last = -std::numeric_limits<double>::infinity();
};

Met met_by(const Plane& plane, const TileRays& rays, int col, int row) {
    Met met;
    for (int i = 0; i < rays_across * rays_across; ++i) {
        const auto beside = [](int k) { return (k + 0.5) / rays_across - 0.5; };
        const double c = col + beside(i % rays_across);
        const double r = row + beside(i / rays_across);
        const glm::dvec3 origin = rays.point(c, r, 0.0);
        const glm::dvec3 along = rays.point(c, r, 1.0) - origin;
        const double s =
            (plane.offset - glm::dot(plane.normal, origin)) / glm::dot(plane.normal, along);
        const glm::dvec3 at = rays.point(c, r, s);
        const Box& clip = rays.clip();
        const bool inside = glm::all(glm::greaterThanEqual(at, clip.lo)) &&
                            glm::all(glm::lessThanEqual(at, clip.hi));
        ++(inside ? met.inside : met.outside);
        met.first = std::min(met.first, s);
        met.last = std::max(met.last, s);
    }
    return met;
}

class CoverAtWalls : public testing::TestWithParam<Projection> {
protected:
    /// Counts pixels that a wall cuts, and those that are left open; expects the others to be
    /// right.
    void check(const Plane& plane) {
        const Scene scene = scene_of(plane.text(), Box::cube(1));
        Camera camera = default_camera(scene.clip);
        camera.projection = GetParam();
        const ViewFrame view(camera);
        const UpwardRounding upward;
        TraceFrame frame =
            trace_frame(scene, scene.surfaces.front(), view, {.width = side, .height = side}, {});
        frame.whole_pixels = true;
        TileHits hits;
        Counters counters;
        trace_tile_beams(frame, tile, hits, counters);
        const TileRays rays(frame, tile);
        for (int row = 0; row < side; ++row) {
            const std::uint64_t mixed = hits.cover.mixed_in_row(row);
            for (int col = 0; col < side; ++col) {
                const Met met = met_by(plane, rays, col, row);
                cut_ += met.inside > 0 && met.outside > 0 ? 1 : 0;
                if ((mixed >> col & 1U) != 0) {
                    ++open_;
                } else {
                    expect_right(
                        hits.cover, static_cast<std::size_t>(row * tile_size + col), met,
                        plane.text() + " at " + std::to_string(col) + ", " + std::to_string(row));
                }
            }
        }
    }

    static void expect_right(const PixelCover& cover, std::size_t at, const Met& met,
                             const std::string& where) {
        EXPECT_TRUE(met.inside == 0 || met.outside == 0) << where;
        const bool covered =
            cover.is_marked() && cover.to[at] < std::numeric_limits<float>::infinity();
        EXPECT_EQ(covered, met.inside > 0) << where;
        if (!covered) return;
        EXPECT_LE(static_cast<double>(cover.from[at]), met.first) << where;
        EXPECT_GE(static_cast<double>(cover.to[at]), met.last) << where;
    }

    int cut_ = 0, open_ = 0;
};

TEST_P(CoverAtWalls, IsRightAndTight) {
    for (const Plane& plane : planes)
        check(plane);
    EXPECT_GT(cut_, 200);
    EXPECT_LT(open_, 3 * cut_);
}

INSTANTIATE_TEST_SUITE_P(Beams, CoverAtWalls,
                         testing::Values(Projection::Perspective, Projection::Orthographic));

}  // namespace
}  // namespace zeroset::test::cover_at_walls_test
