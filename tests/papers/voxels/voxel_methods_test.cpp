#include "papers/voxels/proved_root.hpp"
#include "papers/voxels/voxel_tracers.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

// The methods in single voxels: against cubics with known roots, against proved roots, and packets
// against single rays.

namespace zeroset::test::voxel_methods_test {
namespace {

constexpr std::array all_methods{VoxelMethod::Midpoint, VoxelMethod::Linear, VoxelMethod::Neubauer,
                                 VoxelMethod::Schwarze, VoxelMethod::Marmitt};
constexpr std::array accurate_methods{VoxelMethod::Schwarze, VoxelMethod::Marmitt};

/// A voxel along whose diagonal rho is scale (t - r_0) (t - r_1) (t - r_2), with a ray along it.
VoxelRay diagonal_ray(const std::array<double, 3>& r, double scale = 1) {
    const double a = scale;
    const double b = -scale * (r[0] + r[1] + r[2]);
    const double c = scale * (r[0] * r[1] + r[0] * r[2] + r[1] * r[2]);
    const double d = -scale * r[0] * r[1] * r[2];
    VoxelRay ray;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const bool u = (corner & 1U) != 0;
        const bool v = (corner & 2U) != 0;
        const bool w = (corner & 4U) != 0;
        // Unequal shares, so that no axis is like another
        double rho = d + (u ? 0.5 * c : 0) + (v ? 0.25 * c : 0) + (w ? 0.25 * c : 0);
        rho += (u && v ? 0.25 * b : 0) + (u && w ? 0.5 * b : 0) + (v && w ? 0.25 * b : 0);
        ray.rho[corner] = static_cast<float>(rho + (u && v && w ? a : 0));
    }
    ray.a = {0, 0, 0};
    ray.b = {1, 1, 1};
    ray.t_out = 1;
    return ray;
}

VoxelRay random_ray(RandomNumbers& random) {
    VoxelRay ray;
    for (float& rho : ray.rho)
        rho = static_cast<float>(random.uniform(-1, 1));
    const auto entry = random.below(3);
    for (std::size_t i = 0; i < 3; ++i) {
        ray.a[i] = static_cast<float>(i == entry ? 0 : random.uniform(0, 1));
        ray.b[i] = static_cast<float>((i == entry ? 1 : random.uniform(0, 1)) -
                                      static_cast<double>(ray.a[i]));
    }
    ray.t_out = 1;
    return ray;
}

/// Algorithm 3 of [Marmitt04] as it is printed, with three interpolations, in double.
double printed_algorithm_3(const std::array<double, 4>& c) {
    const auto f = [&](double t) { return ((c[3] * t + c[2]) * t + c[1]) * t + c[0]; };
    double t_0 = 0;
    double t_1 = 1;
    double f_0 = f(t_0);
    double f_1 = f(t_1);
    const double radicand = c[2] * c[2] - 3 * c[3] * c[1];
    if (radicand >= 0) {
        std::array e{(-c[2] - std::sqrt(radicand)) / (3 * c[3]),
                     (-c[2] + std::sqrt(radicand)) / (3 * c[3])};
        std::ranges::sort(e);
        for (const double extremum : e) {
            if (!(extremum >= t_0 && extremum <= t_1)) continue;
            const double f_e = f(extremum);
            if ((f_e < 0) == (f_0 < 0)) {
                t_0 = extremum;
                f_0 = f_e;
            } else {
                t_1 = extremum;
                f_1 = f_e;
            }
        }
    }
    if ((f_0 < 0) == (f_1 < 0)) return std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const double t = t_0 + (t_1 - t_0) * -f_0 / (f_1 - f_0);
        const double f_t = f(t);
        const bool before = (f_t < 0) != (f_0 < 0);
        (before ? t_1 : t_0) = t;
        (before ? f_1 : f_0) = f_t;
    }
    return t_0 + (t_1 - t_0) * -f_0 / (f_1 - f_0);
}

