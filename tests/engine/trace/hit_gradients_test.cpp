#include "engine/render/render.hpp"
#include "engine/view/pixel_ray.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace zeroset::test::hit_gradients_test {
namespace {

/// f rises through 0 on a sphere, but its gradient vanishes on the circle z = 0, beside which the
/// rays stay undecided, with f's slope at their hits that of z^3 alone.
TEST(HitGradients, AreThoseOfTheSurfaceWhereTheSlopeOfFVanishesOnALine) {
    const Scene scene = scene_of("(x^2 + y^2 + z^2 - 1)^3 = 0.1*z^3", Box::cube(1.5));
    const Camera camera = default_camera(scene.clip);
    const ViewFrame view(camera);
    const double up = 0.5 * std::cbrt(0.1);  // of the sphere's centre
    constexpr int side = 700;
    Framebuffer frame(side, side);
    frame.keep_planes(true);
    render_frame(scene, camera, settings_at("beams", 14), frame);
    int undecided = 0;
    for (int row = 0; row < side; ++row) {
        for (int col = 0; col < side; ++col) {
            const std::size_t at = frame.index(col, row);
            if (!std::isfinite(frame.depth[at])) continue;
            if (frame.certificate[at] == Certificate::Undecided) ++undecided;
            const glm::dvec3 point = view.point(pixel_centre(col, row), {side, side},
                                                static_cast<double>(frame.depth[at]));
            const glm::dvec3 expected = glm::normalize(point - glm::dvec3(0.0, 0.0, up));
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_NEAR(frame.normal[at][static_cast<std::size_t>(axis)], expected[axis], 0.1)
                    << col << ", " << row;
        }
    }
    EXPECT_GT(undecided, 0) << "the picture has none of the pixels that this is about";
}

}  // namespace
}  // namespace zeroset::test::hit_gradients_test
