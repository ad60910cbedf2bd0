#include "engine/render/render.hpp"
#include "tests/support/closed_forms.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace zeroset::test::unproved_octrees_test {
namespace {

/// A tracer may look for the opposite sign a few cells behind the one where it stopped.
constexpr double bracket_cells = 4.0;

/// Octrees whose traversal is not rounded outward: what is not proved is not said, but drawn where
/// the surface is.
class UnprovedTracerTest : public ::testing::TestWithParam<std::string> {};

TEST_P(UnprovedTracerTest, DrawsWhereTheSurfaceIsAndDecidesNothing) {
    for (const Analytic& analytic : analytic_scenes()) {
        const Scene scene = scene_of(analytic.text, analytic.clip);
        Framebuffer frame(41, 31);
        render_frame(scene, analytic.camera, settings_at(GetParam(), 14), frame);
        const double cell = analytic.clip.size() * std::exp2(-14);
        for (int row = 0; row < frame.height; ++row) {
            for (int col = 0; col < frame.width; ++col) {
                SCOPED_TRACE(analytic.name + ", pixel " + std::to_string(col) + "," +
                             std::to_string(row));
                const Ray ray(analytic.camera, analytic.clip, col, row, frame);
                const std::size_t i = frame.index(col, row);
                EXPECT_FALSE(is_proved(frame.certificate[i]));
                const double margin = bracket_cells * cell * ray.stretch() + 3e-6;
                if (!(ray.t_in + margin < ray.t_out)) continue;
                EXPECT_EQ(frame.certificate[i], Certificate::Undecided);
                const double first = analytic.first_root(ray, ray.t_in);
                if (!(first < ray.t_out - margin) || first < ray.t_in + margin) continue;
                EXPECT_LE(static_cast<double>(frame.depth[i]), first + margin);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Octrees, UnprovedTracerTest,
                         ::testing::Values("octree-unrounded", "gargantini"),
                         [](const auto& tracer) { return test_name(tracer.param); });

}  // namespace
}  // namespace zeroset::test::unproved_octrees_test
