#include "pipeline/plans/camera_path.hpp"

#include "engine/view/navigation.hpp"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Tests of the way of a camera: that it goes through its cameras, always sees something, and
// without a jerk.

namespace zeroset::test::camera_path_test {
namespace {

constexpr double fov = 0.7;
const glm::dvec3 up{0, 0, 1};

Camera looking_from(const glm::dvec3& eye) { return {eye, {0, 0, 0}, up, fov}; }

/// Checks that all of 400 places see something, and that the picture moves equally far from each to
/// the next: as the eye and the point looked at move or, if that is more, as it rolls.
void expect_steady(const CameraPath& path, double tolerance) {
    constexpr int steps = 400;
    double least = 1e9;
    double most = 0.0;
    for (int i = 0; i < steps; ++i) {
        const Camera a = path.at(double(i) / steps);
        const Camera b = path.at(double(i + 1) / steps);
        ASSERT_EQ(camera_defect(a), nullptr) << i << ": " << camera_defect(a);
        const double moves = glm::distance(a.eye, b.eye) + glm::distance(a.look_at, b.look_at);
        const double rolls = std::abs(glm::dot(ViewFrame(a).right, ViewFrame(b).up));
        const double way = std::max(moves, rolls * glm::distance(a.eye, a.look_at));
        least = std::min(least, way);
        most = std::max(most, way);
    }
    EXPECT_LE(most - least, tolerance * most);
    EXPECT_GT(least, 0.0);
}

TEST(CameraPath, GoesAroundBetweenOppositeViews) {
    const std::vector<Camera> views{looking_from({0, -6, 0}), looking_from({0, 6, 0})};
    for (const bool closed : {false, true}) {
        const CameraPath path(views, closed);
        expect_steady(path, 0.02);
        for (int i = 0; i <= 20; ++i) {
            const Camera camera = path.at(i / 20.0);
            EXPECT_NEAR(glm::length(camera.eye), 6.0, 1e-9) << "it keeps its distance";
            EXPECT_EQ(camera.up, up);
        }
    }
}

TEST(CameraPath, StaysUprightWhereAllViewsAre) {
    const CameraPath path({looking_from({5, -1, 2}), looking_from({-2, 4, -1}),
                           looking_from({-3, -3, 5}), looking_from({0.1, 0, 8})},
                          true);
    expect_steady(path, 0.05);
    for (int i = 0; i <= 50; ++i)
        EXPECT_EQ(path.at(i / 50.0).up, up);
    EXPECT_LT(glm::distance(path.at(0).eye, path.at(1).eye), 1e-9) << "it is closed";
}

TEST(CameraPath, GoesThroughViewsFromTheAxes) {
    std::vector<Camera> views;
    for (const Side side : {Side::Front, Side::Top, Side::Right, Side::Bottom, Side::Back})
        views.push_back(seen_from(looking_from({0, -6, 0}), outward(side, up), up));
    const CameraPath path(views, false);
    expect_steady(path, 0.05);
    // Each view is on the way, with what is up in it.
    for (const Camera& view : views) {
        double nearest = 1e9;
        for (int i = 0; i <= 4000; ++i) {
            const Camera there = path.at(i / 4000.0);
            nearest = std::min(nearest, glm::distance(there.eye, view.eye) +
                                            glm::distance(ViewFrame(there).up, ViewFrame(view).up));
        }
        EXPECT_LT(nearest, 0.02);
    }
}

TEST(CameraPath, ZoomsAndRollsEvenlyWhereTheEyeStays) {
    Camera zoomed = looking_from({0, -6, 0});
    zoomed.fov_rad = 0.1;
    const CameraPath zoom({looking_from({0, -6, 0}), zoomed}, false);
    EXPECT_NEAR(std::tan(0.5 * zoom.at(0.5).fov_rad), 0.5 * (std::tan(0.5 * fov) + std::tan(0.05)),
                1e-3);
    Camera rolled = looking_from({0, -6, 0});
    rolled.up = {1, 0, 0};
    const CameraPath roll({looking_from({0, -6, 0}), rolled}, false);
    const glm::dvec3 half = roll.at(0.5).up;
    EXPECT_NEAR(half.x, std::sqrt(0.5), 1e-3);
    EXPECT_NEAR(half.z, std::sqrt(0.5), 1e-3);
}

TEST(CameraPath, OfOnePlaceStaysThere) {
    const CameraPath path({looking_from({0, -6, 0}), looking_from({0, -6, 0})}, true);
    for (const double part : {0.0, 0.3, 1.0})
        EXPECT_LT(glm::distance(path.at(part).eye, glm::dvec3(0, -6, 0)), 1e-12);
    EXPECT_TRUE(CameraPath().empty());
    EXPECT_TRUE(CameraPath({}, true).empty());
}

}  // namespace
}  // namespace zeroset::test::camera_path_test
