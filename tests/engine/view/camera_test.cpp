#include "engine/view/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

// The camera's rays, its first view, and what the mouse does to it.

namespace zeroset::test::camera_test {
namespace {

constexpr double tolerance = 1e-12;
constexpr double quarter_turn = 0.5 * std::numbers::pi;

/// A place in the image: (u, v) in half heights from its centre, and the distance along the view.
struct Projection {
    double u, v, depth;
};

Projection projected(const Camera& camera, const glm::dvec3& point) {
    const ViewFrame view(camera);
    const glm::dvec3 to = point - view.eye;
    const double depth = glm::dot(to, view.forward);
    const double reach = view.half_height * depth;
    return {glm::dot(to, view.right) / reach, glm::dot(to, view.up) / reach, depth};
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double within = tolerance) {
    EXPECT_LE(glm::distance(actual, expected), within)
        << actual.x << ", " << actual.y << ", " << actual.z << " instead of " << expected.x << ", "
        << expected.y << ", " << expected.z;
}

std::vector<Camera> cameras() {
    return {{{5, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.7},
            {{1, -1.6, 0.9}, {0.5, 0.25, -2}, {0, 0, 3}, 1.5},
            {{-3, 2, 8}, {10, 0, 1}, {0.2, 1, -0.3}, 0.1}};
}

TEST(ViewFrame, IsRightHandedAndOrthonormal) {
    for (const Camera& camera : cameras()) {
        const ViewFrame view(camera);
        expect_near(glm::cross(view.right, view.up), -view.forward);
        EXPECT_NEAR(glm::length(view.right), 1.0, tolerance);
        EXPECT_NEAR(glm::length(view.up), 1.0, tolerance);
        EXPECT_NEAR(glm::dot(view.right, view.up), 0.0, tolerance);
        EXPECT_NEAR(glm::dot(view.right, camera.up), 0.0, tolerance);
        EXPECT_GT(glm::dot(view.up, camera.up), 0.0);
        expect_near(view.eye + view.look_distance * view.forward, camera.look_at);
    }
}

TEST(ViewFrame, SendsRaysThroughPixels) {
    const ViewFrame view({{4, 0, 0}, {0, 0, 0}, {0, 0, 1}, quarter_turn});
    expect_near(view.direction({.col = 15, .row = 10}, {.width = 30, .height = 20}), {-1, 0, 0});
    expect_near(view.direction({.col = 15, .row = 0}, {.width = 30, .height = 20}),
                {-1, 0, 1});  // row 0 is the top
    expect_near(view.direction({.col = 15, .row = 20}, {.width = 30, .height = 20}), {-1, 0, -1});
    expect_near(view.direction({.col = 30, .row = 10}, {.width = 30, .height = 20}),
                {-1, 1.5, 0});  // to the right is +y
    EXPECT_NEAR(view.pixel_size(20), 0.1, tolerance);
}

std::vector<Box> boxes() {
    return {Box::cube(2),
            Box::cube(1e-3),
            {{-1, -1, -1}, {1, 1, 5}},
            {{10, -20, 30}, {14, -10, 31}},
            {{-5, -0.1, -0.1}, {5, 0.1, 0.1}},
            {{-3, -3, -0.01}, {3, 3, 0.01}}};
}

TEST(DefaultCamera, ShowsTheWholeBox) {
    for (const Box& box : boxes()) {
        for (const double aspect : {0.4, 1.0, 1.6, 3.0}) {
            const Camera camera = default_camera(box, aspect);
            ASSERT_EQ(camera_defect(camera), nullptr);
            expect_near(camera.look_at, box.centre());
            for (unsigned corner = 0; corner < 8; ++corner) {
                const glm::dvec3 point((corner & 1U) != 0 ? box.hi.x : box.lo.x,
                                       (corner & 2U) != 0 ? box.hi.y : box.lo.y,
                                       (corner & 4U) != 0 ? box.hi.z : box.lo.z);
                const Projection at = projected(camera, point);
                EXPECT_GT(at.depth, 0.0);
                EXPECT_LE(std::abs(at.u), aspect) << "box " << box.lo.x << ", aspect " << aspect;
                EXPECT_LE(std::abs(at.v), 1.0) << "box " << box.lo.x << ", aspect " << aspect;
            }
        }
    }
}

TEST(DefaultCamera, GrowsWithTheBox) {
    const Camera small = default_camera(Box::cube(1));
    const Camera large = default_camera({{7, 7, 7}, {13, 13, 13}});
    expect_near(large.eye - glm::dvec3(10), 3.0 * small.eye);
    expect_near(glm::normalize(small.eye), glm::normalize(default_view_direction));
    EXPECT_DOUBLE_EQ(small.fov_rad, glm::radians(default_fov_deg));
}

TEST(CameraDefect, NamesWhatIsWrong) {
    const Camera good{{5, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.7};
    EXPECT_EQ(camera_defect(good), nullptr);
    Camera bad = good;
    bad.look_at = bad.eye;
    EXPECT_NE(camera_defect(bad), nullptr);
    for (const glm::dvec3 up : {glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(-7, 0, 0)}) {
        bad = good;
        bad.up = up;
        EXPECT_NE(camera_defect(bad), nullptr);
    }
    for (const double fov : {0.0, -1.0, std::numbers::pi, std::nan("")}) {
        bad = good;
        bad.fov_rad = fov;
        EXPECT_NE(camera_defect(bad), nullptr) << fov;
    }
    for (const double number : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        bad = good;
        bad.eye.y = number;
        EXPECT_NE(camera_defect(bad), nullptr) << number;
    }
}

TEST(Orbit, ByNothingKeepsTheEye) {
    for (const Camera& camera : cameras()) {
        const Camera turned = orbit(camera, 0, 0);
        expect_near(turned.eye, camera.eye, 1e-9);
        EXPECT_EQ(turned.look_at, camera.look_at);
        EXPECT_EQ(turned.up, camera.up);
        EXPECT_EQ(turned.fov_rad, camera.fov_rad);
    }
}

TEST(Orbit, YawIsRightHandedAboutUp) {
    const Camera camera{{5, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.7};
    expect_near(orbit(camera, quarter_turn, 0).eye, {0, 5, 0});
    expect_near(orbit(camera, -quarter_turn, 0).eye, {0, -5, 0});
    const Camera above{{3, 0, 4}, {0, 0, 0}, {0, 0, 2}, 0.7};
    expect_near(orbit(above, quarter_turn, 0).eye, {0, 3, 4});
}

TEST(Orbit, PitchIsUpwards) {
    const Camera camera{{5, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.7};
    expect_near(orbit(camera, 0, 0.5).eye, {5 * std::cos(0.5), 0, 5 * std::sin(0.5)});
}

TEST(Orbit, KeepsTheDistanceAndStaysOffThePoles) {
    for (Camera camera : cameras()) {
        const double distance = glm::distance(camera.eye, camera.look_at);
        for (int i = 0; i < 100; ++i) {
            camera = orbit(camera, 0.37, i < 50 ? 0.3 : -0.3);
            ASSERT_EQ(camera_defect(camera), nullptr);
            EXPECT_NEAR(glm::distance(camera.eye, camera.look_at), distance, 1e-9 * distance);
        }
    }
}

TEST(Orbit, GoesBackTheWayItCame) {
    const Camera camera = default_camera(Box::cube(2));
    expect_near(orbit(orbit(camera, 1.1, 0.4), -1.1, -0.4).eye, camera.eye, 1e-9);
}

TEST(Pan, MovesThePictureByHeights) {
    for (const Camera& camera : cameras()) {
        const Camera moved = pan(camera, {.x = 0.25, .y = -0.5});
        const Projection at = projected(moved, camera.look_at);
        EXPECT_NEAR(at.u, -0.5, tolerance);  // (u, v) are in half heights
        EXPECT_NEAR(at.v, 1.0, tolerance);
        expect_near(moved.eye - camera.eye, moved.look_at - camera.look_at, 1e-9);
        expect_near(pan(moved, {.x = -0.25, .y = 0.5}).eye, camera.eye, 1e-9);
    }
}

TEST(Zoom, KeepsThePointUnderTheCursor) {
    for (const Camera& camera : cameras()) {
        const ViewFrame view(camera);
        for (const glm::dvec2 cursor : {glm::dvec2(0, 0), {0.7, -0.3}, {-1.5, 0.9}}) {
            const glm::dvec3 point =
                camera.look_at + view.half_height * view.look_distance *
                                     (cursor.x * view.right + cursor.y * view.up);
            for (const double factor : {0.5, 0.88, 1.3}) {
                const glm::dvec3 fixed =
                    point_under(camera, {.x = 0.5 * cursor.x, .y = 0.5 * cursor.y});
                expect_near(fixed, point, 1e-9);
                const Camera moved = zoom(camera, factor, fixed);
                const Projection at = projected(moved, point);
                EXPECT_NEAR(at.u, cursor.x, 1e-9);
                EXPECT_NEAR(at.v, cursor.y, 1e-9);
                EXPECT_NEAR(at.depth, factor * view.look_distance, 1e-9);
                expect_near(glm::normalize(moved.look_at - moved.eye), view.forward, 1e-9);
            }
        }
    }
}

TEST(Zoom, KeepsAPointAtItsDistanceUnderTheCursor) {
    for (const Camera& camera : cameras()) {
        const ViewFrame view(camera);
        const glm::dvec2 cursor(0.4, -0.8);
        const double distance = 0.7 * view.look_distance;
        const glm::dvec3 point =
            point_under(camera, {.x = 0.5 * cursor.x, .y = 0.5 * cursor.y}, distance);
        EXPECT_NEAR(glm::distance(point, camera.eye), distance, 1e-9);
        const Camera moved = zoom(camera, 0.5, point);
        const Projection at = projected(moved, point);
        EXPECT_NEAR(at.u, cursor.x, 1e-9);
        EXPECT_NEAR(at.v, cursor.y, 1e-9);
        EXPECT_NEAR(glm::distance(point, moved.eye), 0.5 * distance, 1e-9);
    }
}

TEST(Zoom, GoesDownToWhatDoubleTellsApart) {
    const glm::dvec3 point(0.37, -1.21, 0.83);
    Camera camera{{3, -4, 2}, {0.2, 0.1, 0}, {0, 0, 1}, 0.7};
    const glm::dvec3 forward = ViewFrame(camera).forward;
    for (int notch = 0; notch < 1000; ++notch) {
        camera = zoom(camera, 0.88, point);
        ASSERT_EQ(camera_defect(camera), nullptr) << notch;
        const double size = glm::distance(camera.eye, camera.look_at);
        if (size > 1e-9) expect_near(ViewFrame(camera).forward, forward, 1e-6);
    }
    const double size = glm::distance(camera.eye, camera.look_at);
    EXPECT_LT(size, 1e-12);
    EXPECT_GT(size, 1e-14);
    EXPECT_LT(glm::distance(camera.eye, point), 1e-12);
    const Camera back = zoom(camera, 2.0, point);
    EXPECT_GT(glm::distance(back.eye, back.look_at), 1.5 * size) << "there is a way back";
}

TEST(Box, KnowsItsMeasures) {
    const Box box{{-1, 2, 0}, {2, 4, 6}};
    expect_near(box.centre(), {0.5, 3, 3});
    EXPECT_EQ(box.size(), 6.0);
}

}  // namespace
}  // namespace zeroset::test::camera_test
