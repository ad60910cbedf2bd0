#include "engine/render/render.hpp"
#include "tests/support/csg_scenes.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <thread>
#include <vector>

// Pictures of solids made of parts: with kernels specialized down the tiles and without.

namespace zeroset::test::csg_test {
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

TEST_P(Solid, IsTheSameWithSpecializedKernels) {
    const Camera camera = suite_camera(1.0);
    const Scene scene = scene_of(GetParam(), Box::cube(1));
    Scene whole = scene;
    ASSERT_NE(scene.surfaces[0].kernel.specializer, nullptr);
    whole.surfaces[0].kernel.specializer = nullptr;
    const Framebuffer expected = picture_of(whole, "beams", camera);
    const CertificateCounts counts = count_certificates(expected);
    EXPECT_GT(counts.certified, 1000U);
    EXPECT_LE(differences(picture_of(scene, "beams", camera), expected), 40);
    EXPECT_LE(differences(picture_of(scene, "k-bisection", camera), expected), 80);
    for (const Tracer& tracer : tracers()) {
        if (tracer.name != "csg-by-roots") continue;  // one of papers, in their tests
        EXPECT_LE(differences(picture_of(scene, "csg-by-roots", camera), expected), 80);
    }
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
                    "min(" + spheres("min", 6) + ", max(|x| - 0.2, |y| - 0.3, |z| - 0.9), " +
                        "max(x^2 + z^2 - 0.1, |y| - 0.7, 0.05 - x^2 - z^2))",
                    "min(" + spheres("min", 9) + ", x^2 + y^2 + z^2 - 0.5, " +
                        "x^2 + y^2 + (z - 0.1)^2 - 0.4, x^2 + y^2 + z^2 - 0.6)",
                    smooth_union("(x^2 + y^2 + z^2 - 0.3)", "(|x| + 2y^2 + 2z^2 - 0.5)")));

/// Rays begin among the parts or in some of them.
TEST(Solid, IsTheSameFromAmongItsParts) {
    const Scene scene = scene_of(spheres("min", 40), Box::cube(1));
    Scene whole = scene;
    whole.surfaces[0].kernel.specializer = nullptr;
    for (const glm::dvec3& eye : {glm::dvec3{0.05, -0.1, 0.9}, {0.6, 0.1, 0}, {-0.2, 0.2, -0.4}}) {
        const Camera camera{eye, {0, 0.3, 0}, {0, 0, 1}, 1.4};
        EXPECT_LE(
            differences(picture_of(scene, "beams", camera), picture_of(whole, "beams", camera)),
            40);
    }
}

TEST(Solid, IsTheSameWhereTheBoxCutsIt) {
    const Camera camera = suite_camera(1.0);
    const Scene scene = scene_of(spheres("min", 40), Box::cube(0.6));
    Scene whole = scene;
    whole.surfaces[0].kernel.specializer = nullptr;
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        Camera view = camera;
        view.projection = projection;
        EXPECT_LE(differences(picture_of(scene, "beams", view), picture_of(whole, "beams", view)),
                  40);
    }
}

/// A frame does not use the parameters of the one before it.
TEST(Solid, IsThatOfItsParametersInEachFrame) {
    const std::string text =
        "min((x - w)^2 + y^2 + z^2 - 0.1, x^2 + (y + w)^2 + z^2 - 0.2, " + spheres("min", 6) + ")";
    Scene scene = scene_of(text, Box::cube(1));
    Camera camera = suite_camera(1.0);
    for (const double w : {0.5, -0.5, 0.0}) {
        scene.uniforms.set(0, w);
        Scene fresh = scene_of(text, Box::cube(1));
        fresh.uniforms = scene.uniforms;
        const Framebuffer again = picture_of(scene, "beams", camera);
        const Framebuffer expected = picture_of(fresh, "beams", camera);
        EXPECT_EQ(again.depth, expected.depth);
        EXPECT_EQ(again.certificate, expected.certificate);
        fresh.surfaces[0].kernel.specializer = nullptr;
        EXPECT_LE(differences(again, picture_of(fresh, "beams", camera)), 40);
        camera = orbit(camera, 0.3, 0.1);
    }
}

/// Frames at once of one kernel, each with its own w.
TEST(Solid, IsDrawnByThreadsAtOnce) {
    const Scene scene =
        scene_of("min((x - w)^2 + y^2 + z^2 - 0.1, " + spheres("min", 6) + ")", Box::cube(1));
    const auto at_w = [&](double w) {
        Scene moved = scene;
        moved.uniforms.set(0, w);
        return picture_of(moved, "beams", suite_camera(1.0)).depth;
    };
    const std::array ws{-0.4, 0.0, 0.4};
    std::array<std::vector<float>, ws.size()> expected;
    std::ranges::transform(ws, expected.begin(), at_w);
    std::array<std::vector<float>, ws.size()> drawn;
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < ws.size(); ++i)
            threads.emplace_back([&, i] { drawn[i] = at_w(ws[i]); });
    }
    EXPECT_EQ(drawn, expected);
    EXPECT_NE(drawn[0], drawn[2]);
}

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
    whole.surfaces[0].kernel.specializer = nullptr;
    const Framebuffer expected = picture_of(whole, "beams", camera);
    EXPECT_EQ(differences(picture_of(scene, "beams", camera), expected), 0);
}

}  // namespace
}  // namespace zeroset::test::csg_test
