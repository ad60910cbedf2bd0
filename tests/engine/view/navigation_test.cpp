#include "engine/view/navigation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

// Views from the axes, the trackball, and ways from one view to another.

namespace zeroset::test::navigation_test {
namespace {

constexpr double tolerance = 1e-12;

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double within = tolerance) {
    EXPECT_LE(glm::distance(actual, expected), within)
        << actual.x << ", " << actual.y << ", " << actual.z << " instead of " << expected.x << ", "
        << expected.y << ", " << expected.z;
}

const Camera usual{{4, -4, 3}, {1, 2, 3}, {0, 0, 1}, 0.7};
const double usual_distance = std::sqrt(9.0 + 36.0);

TEST(SideViews, LookAlongTheAxes) {
    struct Case {
        glm::dvec3 up;
        Side side;
        glm::dvec3 towards_eye, right, up_in_picture;
    };
    const glm::dvec3 x(1, 0, 0);
    const glm::dvec3 y(0, 1, 0);
    const glm::dvec3 z(0, 0, 1);
    const Case cases[] = {
        {z, Side::Front, -y, x, z}, {z, Side::Back, y, -x, z},  {z, Side::Right, x, y, z},
        {z, Side::Left, -x, -y, z}, {z, Side::Top, z, x, y},    {z, Side::Bottom, -z, x, -y},
        {y, Side::Front, z, x, y},  {y, Side::Right, x, -z, y}, {y, Side::Top, y, x, -z},
        {x, Side::Front, -z, y, x}, {x, Side::Right, y, z, x},  {-z, Side::Top, -z, x, -y}};
    for (const Case& c : cases) {
        const Camera camera = seen_from(usual, outward(c.side, c.up), c.up);
        expect_near(camera.eye, usual.look_at + usual_distance * c.towards_eye);
        expect_near(camera.look_at, usual.look_at);
        const ViewFrame frame(camera);
        expect_near(frame.right, c.right);
        expect_near(frame.up, c.up_in_picture);
    }
    const Camera corner = seen_from(usual, outward(Side::Corner, z), z);
    expect_near(corner.eye - corner.look_at, usual_distance / std::sqrt(3.0) * (x - y + z));
}

TEST(OrbitAbout, KeepsWhatIsUpInTheViewFromAbove) {
    const glm::dvec3 up(0, 0, 2);
    for (const Side side : {Side::Top, Side::Bottom}) {
        const Camera pole = seen_from(usual, outward(side, up), up);
        const Camera tilted = orbit_about(pole, up, 0.0, 0.0);
        expect_near(tilted.up, up);
        expect_near(ViewFrame(tilted).right, ViewFrame(pole).right);
        EXPECT_GT(glm::dot(ViewFrame(tilted).up, ViewFrame(pole).up), 0.999);
        expect_near(tilted.eye, pole.eye, 0.011 * usual_distance);
    }
}

TEST(OrbitAbout, TurnsAsOrbitAboutTheGivenAxis) {
    const Camera rolled{usual.eye, usual.look_at, {0.3, 0.1, 1}, usual.fov_rad};
    const Camera turned = orbit_about(rolled, {0, 0, 1}, 0.5, 0.25);
    EXPECT_EQ(turned, orbit(usual, 0.5, 0.25));
}

TEST(RollBall, MovesWhatIsGrabbedAlong) {
    // At the image's rim, 0.5 from its centre, the hyperbola is 0.25 high.
    const Camera camera{{0, -3, 0}, {0, 0, 0}, {0, 0, 1}, 0.7};
    const Camera turned = roll_ball(camera, {0, 0}, {0.5, 0});
    const double sine = 0.5 / std::hypot(0.5, 0.25);
    const double cosine = 0.25 / std::hypot(0.5, 0.25);
    expect_near(turned.eye, {-3 * sine, -3 * cosine, 0});
    expect_near(turned.up, {0, 0, 1});
    const Camera upwards = roll_ball(camera, {0, 0}, {0.0, 0.25});
    expect_near(upwards.eye, {0, -3 * std::cos(std::numbers::pi / 6), -1.5});
    expect_near(upwards.up, {0, -0.5, std::cos(std::numbers::pi / 6)});
}

TEST(RollBall, RollsOutsideTheBall) {
    const Camera camera{{0, -3, 0}, {0, 0, 0}, {0, 0, 1}, 0.7};
    // Far out a circle about the centre is nearly a roll.
    const Camera turned = roll_ball(camera, {40, 0}, {0, 40});
    expect_near(turned.eye, camera.eye, 0.01);
    expect_near(turned.up, {1, 0, 0}, 0.01);
}

TEST(RollBall, GoesThereAndBack) {
    const Camera there = roll_ball(usual, {0.1, -0.2}, {0.3, 0.35});
    EXPECT_NEAR(glm::distance(there.eye, there.look_at), usual_distance, tolerance);
    const Camera back = roll_ball(there, {0.3, 0.35}, {0.1, -0.2});
    expect_near(back.eye, usual.eye);
    EXPECT_EQ(roll_ball(usual, {0.1, 0.2}, {0.1, 0.2}), usual);
}

TEST(Centred, PutsThePointInTheMiddleAsLargeAsItWas) {
    const glm::dvec3 point(0.5, 1, 4);
    const Camera camera = centred(usual, point);
    expect_near(camera.look_at, point);
    const ViewFrame before(usual);
    const ViewFrame after(camera);
    expect_near(after.forward, before.forward);
    EXPECT_NEAR(after.look_distance, glm::dot(point - usual.eye, before.forward), tolerance);
    const glm::dvec3 behind = usual.eye - before.forward;
    EXPECT_EQ(centred(usual, behind), usual);
}

TEST(Centred, KeepsTheScaleOfAParallelView) {
    Camera parallel = usual;
    parallel.projection = Projection::Orthographic;
    const glm::dvec3 point(0.5, 1, 4);
    const Camera camera = centred(parallel, point);
    expect_near(camera.look_at, point);
    EXPECT_NEAR(ViewFrame(camera).look_distance, usual_distance, tolerance);
    EXPECT_EQ(camera.projection, Projection::Orthographic);
}

TEST(Framed, FillsAParallelView) {
    Camera parallel = usual;
    parallel.projection = Projection::Orthographic;
    const Camera camera = framed(parallel, Box::cube(1), 1.0);
    const ViewFrame frame(camera);
    const glm::dvec3 reach = glm::abs(frame.up);
    const double across =
        std::max(reach.x + reach.y + reach.z,
                 std::abs(frame.right.x) + std::abs(frame.right.y) + std::abs(frame.right.z));
    EXPECT_NEAR(frame.half_height * frame.look_distance, 1.04 * across, 1e-9);
}

TEST(Between, LeadsFromOneCameraToTheOther) {
    const Camera to = seen_from({{9, 9, 9}, {0, 1, 0}, {0, 0, 1}, 0.9}, {1, 0, 0}, {0, 0, 1});
    expect_near(between(usual, to, 0.0).eye, usual.eye, 1e-9);
    EXPECT_EQ(between(usual, to, 1.0), to);
    const Camera half = between(usual, to, 0.5);
    expect_near(half.look_at, 0.5 * (usual.look_at + to.look_at));
    EXPECT_NEAR(glm::distance(half.eye, half.look_at),
                std::sqrt(usual_distance * glm::distance(to.eye, to.look_at)), 1e-9);
    const ViewFrame middle(half);
    EXPECT_NEAR(glm::dot(middle.forward, ViewFrame(usual).forward),
                glm::dot(middle.forward, ViewFrame(to).forward), 1e-9);
    EXPECT_NEAR(half.fov_rad, 0.8, tolerance);
}

TEST(Framed, ShowsTheWholeBoxAsLargeAsCanBe) {
    const Box box{{5, 6, 7}, {6, 8, 7.5}};
    for (const double aspect : {0.5, 1.0, 2.0}) {
        const Camera camera = framed(usual, box, aspect);
        const ViewFrame frame(camera);
        expect_near(frame.forward, ViewFrame(usual).forward);
        expect_near(camera.look_at, box.centre());
        double most = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 at(((corner & 1) != 0 ? box.hi : box.lo).x,
                                ((corner & 2) != 0 ? box.hi : box.lo).y,
                                ((corner & 4) != 0 ? box.hi : box.lo).z);
            const glm::dvec3 to = at - camera.eye;
            const double reach = glm::dot(to, frame.forward) * frame.half_height;
            most = std::max({most, std::abs(glm::dot(to, frame.right)) / (aspect * reach),
                             std::abs(glm::dot(to, frame.up)) / reach});
        }
        EXPECT_LT(most, 1.0);
        EXPECT_GT(most, 0.95);
    }
}

}  // namespace
}  // namespace zeroset::test::navigation_test