/// The cubic with the roots.
std::array<double, 4> cubic_with(const std::array<double, 3>& r) {
    return {-r[0] * r[1] * r[2], r[0] * r[1] + r[0] * r[2] + r[1] * r[2], -r[0] - r[1] - r[2], 1};
}

std::vector<float> hits_of(VoxelMethod method, RaysAtOnce rays, const VoxelRays& voxels) {
    std::vector<float> t(voxels.size());
    find_first_hits(method, rays, voxels, t);
    t.resize(voxels.count());
    return t;
}

float hit_of(VoxelMethod method, const VoxelRay& ray) {
    VoxelRays voxels;
    voxels.add(ray);
    voxels.pad();
    return hits_of(method, RaysAtOnce::Packet, voxels)[0];
}

bool misses(VoxelMethod method, const VoxelRay& ray) { return std::isinf(hit_of(method, ray)); }

TEST(VoxelMethods, FindASingleRoot) {
    for (const double root : {0.1, 0.4, 0.75}) {
        const VoxelRay ray = diagonal_ray({root, 1.8, -1.3});
        EXPECT_EQ(hit_of(VoxelMethod::Midpoint, ray), 0.5F);
        EXPECT_NEAR(hit_of(VoxelMethod::Linear, ray), root, 0.2);
        EXPECT_NEAR(hit_of(VoxelMethod::Neubauer, ray), root, 2e-3);
        EXPECT_NEAR(hit_of(VoxelMethod::Schwarze, ray), root, 1e-4);
        EXPECT_NEAR(hit_of(VoxelMethod::Marmitt, ray), root, 2e-3);
    }
}

TEST(VoxelMethods, InterpolateExactlyWhereRhoIsLinear) {
    VoxelRay ray;
    for (unsigned corner = 0; corner < 8; ++corner)
        ray.rho[corner] = static_cast<float>((corner & 1U) != 0 ? 0.75 : -0.25) +
                          ((corner & 4U) != 0 ? 0.125F : 0.0F);
    ray.a = {0, 0.25F, 0.5F};
    ray.b = {1, 0.5F, 0};
    ray.t_out = 1;
    for (const VoxelMethod method :
         {VoxelMethod::Linear, VoxelMethod::Neubauer, VoxelMethod::Schwarze, VoxelMethod::Marmitt})
        EXPECT_NEAR(hit_of(method, ray), 0.1875, 1e-6);
}

TEST(VoxelMethods, OnlyThoseOfTheCubicFindTwoRoots) {
    const VoxelRay ray = diagonal_ray({0.3, 0.6, 2.5});
    EXPECT_TRUE(misses(VoxelMethod::Linear, ray));
    EXPECT_TRUE(misses(VoxelMethod::Neubauer, ray));
    EXPECT_NEAR(hit_of(VoxelMethod::Schwarze, ray), 0.3, 1e-4);
    EXPECT_NEAR(hit_of(VoxelMethod::Marmitt, ray), 0.3, 0.03);
}

TEST(VoxelMethods, OnlyThoseOfTheCubicFindTheFirstOfThreeRoots) {
    // The line from the first end to the other is 0 behind the first two roots.
    const VoxelRay ray = diagonal_ray({0.1, 0.2, 0.9});
    EXPECT_GT(hit_of(VoxelMethod::Neubauer, ray), 0.15F);
    EXPECT_NEAR(hit_of(VoxelMethod::Schwarze, ray), 0.1, 1e-4);
    EXPECT_NEAR(hit_of(VoxelMethod::Marmitt, ray), 0.1, 0.01);
}

TEST(VoxelMethods, MarmittsIsThePrintedAlgorithm) {
    RandomNumbers random(5);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::array r{random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5),
                           random.uniform(-2, 3)};
        const double printed = printed_algorithm_3(cubic_with(r));
        const double t = static_cast<double>(hit_of(VoxelMethod::Marmitt, diagonal_ray(r)));
        if (std::isinf(printed) || std::isinf(t)) {
            // Where they differ, two roots are so near that floats do not tell them from none.
            const bool close = std::abs(r[0] - r[1]) < 0.01 || std::abs(r[0] - r[2]) < 0.01 ||
                               std::abs(r[1] - r[2]) < 0.01;
            const bool at_face = std::ranges::any_of(
                r, [](double root) { return std::abs(root) < 1e-4 || std::abs(root - 1) < 1e-4; });
            EXPECT_TRUE(std::isinf(printed) == std::isinf(t) || close || at_face) << i;
            continue;
        }
        hits += std::abs(t - printed) < 1e-3 ? 1 : 0;
    }
    EXPECT_GT(hits, 1000);
}

