#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/render/render.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>

// The boxes that the tracer asks a kernel about are finite, however far the eye and however large
// or small the clip box. Some are cut to nothing: their lower end is above the upper one.

namespace zeroset::test::boxes_test {
namespace {

/// A kernel that looks at its boxes first.
struct Watched {
    Kernel kernel;
    mutable std::atomic<std::uint64_t> boxes{0};
    mutable std::atomic<std::uint64_t> not_finite{0};
};

void watched_range(const void* code, const RangeBatch* batch) {
    const auto& watched = *static_cast<const Watched*>(code);
    for (std::size_t i = 0; i < batch->size; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const float neg_lo = batch->neg_lo[axis][i];
            const float hi = batch->hi[axis][i];
            if (!std::isfinite(neg_lo) || !std::isfinite(hi)) ++watched.not_finite;
        }
    }
    watched.boxes += batch->size;
    watched.kernel.range(*batch);
}

/// Sides that are not finite, of the boxes of a small picture of a sphere in the clip box.
std::uint64_t boxes_not_finite(double half_edge, double distance) {
    const auto expr = parse("x^2 + y^2 + z^2 - a^2");
    auto watched = std::make_shared<Watched>();
    watched->kernel = interpret(*expr);
    Kernel kernel = watched->kernel;
    kernel.in_float.range = {watched_range, watched};
    const auto edge = static_cast<float>(half_edge);
    Scene scene{{{.kernel = kernel}}, {glm::vec3(-edge), glm::vec3(edge)}, {}};
    scene.uniforms.set(0, 0.0);
    scene.uniforms.set(1, half_edge);
    Camera camera = suite_camera(half_edge);
    camera.eye *= distance;
    Framebuffer frame(24, 16);
    TraceSettings settings;
    settings.tracer = "k-bisection";
    settings.stop.value = 12;
    render_frame(scene, camera, settings, frame);
    EXPECT_GT(watched->boxes, 0U) << half_edge << " " << distance;
    return watched->not_finite;
}

TEST(TracersBoxes, AreFinite) {
    for (const double half_edge : {1e-12, 1e-3, 1.0, 1e6, 1e12}) {
        for (const double distance : {0.1, 0.25, 1.0, 1e4})
            EXPECT_EQ(boxes_not_finite(half_edge, distance), 0U) << half_edge << " " << distance;
    }
}

}  // namespace
}  // namespace zeroset::test::boxes_test
