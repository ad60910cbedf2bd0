#include "engine/trace/single_rays.hpp"

#include "engine/real/rounding.hpp"
#include "engine/render/render.hpp"
#include "papers/octree/octree_tracer.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

// Octrees on rays from anywhere, as mirrors send them on.

namespace zeroset::test::single_rays_test {
namespace {

struct OctreeScene {
    Scene scene;
    Camera camera;
    TraceFrame frame;
    std::shared_ptr<const PreparedSurface> prepared;

    using Prepare = std::shared_ptr<const PreparedSurface>(const TraceFrame&, int);

    OctreeScene(const std::string& text, double d_stop, Prepare* prepare = prepare_octree_tracer)
        : scene(scene_of(text, Box::cube(2))),
          camera(default_camera(scene.clip)),
          frame(trace_frame(scene, scene.surfaces[0], ViewFrame(camera),
                            {.width = 64, .height = 64},
                            {.rule = StopRule::DStop, .value = d_stop})) {
        prepared = prepare(frame, 2);
        frame.prepared = prepared.get();
    }
    void find(std::span<const SingleRay> rays, std::span<SingleRoot> roots,
              Counters& counters) const {
        dynamic_cast<const SingleRootFinder&>(*prepared).find(frame, rays, roots, counters);
    }
};

/// Rays from a ball of radius 0.5 to all sides, and from a corner.
std::vector<SingleRay> rays_in_box() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    std::vector<SingleRay> rays;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 along = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
        const glm::dvec3 from = i % 2 == 0
                                    ? 0.25 * glm::dvec3(any(random), any(random), any(random))
                                    : glm::dvec3(1.9, -1.9, 1.9);
        rays.push_back({.origin = from, .direction = along, .from = 0.0, .to = 8.0});
        SingleRay& ray = rays.back();
        for (int axis = 0; axis < 3; ++axis) {  // to where it leaves the box
            const double wall = along[axis] > 0.0 ? 2.0 : -2.0;
            ray.to = std::min(ray.to, (wall - from[axis]) / along[axis]);
        }
    }
    return rays;
}

/// The first t > 0 at which a ray meets the unit sphere; +inf: none.
double sphere_root(const SingleRay& ray) {
    const double middle = -glm::dot(ray.origin, ray.direction);
    const double square = 1.0 - glm::dot(ray.origin, ray.origin) + middle * middle;
    if (square < 0.0) return infinity;
    const double first = middle - std::sqrt(square);
    const double last = middle + std::sqrt(square);
    return first > 0.0 ? first : last > 0.0 ? last : infinity;
}

TEST(SingleRays, FindTheFirstRootsOfASphere) {
    const UpwardRounding upward;
    for (const double d_stop : {14.0, 19.0}) {
        const std::vector<SingleRay> rays = rays_in_box();
        for (const auto& [prepare, proves] :
             {std::pair{&prepare_octree_tracer, true}, std::pair{&prepare_octree_unrounded, false},
              std::pair{&prepare_gargantini, false}}) {
            const OctreeScene octree("x^2 + y^2 + z^2 = 1", d_stop, prepare);
            std::vector<SingleRoot> roots(rays.size());
            Counters counters;
            octree.find(rays, roots, counters);
            std::size_t found = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const double root = sphere_root(rays[i]);
                EXPECT_EQ(roots[i].is_found, root < rays[i].to) << i;
                EXPECT_EQ(roots[i].unsettled, !proves) << i;
                if (!roots[i].is_found) continue;
                ++found;
                EXPECT_EQ(roots[i].is_proved, proves) << i;
                EXPECT_NEAR(roots[i].from, root, 64.0 * std::exp2(-d_stop)) << i;
                EXPECT_NEAR(roots[i].to, root, 64.0 * std::exp2(-d_stop)) << i;
            }
            EXPECT_GT(found, 100U);
            EXPECT_GT(counters.range, 0U);
        }
    }
}

TEST(SingleRays, SearchOnlyWhereTheyAreAsked) {
    const UpwardRounding upward;
    const OctreeScene octree("x^2 + y^2 + z^2 = 1", 20);
    const glm::dvec3 along(1.0, 0.0, 0.0);
    const std::vector<SingleRay> rays{
        {.origin = {-1.9, 0.1, 0.1}, .direction = along, .from = 0.0, .to = 0.8},
        {.origin = {-1.9, 0.1, 0.1}, .direction = along, .from = 1.5, .to = 3.9},
        {.origin = {-1.9, 0.1, 0.1}, .direction = along, .from = 2.0, .to = 1.0}};
    std::vector<SingleRoot> roots(rays.size());
    Counters counters;
    octree.find(rays, roots, counters);
    EXPECT_FALSE(roots[0].is_found);
    ASSERT_TRUE(roots[1].is_found);
    EXPECT_NEAR(roots[1].from, 1.9 + std::sqrt(0.98), 1e-4);
    EXPECT_FALSE(roots[2].is_found);
}

/// Mirrors show the same by octrees as by the program's own rays.
TEST(SingleRays, MirrorTheSameSurfaces) {
    Scene scene =
        scene_of("min(x^2 + y^2 + z^2 - 1, (x - 1.3)^2 + (y + 0.6)^2 + z^2 - 0.2)", Box::cube(2));
    scene.lighting.look = Look::Metal;
    const Camera camera = default_camera(scene.clip);
    TraceSettings settings = settings_at("beams", 22);
    settings.reflections = 3;
    Framebuffer usual(80, 80);
    const Counters by_forms = render_frame(scene, camera, settings, usual);
    for (const char* const tracer : {"octree", "octree-unrounded", "gargantini"}) {
        settings.tracer = tracer;
        Framebuffer found(80, 80);
        const Counters counters = render_frame(scene, camera, settings, found);
        EXPECT_GT(counters.range, by_forms.range);
        int unlike = 0;
        for (std::size_t i = 0; i < usual.color.size(); ++i) {
            for (const unsigned shift : {0U, 8U, 16U}) {
                const int a = static_cast<int>(usual.color[i] >> shift & 0xffU);
                const int b = static_cast<int>(found.color[i] >> shift & 0xffU);
                if (std::abs(a - b) > 3) {
                    ++unlike;
                    break;
                }
            }
        }
        EXPECT_LT(unlike, 60) << tracer;
    }
}

}  // namespace
}  // namespace zeroset::test::single_rays_test
