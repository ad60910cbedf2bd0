#include "engine/trace/voxels/voxel_way.hpp"

#include "engine/render/render.hpp"
#include "engine/volume/spline.hpp"
#include "tests/support/alike_frames.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/rays.hpp"
#include "tests/support/voxel_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <vector>

// Isosurfaces of volumes voxel by voxel against the same by beams, which know nothing of voxels:
// samples of all types, views along all axes, from within, cut, behind others. The exact reference
// is in tests/oracle/volume_oracle_test.cpp.

namespace zeroset::test::voxel_way_test {
namespace {

/// Waves with some noise, -100 to 100.
double waves(double i, double j, double k, RandomNumbers& random) {
    return 60 * std::sin(0.41 * i + 0.13 * k) * std::cos(0.37 * j) +
           30 * std::sin(0.29 * k + j / 9) + random.uniform(-6, 6);
}

constexpr GridSize size{41, 35, 29};

template <class Sample>
constexpr SampleType type_of() {
    if (std::is_same_v<Sample, float>) return SampleType::Float;
    if (std::is_same_v<Sample, std::int16_t>) return SampleType::Int16;
    if (std::is_same_v<Sample, std::uint8_t>) return SampleType::UInt8;
    return SampleType::Double;
}

/// The waves, moved up by `shift` so that they are of the samples' type.
template <class Sample>
std::shared_ptr<const VolumeData> wavy_data(double shift, double noise_of_type = 1) {
    RandomNumbers random(7);
    const auto numbers = std::make_shared<std::vector<Sample>>();
    for (std::uint64_t k = 0; k < size[2]; ++k) {
        for (std::uint64_t j = 0; j < size[1]; ++j) {
            for (std::uint64_t i = 0; i < size[0]; ++i) {
                const double value = waves(static_cast<double>(i), static_cast<double>(j),
                                           static_cast<double>(k), random);
                numbers->push_back(static_cast<Sample>(noise_of_type * value + shift));
            }
        }
    }
    const double angle = 0.3;
    const Geometry place{.world_from_index = {{{0.05 * std::cos(angle), -0.06 * std::sin(angle), 0},
                                               {0.05 * std::sin(angle), 0.06 * std::cos(angle), 0},
                                               {0, 0, 0.07}}},
                         .origin = {-0.7, -1.2, -1.0}};
    const auto data =
        VolumeData::make({.type = type_of<Sample>(),
                          .size = size,
                          .data = std::shared_ptr<const void>(numbers, numbers->data())},
                         place);
    return data.value();
}

template <class Sample>
std::shared_ptr<const Volume> wavy_volume(double shift, double noise_of_type = 1) {
    return Volume::make(wavy_data<Sample>(shift, noise_of_type), {}, "volume(\"test\")");
}

std::shared_ptr<const Volume> wavy_spline(SplineKind kind) {
    return Volume::make(SplineData::of(wavy_data<float>(0), kind).value(), {}, "volume(\"test\")");
}

Framebuffer drawn(const Scene& scene, const Camera& camera, int side = 90) {
    Framebuffer frame(side, side);
    render_frame(scene, camera, settings_at("beams", 16), frame);
    return frame;
}

/// The scene as one of a formula of which only beams know.
Scene by_beams(Scene scene, const std::shared_ptr<const Volume>& volume, double level) {
    scene.surfaces[0].kernel = interpret(level_set(volume, level));
    return scene;
}

/// Both draw the same; what one has proved the other does not contradict.
void expect_alike(const Framebuffer& voxels, const Framebuffer& beams, const std::string& what) {
    SCOPED_TRACE(what);
    Comparison seen;
    ASSERT_NO_FATAL_FAILURE(compare_frames(voxels, beams, 4e-4F, seen));
    EXPECT_GT(seen.certified, 300);
    EXPECT_LT(seen.undecided, 40);
    EXPECT_LT(seen.difference / seen.certified, 3.0) << "they are lit alike";
}

TEST(VoxelWay, AgreeWithBeamsFromAllSides) {
    const auto volume = wavy_volume<float>(0);
    const Scene scene = scene_of_level(volume, 10);
    const Scene other = by_beams(scene, volume, 10);
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        for (const glm::dvec3& eye : {glm::dvec3(4, 0.3, 0.2),
                                      {-4, 0.4, -0.3},
                                      {0.2, 4, 0.1},
                                      {0.1, -4, 0.5},
                                      {0.3, 0.2, 4},
                                      {-0.2, 0.4, -4},
                                      {3, 3, 2.7},
                                      {-2, 2.5, -3}}) {
            Camera camera{eye, {0, 0, 0}, {0, 0.1, 1}, 0.7, projection};
            expect_alike(drawn(scene, camera), drawn(other, camera),
                         std::to_string(eye.x) + "," + std::to_string(eye.y));
        }
    }
}

TEST(VoxelWay, AgreeOnSplinesFromAllSides) {
    for (const SplineKind kind : {SplineKind::Interpolating, SplineKind::Smoothing}) {
        const auto volume = wavy_spline(kind);
        const Scene scene = scene_of_level(volume, 10);
        const Scene other = by_beams(scene, volume, 10);
        for (const glm::dvec3& eye : {glm::dvec3(4, 0.3, 0.2),
                                      {-3, 2.4, -0.3},
                                      {0.2, 4, 0.1},
                                      {0.1, 0.4, -4},
                                      {3, 3, 2.7}}) {
            const Camera camera{eye, {0, 0, 0}, {0, 0.1, 1}, 0.7};
            expect_alike(drawn(scene, camera), drawn(other, camera), std::to_string(eye.x));
        }
    }
}

TEST(VoxelWay, AgreeOnSplinesFromWithinAndFromFar) {
    const auto volume = wavy_spline(SplineKind::Interpolating);
    const Scene scene = scene_of_level(volume, -20);
    const Scene other = by_beams(scene, volume, -20);
    const Camera within{{0.1, 0.2, 0.05}, {-0.9, 0.6, 0.35}, {0, 0, 1}, 1.2};
    expect_alike(drawn(scene, within), drawn(other, within), "within");
    const Camera far{{30, -25, 20}, {0, 0, 0}, {0, 0, 1}, 0.08};
    expect_alike(drawn(scene, far, 60), drawn(other, far, 60), "far");
}

TEST(VoxelWay, AgreeFromWithinAndFromNear) {
    const auto volume = wavy_volume<float>(0);
    const Scene scene = scene_of_level(volume, -20);
    const Scene other = by_beams(scene, volume, -20);
    for (const glm::dvec3& eye : {glm::dvec3(0.1, 0.2, 0.05), {0.9, 0.1, 0.1}, {0, 0, 0.8}}) {
        Camera camera{eye, eye + glm::dvec3(-1, 0.4, 0.3), {0, 0, 1}, 1.2};
        expect_alike(drawn(scene, camera), drawn(other, camera), std::to_string(eye.x));
    }
}

TEST(VoxelWay, AgreeOnSamplesOfAllTypes) {
    const Camera camera{{2.5, -2, 1.5}, {0, 0, 0}, {0, 0, 1}, 0.7};
    const auto compare = [&](const std::shared_ptr<const Volume>& volume, double level) {
        const Scene scene = scene_of_level(volume, level);
        expect_alike(drawn(scene, camera), drawn(by_beams(scene, volume, level), camera),
                     std::to_string(level));
    };
    compare(wavy_volume<std::uint8_t>(120), 130.5);
    compare(wavy_volume<std::int16_t>(-3000), -3004.25);
    compare(wavy_volume<double>(0), 5);
    compare(wavy_volume<float>(0, 1e-30), 5e-30);
}

TEST(VoxelWay, AgreeWhereRegionsAreCut) {
    const auto volume = wavy_volume<float>(0);
    Scene scene = scene_of_level(volume, 10);
    scene.clip.lo.x += 0.3;
    scene.region.ball = Ball{.centre = {0.1, 0, 0}, .radius = 0.9};
    scene.region.sections = {make_section({1, -2, 0.5}, 0.3, false)};
    const Camera camera{{2.5, -2, 1.5}, {0, 0, 0}, {0, 0, 1}, 0.7};
    expect_alike(drawn(scene, camera), drawn(by_beams(scene, volume, 10), camera), "cut");
}

TEST(VoxelWay, AgreeWherePixelsAreLargerThanVoxels) {
    const auto volume = wavy_volume<float>(0);
    const Scene scene = scene_of_level(volume, 40);
    const Camera camera{{60, -50, 40}, {0, 0, 0}, {0, 0, 1}, 0.03};
    const Framebuffer coarse = drawn(scene, camera, 40);
    int hits = 0;
    const Framebuffer beams = drawn(by_beams(scene, volume, 40), camera, 40);
    for (std::size_t i = 0; i < coarse.depth.size(); ++i) {
        if (coarse.certificate[i] == Certificate::Undecided ||
            beams.certificate[i] == Certificate::Undecided)
            continue;
        EXPECT_EQ(coarse.certificate[i], beams.certificate[i]);
        hits += coarse.certificate[i] == Certificate::Certified ? 1 : 0;
    }
    EXPECT_GT(hits, 200);
}

TEST(VoxelWay, AreUndecidedWhereTheVolumeIsTheLevel) {
    const auto volume = volume_from({9, 9, 9}, {}, [](double i, double, double) {
        return i < 4 ? -1.0 : i > 5 ? 1.0 : 0.0;
    });
    const Scene scene = scene_of_level(volume, 0);
    Camera camera{{-20, 4.3, 4.2}, {4, 4.3, 4.2}, {0, 0, 1}, 0.2};
    camera.projection = Projection::Orthographic;
    const Framebuffer frame = drawn(scene, camera, 31);
    const std::size_t middle = frame.index(15, 15);
    EXPECT_EQ(frame.certificate[middle], Certificate::Undecided);
    EXPECT_NEAR(frame.depth[middle], 24.0F, 0.01F) << "it is drawn where the zeros begin";
}

/// Rays in the planes of the outermost samples meet what is in them.
TEST(VoxelWay, AreThereOnTheBordersOfTheGrid) {
    const Geometry place{.world_from_index = {{{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}},
                         .origin = {-2, -2, -2}};
    const auto square = [](double i) { return (i - 4) * (i - 4) / 4; };
    const auto volume = volume_from({9, 9, 9}, place, [&](double i, double j, double k) {
        return square(i) + square(j) + square(k);
    });
    const Scene scene = scene_of_level(volume, 5);
    for (const double x : {-2.0, 2.0}) {
        for (const double turn : {1.0, -1.0}) {
            Camera camera{{x, 0, 8 * turn}, {x, 0, 0}, {0, 1, 0}, 0.7};
            camera.projection = Projection::Orthographic;
            const Framebuffer frame = drawn(scene, camera, 101);
            int hits = 0;
            for (int row = 0; row < frame.height; ++row)
                hits += std::isfinite(frame.depth[frame.index(50, row)]) ? 1 : 0;
            EXPECT_GT(hits, 25) << x;
        }
    }
}

/// Sums of them are no floats.
TEST(VoxelWay, AgreeOnHugeSamples) {
    RandomNumbers random(4);
    const auto volume = volume_from(
        {9, 9, 9}, {}, [&](double, double, double) { return random.one_in(2) ? 3e38 : -3e38; });
    Scene scene = scene_of_level(volume, 6e37);
    Scene other = scene;
    other.surfaces = {{.kernel = interpret(level_set(volume, 6e37))}};
    const Camera camera{{14, -9, 11}, {4, 4, 4}, {0, 0, 1}, 0.7};
    Comparison seen;
    ASSERT_NO_FATAL_FAILURE(
        compare_frames(drawn(scene, camera), drawn(other, camera), 4e-4F, seen));
    EXPECT_GT(seen.certified, 300);
}

TEST(VoxelWay, PassLevelsThatNoSampleReaches) {
    const auto volume = wavy_volume<float>(0);
    const Scene scene = scene_of_level(volume, 1000);
    const Framebuffer frame = drawn(scene, default_camera(scene.clip), 64);
    EXPECT_TRUE(std::ranges::all_of(frame.certificate, [](Certificate certificate) {
        return certificate == Certificate::Miss;
    }));
}

TEST(VoxelWay, FindNothingBehindAnotherSurface) {
    const auto volume = wavy_volume<float>(0);
    Scene scene = scene_of_level(volume, 10);
    scene.surfaces.push_back({.kernel = kernel_with_level(level_set(volume, 30))});
    Scene other = scene;
    other.surfaces = {{.kernel = interpret(level_set(volume, 10))},
                      {.kernel = interpret(level_set(volume, 30))}};
    const Camera camera{{2.5, -2, 1.5}, {0, 0, 0}, {0, 0, 1}, 0.7};
    expect_alike(drawn(scene, camera), drawn(other, camera), "two");
}

}  // namespace
}  // namespace zeroset::test::voxel_way_test
