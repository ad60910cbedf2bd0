#include "ui/model/steering.hpp"

#include "document/framing.hpp"
#include "engine/view/camera.hpp"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace zeroset::ui::steering_test {
namespace {

double half_width(const Camera& camera, double aspect) {
    return ViewFrame(camera).half_height * aspect;
}

TEST(Fitting, KeepsTheSidesOfANarrowPicture) {
    const Camera camera = default_camera(Box::cube(2));
    const double half = ViewFrame(camera).half_height;
    for (const double aspect : {0.25, 0.5, 0.9})
        EXPECT_NEAR(half_width(fitting(camera, aspect), aspect), half, 1e-12) << aspect;
    EXPECT_EQ(fitting(camera, 1.0), camera);
    EXPECT_EQ(fitting(camera, 2.5), camera);
    EXPECT_EQ(fitting(camera, 0.0), camera) << "no picture yet";
}

TEST(Fitting, LeavesTheFieldOfViewWhenTheViewIsSteered) {
    const Camera camera = default_camera(Box::cube(2));
    PointerMotion motion;
    motion.aspect = 0.5;
    motion.pan = {.x = 0.1, .y = 0.0};
    const Camera moved = steer(camera, motion, {});
    EXPECT_EQ(moved.fov_rad, camera.fov_rad);
    // The grabbed place follows the pointer: a tenth of the height of a picture twice as high.
    const double height = 4.0 * ViewFrame(camera).half_height * ViewFrame(camera).look_distance;
    EXPECT_NEAR(glm::distance(moved.eye, camera.eye), 0.1 * height, 1e-9);
}

TEST(Steer, PinchComesNearerByItsFactor) {
    const Camera camera = default_camera(Box::cube(2));
    PointerMotion motion;
    motion.pinch = 2.0;
    const Camera moved = steer(camera, motion, {});
    EXPECT_NEAR(glm::distance(moved.eye, moved.look_at),
                0.5 * glm::distance(camera.eye, camera.look_at), 1e-12);
    motion.pinch = 0.5;
    EXPECT_NEAR(glm::distance(steer(moved, motion, {}).eye, camera.eye), 0.0, 1e-12)
        << "and back by the other";
}

TEST(Scrolled, ZoomsAsAWheelDoes) {
    const PointerMotion motion = scrolled(WheelUse::Zoom, 3.0, 2.0, false, false);
    EXPECT_EQ(motion.wheel, 2.0);
    EXPECT_EQ(motion.orbit, ViewShift());
    EXPECT_EQ(motion.pan, ViewShift());
    EXPECT_EQ(scrolled(WheelUse::Zoom, 0.0, 2.0, true, true).wheel, 2.0);
}

TEST(Scrolled, FollowsTwoFingers) {
    const PointerMotion orbit = scrolled(WheelUse::Orbit, 2.0, 1.0, false, false);
    EXPECT_EQ(orbit.wheel, 0.0);
    EXPECT_EQ(orbit.pan, ViewShift());
    EXPECT_GT(orbit.orbit.x, 0.0);
    EXPECT_LT(orbit.orbit.y, 0.0) << "what scrolls down moves down";
    const PointerMotion pan = scrolled(WheelUse::Pan, 2.0, 1.0, false, false);
    EXPECT_EQ(pan.orbit, ViewShift());
    EXPECT_GT(pan.pan.x, 0.0);
    EXPECT_LT(pan.pan.y, 0.0);
}

TEST(Scrolled, ChangesItsUseWithKeys) {
    EXPECT_EQ(scrolled(WheelUse::Orbit, 0.0, 1.0, true, false).wheel, 1.0);
    EXPECT_EQ(scrolled(WheelUse::Pan, 0.0, 1.0, true, false).wheel, 1.0);
    EXPECT_NE(scrolled(WheelUse::Orbit, 0.0, 1.0, false, true).pan, ViewShift());
    EXPECT_NE(scrolled(WheelUse::Pan, 0.0, 1.0, false, true).orbit, ViewShift());
}

TEST(Scrolled, HasNamesForItsUses) {
    for (const WheelUse use : {WheelUse::Zoom, WheelUse::Orbit, WheelUse::Pan})
        EXPECT_EQ(wheel_use_named(name_of(use)), use);
    EXPECT_EQ(wheel_use_named("spin"), std::nullopt);
}

}  // namespace
}  // namespace zeroset::ui::steering_test
