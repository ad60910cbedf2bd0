#include "engine/render/known_frame.hpp"

#include "engine/render/render.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>

// The frame that tracers are measured against is the one they draw.

namespace zeroset::test::known_frame_test {
namespace {

TEST(KnownFrame, DrawsTheSameFrame) {
    Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(2));
    scene.surfaces.push_back(scene_of("z = 0.3 x y", Box::cube(2)).surfaces[0]);
    const Camera camera = default_camera(scene.clip);
    Framebuffer traced(150, 100);
    render_frame(scene, camera, {}, traced);
    const KnownFrame known(scene, camera, {}, traced);
    Framebuffer drawn(150, 100);
    known.draw(drawn);
    EXPECT_EQ(drawn.depth, traced.depth);
    EXPECT_EQ(drawn.certificate, traced.certificate);
    EXPECT_EQ(drawn.surface, traced.surface);
    for (std::size_t at = 0; at < drawn.color.size(); ++at) {
        for (unsigned shift = 0; shift < 32; shift += 8) {
            // The gradients are those of points that differ by some rounding.
            const auto a = static_cast<int>(drawn.color[at] >> shift & 255U);
            const auto b = static_cast<int>(traced.color[at] >> shift & 255U);
            ASSERT_LE(std::abs(a - b), 2) << at;
        }
    }
}

}  // namespace
}  // namespace zeroset::test::known_frame_test
