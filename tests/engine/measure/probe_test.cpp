#include "engine/measure/probe.hpp"

#include "engine/render/render.hpp"
#include "engine/scene/tolerance.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace zeroset::test::probe_test {
namespace {

constexpr int side = 64;

struct Probed {
    explicit Probed(const std::string& text, const Box& clip = Box::cube(1.2), double d_stop = 14)
        : scene(scene_of(text, clip)), camera(default_camera(clip)), frame(side, side) {
        const TraceSettings settings = settings_at("beams", d_stop);
        render_frame(scene, camera, settings, frame);
        tolerance = *certified_width(clip, settings.stop, Precision::Float);
    }
    [[nodiscard]] std::optional<PointFacts> at(int col, int row) const {
        return probe(
            {frame, camera, {&scene.surfaces.front().kernel, 1}, scene.uniforms, tolerance}, col,
            row);
    }

    Scene scene;
    Camera camera;
    Framebuffer frame;
    double tolerance = 0;
};

/// Far from the sphere most digits of b^2 cancel.
long double wide_dot(const glm::dvec3& a, const glm::dvec3& b) {
    long double sum = 0;
    for (int i = 0; i < 3; ++i)
        sum += static_cast<long double>(a[i]) * static_cast<long double>(b[i]);
    return sum;
}

TEST(Probe, KnowsTheSphereToTheDigitsOfDouble) {
    const Probed sphere("x^2 + y^2 + z^2 = 1");
    int hits = 0;
    for (int row = 0; row < side; row += 5) {
        for (int col = 0; col < side; col += 5) {
            const auto facts = sphere.at(col, row);
            const Ray ray(sphere.camera, sphere.scene.clip, col, row, sphere.frame);
            const long double b = wide_dot(ray.eye, ray.direction);
            const long double a = wide_dot(ray.direction, ray.direction);  // 1 but for rounding
            const long double square = b * b - a * (wide_dot(ray.eye, ray.eye) - 1);
            if (std::abs(square) < 0.02) continue;  // a root close to another has fewer digits
            ASSERT_EQ(facts.has_value(), square > 0) << col << ", " << row;
            if (!facts) continue;
            ++hits;
            const auto t = static_cast<double>((-b - std::sqrt(square)) / a);
            EXPECT_NEAR(facts->distance, t, 1e-14 * t);
            EXPECT_NEAR(glm::length(facts->point), 1.0, 1e-14);
            EXPECT_LT(glm::distance(facts->normal, facts->point), 1e-14);
            EXPECT_LT(std::abs(facts->f), 1e-13);
            EXPECT_TRUE(facts->proved);
            EXPECT_LT(facts->within, 1e-12);
            EXPECT_LE(std::abs(facts->distance - t), facts->within + 5e-14);  // the reference's
            EXPECT_EQ(facts->certificate, Certificate::Certified);
            EXPECT_EQ(facts->surface, 0U);
        }
    }
    EXPECT_GT(hits, 20);
}

TEST(Probe, ProvesNothingWhereThereIsNoChangeOfSign) {
    // A plane that is touched, not crossed: found, drawn, never proved.
    const Probed plane("z^2", Box::cube(1), 10);
    const auto facts = plane.at(32, 32);
    ASSERT_TRUE(facts.has_value());
    EXPECT_EQ(facts->certificate, Certificate::Undecided);
    EXPECT_FALSE(facts->proved);
    EXPECT_LT(std::abs(facts->point.z), facts->within);
    EXPECT_GT(facts->within, 1e-6);
}

TEST(Probe, ProvesNothingThroughAJump) {
    // A picture that claims a surface where the sign changes without a zero.
    Probed jump("y", Box::cube(1), 10);
    jump.scene.surfaces[0].kernel = interpret(*parse("sign(y)"));
    const auto facts = jump.at(32, 32);
    ASSERT_TRUE(facts.has_value());
    EXPECT_FALSE(facts->proved);
    const Probed plane("y", Box::cube(1), 10);
    EXPECT_TRUE(plane.at(32, 32)->proved);
}

TEST(Probe, FindsNothingOutside) {
    const Probed sphere("x^2 + y^2 + z^2 = 1");
    EXPECT_FALSE(sphere.at(0, 0).has_value());
    EXPECT_FALSE(sphere.at(-1, 5).has_value());
    EXPECT_FALSE(sphere.at(5, side).has_value());
}

}  // namespace
}  // namespace zeroset::test::probe_test
