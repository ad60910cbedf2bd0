#include "engine/view/camera.hpp"

#include <gtest/gtest.h>

#include <vector>

// The orthographic camera's rays, and what the mouse does to it.

namespace zeroset::test::parallel_camera_test {
namespace {

constexpr double tolerance = 1e-12;
constexpr int width = 60;
constexpr int height = 40;
constexpr ImageSize image{.width = width, .height = height};

std::vector<Camera> cameras() {
    constexpr auto parallel = Projection::Orthographic;
    return {{{5, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.7, parallel},
            {{1, -1.6, 0.9}, {0.5, 0.25, -2}, {0, 0, 3}, 1.5, parallel},
            {{-3, 2, 8}, {10, 0, 1}, {0.2, 1, -0.3}, 0.1, parallel}};
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double within = tolerance) {
    EXPECT_LE(glm::distance(actual, expected), within)
        << actual.x << ", " << actual.y << ", " << actual.z << " instead of " << expected.x << ", "
        << expected.y << ", " << expected.z;
}

/// Where a point is in the image, in half heights from its centre.
glm::dvec2 place_of(const Camera& camera, const glm::dvec3& point) {
    const ViewFrame view(camera);
    const glm::dvec3 to = point - view.eye;
    return glm::dvec2(glm::dot(to, view.right), glm::dot(to, view.up)) /
           (view.half_height * view.look_distance);
}

TEST(ParallelRays, AllGoForward) {
    for (const Camera& camera : cameras()) {
        const ViewFrame view(camera);
        expect_near(view.direction({.col = 3, .row = 7}, image), view.forward);
        expect_near(view.origin({.col = 0.5 * width, .row = 0.5 * height}, image), camera.eye);
        EXPECT_NEAR(glm::dot(view.origin({.col = 3, .row = 7}, image) - camera.eye, view.forward),
                    0.0, tolerance);
        expect_near(
            view.point({.col = 0.5 * width, .row = 0.5 * height}, image, view.look_distance),
            camera.look_at);
        expect_near(view.point({.col = 3, .row = 7}, image, -2.0),
                    view.origin({.col = 3, .row = 7}, image) - 2.0 * view.forward);
    }
}

/// At the point looked at both projections show the same.
TEST(ParallelRays, MeetThoseOfPerspectiveAtThePointLookedAt) {
    for (Camera camera : cameras()) {
        const ViewFrame parallel(camera);
        camera.projection = Projection::Perspective;
        const ViewFrame perspective(camera);
        for (const glm::dvec2 at : {glm::dvec2(0, 0), {60, 0}, {12, 33}}) {
            const glm::dvec3 along = perspective.direction({.col = at.x, .row = at.y}, image);
            expect_near(parallel.point({.col = at.x, .row = at.y}, image, parallel.look_distance),
                        perspective.eye + perspective.look_distance * along, 1e-9);
        }
        EXPECT_EQ(parallel.pixel_at_look(height), perspective.pixel_at_look(height));
    }
}

TEST(ParallelView, KeepsItsProjectionInAllMotions) {
    for (const Camera& camera : cameras()) {
        EXPECT_EQ(orbit(camera, 0.3, 0.1).projection, Projection::Orthographic);
        EXPECT_EQ(pan(camera, {.x = 0.3, .y = 0.1}).projection, Projection::Orthographic);
        EXPECT_EQ(zoom(camera, 0.9, camera.look_at).projection, Projection::Orthographic);
    }
}

TEST(ParallelView, PansByHeightsWhateverTheDepth) {
    for (const Camera& camera : cameras()) {
        const Camera moved = pan(camera, {.x = 0.25, .y = -0.5});
        const ViewFrame view(camera);
        for (const double depth : {-3.0, 0.0, 7.0}) {
            const glm::dvec2 at = place_of(moved, camera.look_at + depth * view.forward);
            EXPECT_NEAR(at.x, -0.5, 1e-9);
            EXPECT_NEAR(at.y, 1.0, 1e-9);
        }
    }
}

TEST(ParallelView, ZoomsAboutAPointAtAnyDepth) {
    for (const Camera& camera : cameras()) {
        const ViewFrame view(camera);
        for (const double distance : {-4.0, 0.5, 30.0}) {
            const glm::dvec3 point = point_under(camera, {.x = 0.35, .y = -0.2}, distance);
            const glm::dvec2 before = place_of(camera, point);
            EXPECT_NEAR(before.x, 0.7, 1e-9);
            EXPECT_NEAR(before.y, -0.4, 1e-9);
            EXPECT_NEAR(glm::dot(point - camera.eye, view.forward), distance, 1e-9);
            const Camera nearer = zoom(camera, 0.5, point);
            const glm::dvec2 after = place_of(nearer, point);
            EXPECT_NEAR(after.x, 0.7, 1e-9);
            EXPECT_NEAR(after.y, -0.4, 1e-9);
            EXPECT_NEAR(ViewFrame(nearer).pixel_at_look(height), 0.5 * view.pixel_at_look(height),
                        1e-12);
        }
        expect_near(point_under(camera, {}), camera.look_at, 1e-9);
    }
}

}  // namespace
}  // namespace zeroset::test::parallel_camera_test
