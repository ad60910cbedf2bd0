#include "engine/render/render.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

// (x^2 + y^2 + z^2)^10 = radius^20 as 66 terms that are added to a large number, which is then
// subtracted: float loses all of f, for large numbers double does, too. A tracer may give up on
// that, but must never be wrong.

namespace zeroset::test::cancellation_test {
namespace {

constexpr int image_size = 33;
constexpr int half_degree = 10;

/// offset + the terms of (x^2 + y^2 + z^2)^10 - (offset + radius^20). The offset is w, so that no
/// rewriting can remove it; `level` is the last sum.
std::string expanded(const std::string& level) {
    std::string text = "w";
    double by_x = 1;  // half_degree over i
    for (int i = 0; i <= half_degree; ++i) {
        double by_y = by_x;  // times half_degree - i over j
        for (int j = 0; i + j <= half_degree; ++j) {
            const int k = half_degree - i - j;
            text += " + " + std::to_string(std::llround(by_y)) + "*x^" + std::to_string(2 * i) +
                    "*y^" + std::to_string(2 * j) + "*z^" + std::to_string(2 * k);
            by_y = by_y * k / (j + 1);
        }
        by_x = by_x * (half_degree - i) / (i + 1);
    }
    return text + " - " + level;
}

struct Counts {
    int hits = 0, certified = 0, undecided = 0;
};

class CancellationTest : public ::testing::TestWithParam<std::string> {
protected:
    /// Counts what the tracer says of the sphere, each ray compared with the known root.
    static Counts drawn(double offset, const std::string& level, double radius) {
        Scene scene = scene_of(expanded(level), Box::cube(1.25));
        scene.uniforms.set(0, offset);
        const Camera camera = default_camera(scene.clip);
        Framebuffer frame(image_size, image_size);
        render_frame(scene, camera, settings_at(GetParam(), 14), frame);
        Counts counts;
        for (int row = 0; row < image_size; ++row) {
            for (int col = 0; col < image_size; ++col) {
                SCOPED_TRACE(std::to_string(col) + "," + std::to_string(row));
                check(Ray(camera, scene.clip, col, row, frame), radius, frame,
                      frame.index(col, row), counts);
            }
        }
        return counts;
    }

private:
    static void check(const Ray& ray, double radius, const Framebuffer& frame, std::size_t pixel,
                      Counts& counts) {
        const double b = glm::dot(ray.eye, ray.direction);
        const double discriminant = b * b - glm::dot(ray.eye, ray.eye) + radius * radius;
        const double root = discriminant < 0 ? infinity : -b - std::sqrt(discriminant);
        const Certificate said = frame.certificate[pixel];
        counts.hits += root < infinity ? 1 : 0;
        counts.certified += said == Certificate::Certified ? 1 : 0;
        counts.undecided += said == Certificate::Undecided ? 1 : 0;
        EXPECT_FALSE(root < infinity && said == Certificate::Miss) << "root at " << root;
        if (said != Certificate::Certified) return;
        const double cell = 2.5 * std::exp2(-14);
        EXPECT_NEAR(static_cast<double>(frame.depth[pixel]), root, 4 * cell * ray.stretch());
    }
};

TEST_P(CancellationTest, IsDecidedInDoubleWhereFloatLosesAll) {
    const Counts counts = drawn(1e6, "1000001", 1.0);
    EXPECT_GT(counts.hits, 150);
    if (GetParam() == "beams") {
        EXPECT_GE(counts.certified, counts.hits * 9 / 10);
        EXPECT_LT(counts.undecided, counts.hits / 10);
    }
}

TEST_P(CancellationTest, IsUndecidedWhereDoubleLosesAll) {
    const Counts counts = drawn(0x1p60, "1152921504606846976", 0.0);
    EXPECT_GT(counts.undecided, image_size * image_size / 4);
    EXPECT_EQ(counts.certified, 0);
}

INSTANTIATE_TEST_SUITE_P(AllTracers, CancellationTest, ::testing::ValuesIn(tracer_names()),
                         [](const auto& tracer) { return test_name(tracer.param); });

}  // namespace
}  // namespace zeroset::test::cancellation_test
