// Estimates of distances that iterations give, against closed forms and plain complex numbers.

#include "engine/interpret/interpret.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>

namespace zeroset::test::iteration_test {
namespace {

std::string estimate(int steps, const std::string& constant, const std::string& start = "x, y, z") {
    return "distance_estimate(q, " + std::to_string(steps) + ", (" + start +
           ", 0), quaternion_square(q) + " + constant + ")";
}

double value_of(const std::string& text, double x, double y, double z) {
    const auto expr = parse(text);
    if (!expr) {
        ADD_FAILURE() << text << ": " << expr.error().reason;
        return NAN;
    }
    return value_at(*expr, {x, y, z, 0}).value;
}

struct Range {
    double lo, hi;
};

/// The kernel's enclosure over a box.
Range range_over(const Kernel& kernel, const std::array<double, 3>& lo,
                 const std::array<double, 3>& hi) {
    RangeBoxes<double, batch_multiple> boxes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        boxes.ends[axis][0] = -lo[axis];
        boxes.ends[3 + axis][0] = hi[axis];
    }
    boxes.pad(1);
    Uniforms uniforms;
    uniforms.set(0, 0.0);
    const UpwardRounding upward;
    kernel.in_double.range(boxes.batch(batch_multiple, uniforms.boxes<double>()));
    return {.lo = -boxes.f_neg_lo[0], .hi = boxes.f_hi[0]};
}

/// Without a constant the length is |p|^(2^n), of which the estimate is |p| ln(|p|)/2 for any n,
/// and wherever the steps stop.
TEST(DistanceEstimate, OfPowersHasAClosedForm) {
    RandomNumbers random(3);
    for (const int steps : {0, 1, 4, 12}) {
        for (int round = 0; round < 20; ++round) {
            const std::array<double, 3> p{random.uniform(-2, 2), random.uniform(-2, 2),
                                          random.uniform(-2, 2)};
            const double r = std::hypot(p[0], p[1], p[2]);
            // Far inside, r^(2^n) is below the least number.
            if (r < 0.9) continue;
            EXPECT_NEAR(value_of(estimate(steps, "(0, 0, 0, 0)"), p[0], p[1], p[2]),
                        r * std::log(r) / 2, 1e-9)
                << steps << " steps, r = " << r;
            EXPECT_NEAR(value_of("distance_estimate(u, 5, length(x, y, z), u^3)", p[0], p[1], p[2]),
                        r * std::log(r) / 2, 1e-9);
        }
    }
}

TEST(DistanceEstimate, IsThatOfComplexNumbersInTheirPlane) {
    const std::complex<double> c(-0.12, 0.74);
    RandomNumbers random(4);
    for (int round = 0; round < 200; ++round) {
        const std::complex<double> p(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5));
        std::complex<double> z = p;
        std::complex<double> slope = 1;
        for (int step = 0; step < 9 && std::abs(z) <= 32; ++step) {
            slope = 2.0 * z * slope;
            z = z * z + c;
        }
        const double expected = std::abs(z) * std::log(std::abs(z)) / (2 * std::abs(slope));
        EXPECT_NEAR(value_of(estimate(9, "(-0.12, 0.74, 0, 0)"), p.real(), p.imag(), 0), expected,
                    1e-7 * std::max(1.0, std::abs(expected)));
    }
}

/// The gradient is by x, y and z: what stands twice as large is half as near.
TEST(DistanceEstimate, KnowsWhatMovesThePoint) {
    const std::string plain = estimate(6, "(-0.2, 0.8, 0, 0)");
    const std::string scaled = estimate(6, "(-0.2, 0.8, 0, 0)", "x/2 - 1, y/2, z/2");
    const double near = value_of(plain, 0.9, 0.8, -0.3);
    EXPECT_NEAR(value_of(scaled, 2 * (0.9 + 1), 2 * 0.8, 2 * -0.3), 2 * near, 1e-12);
    const auto called = read_program("f(x, y, z) = " + plain + "\nf(x/2 - 1, y/2, z/2)");
    ASSERT_TRUE(called);
    const std::array<double, 4> at{2 * (0.9 + 1), 1.6, -0.6, 0};
    EXPECT_NEAR(value_at(called->surfaces.back(), at).value, 2 * near, 1e-12);
}

/// The Julia set of q^2 - 2 is the segment from -2 to 2.
TEST(DistanceEstimate, IsNearTheDistance) {
    const auto expr = parse(estimate(40, "(-2, 0, 0, 0)"));
    ASSERT_TRUE(expr);
    RandomNumbers random(5);
    for (int round = 0; round < 200; ++round) {
        const double x = random.uniform(-3, 3);
        const double y = random.uniform(-1, 1);
        const double z = random.uniform(-1, 1);
        const double distance = std::hypot(std::max(std::abs(x) - 2, 0.0), y, z);
        if (distance < 0.05) continue;
        const double value = value_at(*expr, {x, y, z, 0}).value;
        // Koebe's theorem has (1 - e^-2G)/2 for G, which differs by more the farther the point is.
        EXPECT_LE(value, distance * (1 + distance / 2)) << x << " " << y << " " << z;
        EXPECT_GE(value, distance / 4) << x << " " << y << " " << z;
    }
}

TEST(DistanceEstimate, IsBelow0Inside) {
    EXPECT_LT(value_of(estimate(8, "(-0.1, 0.1, 0, 0)"), 0.3, 0.2, 0.1), 0);
    EXPECT_GT(value_of(estimate(8, "(-0.1, 0.1, 0, 0)"), 1.3, 0.2, 0.1), 0);
}

TEST(DistanceEstimate, IsEnclosed) {
    const auto expr = parse(estimate(4, "(-0.2, 0.8, 0, 0)"));
    ASSERT_TRUE(expr);
    const Kernel kernel = interpret(*expr);
    RandomNumbers random(6);
    for (int round = 0; round < 300; ++round) {
        std::array<double, 3> lo{};
        std::array<double, 3> hi{};
        const double size = std::pow(10.0, random.uniform(-4, 0));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lo[axis] = random.uniform(-1.5, 1.5);
            hi[axis] = lo[axis] + size * random.uniform(0, 1);
        }
        const Range range = range_over(kernel, lo, hi);
        for (int sample = 0; sample < 5; ++sample) {
            std::array<double, 4> at{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                at[axis] = std::clamp(random.uniform(lo[axis], hi[axis]), lo[axis], hi[axis]);
            const double value = reference(*expr, at).value.nearest();
            if (std::isnan(value)) continue;
            const double margin = 1e-12 * std::max(1.0, std::abs(value));
            EXPECT_TRUE(range.lo <= value + margin && value - margin <= range.hi)
                << value << " is not in [" << range.lo << ", " << range.hi << "]";
        }
    }
}

TEST(DistanceEstimate, WhatIsWrongIsToldInOneLine) {
    const auto reason = [](const std::string& text) {
        const auto expr = parse(text);
        return expr ? std::string("read") : expr.error().reason;
    };
    EXPECT_TRUE(reason("distance_estimate(q, 3, (x, y), 2)").contains("kind that it starts from"));
    EXPECT_TRUE(reason("distance_estimate(2, 3, (x, y), 2)").contains("is a name"));
    EXPECT_TRUE(reason("distance_estimate(q, 101, (x, y), 2q)").contains("0 to 100 steps"));
    EXPECT_TRUE(reason("distance_estimate(q, 90, (x, y, z), (q.y^9 + sin(q.x), sum(cos(i q.y), i, "
                       "1, 90), q.x q.z))")
                    .contains("20000 operations"));
}

}  // namespace
}  // namespace zeroset::test::iteration_test
