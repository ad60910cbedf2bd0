#include "engine/trace/render.hpp"
#include "tests/engine/trace/rays.hpp"
#include "tests/support/csg_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

// Pictures of solids made of parts: with kernels shortened down the tiles and without.

namespace zeroset::test {
namespace {

constexpr int image_size = 160;

Framebuffer picture_of(const Scene& scene, const std::string& tracer, const Camera& camera) {
    Framebuffer frame(image_size, image_size);
    render_frame(scene, camera, settings_at(tracer, 22), frame);
    return frame;
}

bool is_hit(float depth) { return std::isfinite(depth); }

/// How many pixels differ in hit or depth. Certified ones must not.
int differences(const Framebuffer& a, const Framebuffer& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.depth.size(); ++i) {
        const bool same = is_hit(a.depth[i]) == is_hit(b.depth[i]) &&
                          (!is_hit(a.depth[i]) || std::abs(a.depth[i] - b.depth[i]) < 1e-5F);
        if (same) continue;
        ++count;
        const bool certain = a.certificate[i] != Certificate::Undecided &&
                             b.certificate[i] != Certificate::Undecided;
        EXPECT_FALSE(certain) << "pixel " << i % image_size << ", " << i / image_size << ": "
                              << a.depth[i] << " and " << b.depth[i];
    }
    return count;
}

class Solid : public testing::TestWithParam<std::string> {};

TEST_P(Solid, IsTheSameWithShortenedKernels) {
    const Camera camera = suite_camera(1.0);
    const Scene scene = scene_of(GetParam(), Box::cube(1));
    Scene whole = scene;
    ASSERT_NE(scene.surfaces[0].shortener, nullptr);
    whole.surfaces[0].shortener = nullptr;
    const Framebuffer expected = picture_of(whole, "beams", camera);
    const CertificateCounts counts = count_certificates(expected);
    EXPECT_GT(counts.certified, 1000U);
    EXPECT_LE(differences(picture_of(scene, "beams", camera), expected), 40);
    EXPECT_LE(differences(picture_of(scene, "k-bisection", camera), expected), 80);
}

std::string spheres(const char* function, int count) {
    return combined(function, visible_spheres(count, suite_camera(1.0).eye));
}

std::string smooth_union(const std::string& a, const std::string& b) {
    return "min(" + a + ", " + b + ") - max(0.1 - |" + a + " - " + b + "|, 0)^2 / 0.4";
}

INSTANTIATE_TEST_SUITE_P(
    All, Solid,
    testing::Values(spheres("min", 24), "max(|x| + |y| + |z| - 1.2, -" + spheres("min", 12) + ")",
                    "max(x^2 + y^2 - 0.6, y^2 + z^2 - 0.6, z^2 + x^2 - 0.5, -x - y - 0.7)",
                    "min(" + spheres("min", 6) + ", max(|z + 0.3| - 0.1, x^2 + y^2 - 0.8)) + 0.05x",
                    "min(" + spheres("min", 5) + ", sqrt(z) - 0.6)",
                    smooth_union("(x^2 + y^2 + z^2 - 0.3)", "(|x| + 2y^2 + 2z^2 - 0.5)")));

/// In float and in double.
TEST(Solid, IsTheSameDeepInTheView) {
    const Camera suite = suite_camera(1.0);
    const auto parts = visible_spheres(24, suite.eye);
    const Scene scene = scene_of(combined("min", parts), Box::cube(1));
    const glm::dvec3 towards = glm::normalize(suite.eye - parts[0].centre);
    Camera camera = suite;
    camera.look_at = parts[0].centre + parts[0].radius * towards;
    camera.eye = camera.look_at + 1e-6 * towards;
    Scene whole = scene;
    whole.surfaces[0].shortener = nullptr;
    const Framebuffer expected = picture_of(whole, "beams", camera);
    EXPECT_EQ(differences(picture_of(scene, "beams", camera), expected), 0);
}

}  // namespace
}  // namespace zeroset::test
