#include "tests/oracle/ray_audit.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

// Tracers on noise and soft balls against each cell's and each piece's polynomial, solved exactly.
// ZEROSET_FORMULAS says how many surfaces of a kind are made, each for some 500 rays.

namespace zeroset::test {
namespace {

AuditReport audit_of(const std::vector<std::string>& equations, double size) {
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
        total += audit(surface, {.tracer = "beams", .interpreted = true});
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
    for (int n = 0; n < formulas_to_try(6); ++n) {
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

TEST(TracerOnBlobs, MissesNoRoot) {
    std::vector<std::string> equations;
    RandomNumbers random(1986);
    for (int n = 0; n < formulas_to_try(8); ++n) {
        std::string list;
        for (int ball = random.between(2, 25); ball >= 0; --ball) {
            list += list.empty() ? "" : ", ";
            for (int i = 0; i < 3; ++i)
                list += (i == 0 ? "(" : ", ") + std::to_string(random.uniform(-1, 1));
            const double sign = random.one_in(6) ? -1 : 1;
            list += ", " + std::to_string(sign * random.uniform(0.1, 0.4)) + ")";
        }
        equations.push_back("blobs([" + list + "]) = " + (n % 3 == 0 ? "0.4" : "1"));
    }
    AuditReport total = audit_of(equations, 1.3);
    EXPECT_EQ(total.failures, std::vector<std::string>());
    std::printf("%s\n", total.text().c_str());
    EXPECT_GT(total.hit, total.rays / 10);
    EXPECT_LT(total.unknown, total.rays / 10);
    EXPECT_GT(total.hit_certified, total.hit * 9 / 10);
}

}  // namespace
}  // namespace zeroset::test
