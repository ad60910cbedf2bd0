#include "tests/oracle/ray_audit.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

// Tracers on noise and soft balls against each cell's and each piece's polynomial, solved exactly.
// ZEROSET_FORMULAS says how many surfaces of a kind are made, each for some 500 rays.

namespace zeroset::test::noise_oracle_test {
namespace {

AuditReport audit_of(const std::vector<std::string>& equations, double size,
                     const AuditSettings& settings = {.tracer = "beams", .interpreted = true}) {
    AuditReport total;
    RandomNumbers random(2002);
    for (const std::string& equation : equations) {
        AuditSurface surface{.name = equation,
                             .equation = equation,
                             .clip = Box::cube(size),
                             .w = 0.0,
                             .camera = suite_camera(size)};
        surface.camera.eye = {random.uniform(-3, 3) * size, random.uniform(-3, 3) * size,
                              random.uniform(1, 3) * size};
        total += audit(surface, settings);
    }
    return total;
}

void expect_sound(const AuditReport& total) {
    for (std::size_t i = 0; i < std::min<std::size_t>(total.failures.size(), 10); ++i)
        ADD_FAILURE() << total.failures[i];
    EXPECT_EQ(total.failures.size(), 0U);
    std::printf("%s\n", total.text().c_str());
    EXPECT_GT(total.hit, total.rays / 4);
    EXPECT_LT(total.unknown, total.rays / 10);
    EXPECT_GT(total.hit_certified, total.hit * 9 / 10);
}

std::vector<std::string> noises(const std::string& word, const std::vector<std::string>& levels) {
    std::vector<std::string> equations;
    for (int n = 0; n < formulas_to_try(2); ++n) {
        const auto& level = levels[static_cast<std::size_t>(n) % levels.size()];
        equations.push_back(word + "(x, y, z, " + std::to_string(n) + ") = " + level);
    }
    return equations;
}

TEST(TracerOnNoise, MissesNoRootOfGradientNoise) {
    expect_sound(audit_of(noises("noise", {"0", "0.2", "-0.35"}), 1.7));
}

TEST(TracerOnNoise, MissesNoRootOfValueNoise) {
    expect_sound(audit_of(noises("value_noise", {"0", "0.3", "-0.5"}), 1.7));
}

TEST(TracerOnNoise, MissesNoRootOfCells) {
    expect_sound(audit_of(noises("cellular", {"0.35", "0.5"}), 1.2));
    expect_sound(audit_of(noises("cellular2", {"0.6"}), 1.2));
}

/// A list of balls at random, a few of which take away.
std::string some_balls(RandomNumbers& random, int count, double least, double largest) {
    std::string list;
    for (int ball = 0; ball < count; ++ball) {
        list += list.empty() ? "" : ", ";
        for (int i = 0; i < 3; ++i)
            list += (i == 0 ? "(" : ", ") + std::to_string(random.uniform(-1, 1));
        const double sign = random.one_in(6) ? -1 : 1;
        list += ", " + std::to_string(sign * random.uniform(least, largest)) + ")";
    }
    return "([" + list + "])";
}

std::vector<std::string> blob_equations(const std::string& word, int count) {
    std::vector<std::string> equations;
    RandomNumbers random(1986);
    for (int n = 0; n < count; ++n) {
        const std::string level = n % 3 == 0 ? "0.4" : n % 7 == 6 ? "-0.3" : "1";
        const std::string balls = n % 4 == 3 ? some_balls(random, 200, 0.05, 0.2)
                                             : some_balls(random, random.between(3, 26), 0.1, 0.4);
        equations.push_back(n % 5 == 4 ? level + " = " + word + balls
                                       : word + balls + " = " + level);
    }
    return equations;
}

void expect_no_root_missed(const AuditReport& total) {
    EXPECT_EQ(total.failures.size(), 0U);
    if (!total.failures.empty()) ADD_FAILURE() << total.failures.front();
    std::printf("%s\n", total.text().c_str());
    EXPECT_GT(total.hit, total.rays / 20);
    EXPECT_LT(total.unknown, total.rays / 10);
    EXPECT_GT(total.hit_certified, total.hit * 99 / 100);
}

const AuditSettings by_balls{.tracer = "beams", .interpreted = true, .knows_fields = true};

TEST(TracerOnBlobs, MissesNoRootByBeams) {
    AuditReport total = audit_of(blob_equations("blobs", formulas_to_try(2)), 1.3);
    EXPECT_EQ(total.failures.size(), 0U);
    EXPECT_GT(total.hit_certified, total.hit * 9 / 10);
}

TEST(TracerOnBlobs, MissesNoRootByTheBallsNearRays) {
    expect_no_root_missed(audit_of(blob_equations("blobs", formulas_to_try(4)), 1.3, by_balls));
}

TEST(TracerOnBlobs, MissesNoRootAtCoarseAndFineCells) {
    for (const double d_stop : {8.0, 22.0}) {
        AuditSettings settings = by_balls;
        settings.d_stop = d_stop;
        expect_no_root_missed(audit_of(blob_equations("blobs", formulas_to_try(2)), 1.3, settings));
    }
}

TEST(TracerOnBlobs, MissesNoRootWhereTheyAreCut) {
    std::vector<AuditSurface> surfaces;
    for (const std::string& equation : blob_equations("blobs", formulas_to_try(3))) {
        surfaces.push_back({.name = equation,
                            .equation = equation,
                            .clip = Box::cube(0.9),
                            .camera = suite_camera(0.9)});
    }
    AuditReport total;
    for (const AuditSurface& surface : cut_open(std::move(surfaces), 9))
        total += audit(surface, by_balls);
    expect_no_root_missed(total);
}

TEST(TracerOnBlobs, MissesNoRootFromAmongThem) {
    AuditReport total;
    RandomNumbers random(11);
    for (const std::string& equation : blob_equations("blobs", formulas_to_try(2))) {
        AuditSurface surface{.name = equation,
                             .equation = equation,
                             .clip = Box::cube(1.3),
                             .camera = suite_camera(1.3)};
        for (int i = 0; i < 3; ++i)
            surface.camera.eye[i] = random.uniform(-1, 1);
        surface.camera.fov_rad = random.uniform(0.3, 2.5);
        total += audit(surface, by_balls);
    }
    expect_no_root_missed(total);
}

}  // namespace
}  // namespace zeroset::test::noise_oracle_test