TEST(VoxelMethods, FindNothingWhereThereIsNothing) {
    const VoxelRay ray = diagonal_ray({-0.5, 1.5, 3.0});
    for (const VoxelMethod method : all_methods) {
        EXPECT_EQ(misses(method, ray), method != VoxelMethod::Midpoint);
    }
}

TEST(VoxelMethods, TheScaleOfRhoDoesNotMatter) {
    for (const double scale : {1e-12, 1e12}) {
        for (const VoxelMethod method : accurate_methods) {
            EXPECT_NEAR(hit_of(method, diagonal_ray({0.3, 0.6, 2.5}, scale)),
                        hit_of(method, diagonal_ray({0.3, 0.6, 2.5})), 1e-5);
        }
    }
}

TEST(VoxelMethods, GiveTheSameInPacketsAsSingly) {
    RandomNumbers random(7);
    VoxelRays voxels;
    for (int i = 0; i < 1000; ++i)
        voxels.add(random_ray(random));
    voxels.pad();
    for (const VoxelMethod method : all_methods)
        EXPECT_EQ(hits_of(method, RaysAtOnce::One, voxels),
                  hits_of(method, RaysAtOnce::Packet, voxels));
}

TEST(VoxelMethods, OfTheCubicAgreeWithProvedRoots) {
    RandomNumbers random(11);
    VoxelRays voxels;
    for (int i = 0; i < 20'000; ++i)
        voxels.add(random_ray(random));
    voxels.pad();
    for (const VoxelMethod method : accurate_methods) {
        const auto t = hits_of(method, RaysAtOnce::Packet, voxels);
        int wrong = 0;
        int far = 0;
        int roots = 0;
        for (std::size_t i = 0; i < t.size(); ++i) {
            const ProvedRoot proved = proved_first_root(voxels.ray(i));
            if (proved.kind == ProvedRoot::Kind::Unknown) continue;
            const bool has = proved.kind == ProvedRoot::Kind::Root;
            wrong += has != std::isfinite(t[i]) ? 1 : 0;
            if (!has || !std::isfinite(t[i])) continue;
            ++roots;
            far += std::abs(static_cast<double>(t[i]) - proved.t) > 0.01 ? 1 : 0;
        }
        EXPECT_GT(roots, 8000);
        // In floats some roots near the voxel's faces and some double ones are lost or invented.
        EXPECT_LE(wrong, 40);
        // Three interpolations leave an eighth of Marmitt's so far away.
        EXPECT_LE(far, method == VoxelMethod::Schwarze ? roots / 100 : roots / 6);
    }
}

TEST(ProvedRoot, IsTheFirstOne) {
    for (const auto& [roots, first] : {std::pair(std::array{0.25, 0.5, 0.75}, 0.25),
                                       std::pair(std::array{-0.5, 0.5, 0.625}, 0.5),
                                       std::pair(std::array{0.875, 1.5, 2.0}, 0.875)}) {
        const ProvedRoot proved = proved_first_root(diagonal_ray(roots));
        ASSERT_EQ(proved.kind, ProvedRoot::Kind::Root);
        EXPECT_NEAR(proved.t, first, 1e-7);
    }
    EXPECT_EQ(proved_first_root(diagonal_ray({-0.5, 1.5, 3.0})).kind, ProvedRoot::Kind::None);
    // A root that rho touches only, which rounding does not tell from none or two.
    EXPECT_NE(proved_first_root(diagonal_ray({0.5, 0.5, 4.0})).kind, ProvedRoot::Kind::None);
}

}  // namespace
}  // namespace zeroset::test::voxel_methods_test
