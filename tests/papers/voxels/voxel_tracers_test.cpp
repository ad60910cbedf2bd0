#include "engine/real/rounding.hpp"
#include "engine/render/render.hpp"
#include "engine/trace/voxels/isosurface.hpp"
#include "engine/volume/spline.hpp"
#include "tests/support/rays.hpp"
#include "tests/support/voxel_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

// The tracers of volumes: closed forms in turned and unevenly spaced grids, in both projections,
// with cuts; what they refuse; what they cost.

namespace zeroset::test::voxel_tracers_test {
namespace {

/// Turned about z and x, with a spacing of its own along each axis.
Geometry turned_place() {
    const double c = std::cos(0.4);
    const double s = std::sin(0.4);
    return {.world_from_index = {{{0.1 * c, -0.07 * s * c, 0.15 * s * s},
                                  {0.1 * s, 0.07 * c * c, -0.15 * c * s},
                                  {0, 0.07 * s, 0.15 * c}}},
            .origin = {-0.6, -0.8, -0.7}};
}

/// x + 2 y - z of the world, and so between the samples.
std::shared_ptr<const Volume> slanted_volume() {
    const Geometry place = turned_place();
    return volume_from({14, 17, 11}, place, [&](double i, double j, double k) {
        const auto point = world_point(place, {i, j, k});
        return point[0] + 2 * point[1] - point[2];
    });
}

std::vector<std::string> voxel_tracers() {
    std::vector<std::string> names;
    for (const Tracer& tracer : tracers()) {
        if (tracer.needs.refuses == no_isosurface) names.emplace_back(tracer.name);
    }
    return names;
}

bool is_inside(const Volume& volume, const glm::dvec3& point, double margin) {
    const IndexMap& map = volume.data().map();
    for (std::size_t i = 0; i < 3; ++i) {
        double index = map.shift[i];
        for (int c = 0; c < 3; ++c)
            index += map.index_from_world[i][static_cast<std::size_t>(c)] * point[c];
        const auto last = static_cast<double>(volume.data().samples().size[i] - 1);
        if (!(index >= -margin && index <= last + margin)) return false;
    }
    return true;
}

class VoxelTracer : public testing::TestWithParam<std::string> {
protected:
    /// How far a hit may be from the plane: of the midpoint, by a voxel.
    [[nodiscard]] static double reach() { return GetParam().starts_with("midpoint") ? 0.25 : 2e-5; }
    static Framebuffer drawn(const Scene& scene, const Camera& camera) {
        Framebuffer frame(61, 47);
        render_frame(scene, camera, settings_at(GetParam(), 14), frame);
        return frame;
    }
    /// Compares with the plane x + 2 y - z = level within the volume and the region.
    static void compare(const Volume& volume, const Scene& scene, const Camera& camera,
                        double level) {
        const Framebuffer frame = drawn(scene, camera);
        const glm::dvec3 normal(1, 2, -1);
        int hits = 0;
        for (int row = 0; row < frame.height; ++row) {
            for (int col = 0; col < frame.width; ++col) {
                SCOPED_TRACE("pixel " + std::to_string(col) + "," + std::to_string(row));
                const Ray ray(camera, scene.clip, col, row, frame, scene.region);
                const std::size_t i = frame.index(col, row);
                const bool hit = std::isfinite(frame.depth[i]);
                EXPECT_FALSE(is_proved(frame.certificate[i]) && hit);
                const double root =
                    (level - glm::dot(normal, ray.eye)) / glm::dot(normal, ray.direction);
                const bool seen = root > ray.t_in + 0.01 && root < ray.t_out - 0.01;
                const bool unseen = root < ray.t_in - 0.3 || root > ray.t_out + 0.3;
                if (seen && is_inside(volume, ray.at(root), -0.01)) {
                    ASSERT_TRUE(hit);
                    EXPECT_NEAR(static_cast<double>(frame.depth[i]), root, reach());
                    ++hits;
                } else if (!GetParam().starts_with("midpoint") &&
                           (unseen || !is_inside(volume, ray.at(root), 2.0))) {
                    EXPECT_FALSE(hit);
                }
            }
        }
        EXPECT_GT(hits, 200);
    }
    static Camera camera_at(Projection projection) {
        Camera camera{{1.5, 2.5, 1.0}, {0.02, 0.01, 0.03}, {0, 0, 1}, 0.7};
        camera.projection = projection;
        return camera;
    }
};

TEST_P(VoxelTracer, FindsAPlaneInATurnedGrid) {
    const auto volume = slanted_volume();
    for (const double level : {0.1, -0.4})
        compare(*volume, scene_of_level(volume, level), camera_at(Projection::Perspective), level);
}

TEST_P(VoxelTracer, FindsItWithParallelRays) {
    const auto volume = slanted_volume();
    compare(*volume, scene_of_level(volume, 0.1), camera_at(Projection::Orthographic), 0.1);
}

TEST_P(VoxelTracer, LeavesOutWhatIsCutAway) {
    const auto volume = slanted_volume();
    Scene scene = scene_of_level(volume, 0.1);
    scene.region.sections.push_back({.normal = {0, 0, 1}, .offset = 0.2, .cap = false});
    scene.region.ball = Ball{.centre = {0, 0, 0}, .radius = 0.7};
    compare(*volume, scene, camera_at(Projection::Perspective), 0.1);
}

TEST_P(VoxelTracer, LeavesWhatItRefusesUndecided) {
    const Scene scene = scene_of("x^2 + y^2 + z^2 = 0.5", Box::cube(1));
    const Framebuffer frame = drawn(scene, default_camera(scene.clip));
    EXPECT_TRUE(std::ranges::all_of(frame.certificate, [](Certificate certificate) {
        return certificate == Certificate::Undecided;
    }));
    EXPECT_TRUE(std::ranges::none_of(frame.depth, [](float t) { return std::isfinite(t); }));
}

TEST_P(VoxelTracer, CostsAreEveryEvaluationSharedOutOverThePixels) {
    const auto volume = slanted_volume();
    const Scene scene = scene_of_level(volume, 0.1);
    TraceSettings settings = settings_at(GetParam(), 14);
    settings.costs = true;
    Framebuffer frame(128, 128);
    const Counters counters =
        render_frame(scene, camera_at(Projection::Perspective), settings, frame);
    const double told = std::accumulate(frame.cost.begin(), frame.cost.end(), 0.0);
    const auto counted = static_cast<double>(counters.range + counters.form + counters.value);
    ASSERT_GT(counted, 0);
    EXPECT_NEAR(told / counted, 1.0, 1e-4);
}

TEST_P(VoxelTracer, LooksForNothingBehindAnotherSurface) {
    const auto volume = slanted_volume();
    Scene scene = scene_of_level(volume, 0.1);
    const Camera camera = camera_at(Projection::Perspective);
    const Framebuffer alone = drawn(scene, camera);
    scene.surfaces.push_back({.kernel = kernel_with_level(level_set(volume, 0.3))});
    const Framebuffer both = drawn(scene, camera);
    int nearer = 0;
    for (std::size_t i = 0; i < both.depth.size(); ++i) {
        EXPECT_LE(both.depth[i], alone.depth[i]);
        nearer += both.depth[i] < alone.depth[i] ? 1 : 0;
    }
    EXPECT_GT(nearer, 300);
}

TEST_P(VoxelTracer, PassesHoles) {
    const auto volume = volume_from({9, 9, 9}, {}, [](double i, double j, double) {
        return i == 4 && j == 4 ? std::numeric_limits<double>::quiet_NaN() : j - 3.5;
    });
    const Scene scene = scene_of_level(volume, 0);
    Camera camera{{4.3, -20, 4.2}, {4.3, 0, 4.2}, {0, 0, 1}, 0.3};
    camera.projection = Projection::Orthographic;
    const Framebuffer frame = drawn(scene, camera);
    EXPECT_TRUE(std::isinf(frame.depth[frame.index(30, 23)]));
    EXPECT_TRUE(std::isfinite(frame.depth[frame.index(45, 23)]));
}

INSTANTIATE_TEST_SUITE_P(All, VoxelTracer, testing::ValuesIn(voxel_tracers()),
                         [](const auto& tracer) { return test_name(tracer.param); });

TEST(VoxelTracers, AreTheFiveMethods) { EXPECT_EQ(voxel_tracers().size(), 5U); }

TEST(Isosurface, RefusesWhatIsNoPlainOne) {
    const auto volume = slanted_volume();
    EXPECT_EQ(no_isosurface(kernel_with_level(level_set(volume, 0.1))), nullptr);
    EXPECT_NE(no_isosurface(interpret(level_set(volume, 0.1))), nullptr);
    const auto edge = volume_from({3, 3, 3}, {}, [](double i, double, double) { return i; },
                                  {.outside = Outside::Edge});
    EXPECT_NE(no_isosurface(kernel_with_level(level_set(edge, 0.1))), nullptr);
    const auto spline = SplineData::of(volume->shared_data(), SplineKind::Interpolating).value();
    const auto curved = Volume::make(spline, VolumeOptions{}, "volume(\"test\", cubic)");
    EXPECT_NE(no_isosurface(kernel_with_level(level_set(curved, 0.1))), nullptr);
}

TEST(LevelOfField, IsWhatIsComparedWithAPlainField) {
    const std::shared_ptr<const Volume> volume = slanted_volume();
    ExprBuilder nodes;
    const NodeId x = nodes.variable(0);
    const NodeId y = nodes.variable(1);
    const NodeId z = nodes.variable(2);
    const NodeId field = nodes.look_up(volume, x, y, z);
    const NodeId a = nodes.variable(variable_w + 1);
    const NodeId twice = nodes.apply(Op::Add, a, a);
    const auto surface_at = [&](NodeId root, double parameter) -> std::optional<Isosurface> {
        const auto is = level_of_field(nodes.finish(root, {"a"}));
        if (!is) return std::nullopt;
        EXPECT_EQ(is->field, volume);
        Scene scene{{}, Box::cube(1), {}};
        scene.uniforms.set(0, 0.0);
        scene.uniforms.set(1, parameter);
        Kernel kernel;
        kernel.facts = std::make_shared<const SurfaceFacts>(SurfaceFacts{
            .field = {.field = is->field, .level = interpret(is->level).in_double.range}});
        const UpwardRounding upward;
        return isosurface(kernel, scene);
    };
    const auto level_at = [&](NodeId root, double parameter) -> std::optional<double> {
        const auto surface = surface_at(root, parameter);
        return surface ? std::optional(surface->level) : std::nullopt;
    };
    EXPECT_EQ(level_at(field, 3), 0.0);
    EXPECT_EQ(level_at(nodes.apply(Op::Subtract, field, twice), 3), 6.0);
    EXPECT_EQ(level_at(nodes.apply(Op::Subtract, twice, field), 3), 6.0);
    EXPECT_EQ(level_at(nodes.apply(Op::Add, field, twice), 3), -6.0);
    EXPECT_EQ(level_at(nodes.apply(Op::Add, twice, field), 3), -6.0);
    EXPECT_EQ(level_at(nodes.apply(Op::Negate, nodes.apply(Op::Subtract, field, a)), 2), 2.0);
    EXPECT_FALSE(level_at(nodes.apply(Op::Subtract, field, x), 3));
    EXPECT_FALSE(level_at(nodes.apply(Op::Multiply, field, a), 3));
    EXPECT_FALSE(level_at(nodes.apply(Op::Subtract, field, field), 3));
    EXPECT_FALSE(level_at(nodes.apply(Op::Max, nodes.apply(Op::Subtract, field, a), x), 3));
    EXPECT_FALSE(level_at(nodes.look_up(volume, y, x, z), 3));
    EXPECT_FALSE(level_at(nodes.look_up(volume, x, y, z, derivative_by(1, 0, 0)), 3));
    EXPECT_FALSE(level_at(twice, 3));
    // Levels that rounding leaves unsure.
    const auto beside = [&](double large) {
        const NodeId number = nodes.constant(large);
        return nodes.apply(Op::Subtract, field,
                           nodes.apply(Op::Subtract, nodes.apply(Op::Add, a, number), number));
    };
    const auto surface = surface_at(beside(1e4), 0.1);
    ASSERT_TRUE(surface);
    EXPECT_GT(surface->level_error, 0.0);
    EXPECT_GE(surface->level_error, std::abs(surface->level - 0.1));
    EXPECT_FALSE(surface_at(beside(1e12), 0.1));
}

}  // namespace
}  // namespace zeroset::test::voxel_tracers_test
