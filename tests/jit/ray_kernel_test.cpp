#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/processor.hpp"
#include "engine/real/rounding.hpp"
#include "jit/compile.hpp"
#include "tests/support/interpreter_codes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Tests of Newton's method and of values along rays, in machine code and in the interpreter.

namespace zeroset::test::ray_kernel_test {
namespace {

constexpr std::size_t pixels = batch_multiple;

/// Rays with the origin (0, col, -2 row) and the direction (1, col / 4, 0), from the eye (0, 0, 0).
template <class Real>
RaysOf<Real> some_rays() {
    RaysOf<Real> rays{};
    rays.origin_by_col[1] = 1;
    rays.origin_by_row[2] = -2;
    rays.direction[0] = 1;
    rays.direction_by_col[1] = Real{0.25};
    return rays;
}

/// A batch whose item i is the pixel (i % 4, i / 4).
template <class Real>
struct RayBatch {
    RaysOf<Real> rays = some_rays<Real>();
    RaysOf<double> exact_rays = some_rays<double>();
    Uniforms uniforms;
    std::array<float, pixels> col{}, row{}, float_per_slope{};
    std::array<Real, pixels> from{}, to{}, s{}, per_slope{};
    std::array<std::array<Real, pixels>, 3> gradient{};
    std::array<double, pixels> depth{}, f{};
    double lo = -100, hi = 100;

    RayBatch() {
        uniforms.set(0, 0.0);
        for (std::size_t i = 0; i < pixels; ++i) {
            col[i] = static_cast<float>(i % 4);
            row[i] = static_cast<float>(i / 4);
        }
        from.fill(Real{0});
        to.fill(Real{8});
    }
    void newton(const Kernel& kernel, Real small_step, int more_steps) {
        const UpwardRounding upward;
        kernel.newton(
            NewtonBatchOf<Real>{pixels,
                                col.data(),
                                row.data(),
                                from.data(),
                                to.data(),
                                rays.origin,
                                uniforms.points<Real>(),
                                small_step,
                                more_steps,
                                s.data(),
                                {gradient[0].data(), gradient[1].data(), gradient[2].data()},
                                per_slope.data()});
    }
    void values(const Kernel& kernel, int steps) {
        const UpwardRounding upward;
        kernel.ray_value(RayValueBatch{pixels, col.data(), row.data(), float_per_slope.data(),
                                       steps, lo, hi, depth.data(), exact_rays.origin,
                                       uniforms.points<double>(), f.data()});
    }
};

/// Returns the interpreters for every register width that this machine has.
std::vector<std::pair<std::string, Kernel>> interpreters_of(const Expr& expr) {
    std::vector<std::pair<std::string, Kernel>> kernels;
    for (const auto& [name, code] : interpreter_codes()) {
        Kernel kernel = interpret(expr);
        kernel.in_float.newton.call = code->in_float.newton;
        kernel.in_double.newton.call = code->in_double.newton;
        kernel.ray_value.call = code->ray_value;
        kernels.emplace_back(name, std::move(kernel));
    }
    return kernels;
}

std::vector<std::pair<std::string, Kernel>> kernels_of(std::string_view text) {
    const auto expr = parse(text);
    EXPECT_TRUE(expr) << text;
    std::vector<std::pair<std::string, Kernel>> kernels = interpreters_of(*expr);
    for (const int lanes : {4, 8, 16}) {
        auto kernel = jit::compile(*expr, {.lanes = lanes, .with_double = true});
        if (kernel) kernels.emplace_back(std::to_string(lanes) + " lanes", std::move(*kernel));
    }
    auto hasty = jit::compile(*expr, {.with_double = true, .hasty = true});
    if (hasty) kernels.emplace_back("hasty", std::move(*hasty));
    EXPECT_GE(kernels.size(), 3U);
    return kernels;
}

template <class Real>
class RayKernel : public testing::Test {};
struct Names {
    template <class Real>
    static std::string GetName(int /*index*/) {
        return sizeof(Real) == 4 ? "Float" : "Double";
    }
};
using Types = testing::Types<float, double>;
TYPED_TEST_SUITE(RayKernel, Types, Names);

TYPED_TEST(RayKernel, FindsRootsAndTheirGradients) {
    using Real = TypeParam;
    for (const auto& [name, kernel] : kernels_of("x^2 + y - 4")) {
        RayBatch<Real> batch;
        batch.s.fill(Real{3});
        batch.newton(kernel, Real{1e-2F}, 20);
        for (std::size_t i = 0; i < pixels; ++i) {
            // The root solves s^2 + c + c s / 4 = 4.
            const double c = batch.col[i];
            const double root = -c / 8 + std::sqrt(c * c / 64 + 4 - c);
            EXPECT_NEAR(static_cast<double>(batch.s[i]), root, 1e-4) << name << ", pixel " << i;
            EXPECT_NEAR(static_cast<double>(batch.gradient[0][i]), 2 * root, 0.03) << name;
            EXPECT_EQ(batch.gradient[1][i], Real{1}) << name;
            EXPECT_EQ(batch.gradient[2][i], Real{0}) << name;
            EXPECT_NEAR(1 / static_cast<double>(batch.per_slope[i]), 2 * root + c / 4, 0.03)
                << name;
        }
    }
}

TYPED_TEST(RayKernel, TakesOneStepWhereNoOtherIsWanted) {
    using Real = TypeParam;
    for (const auto& [name, kernel] : kernels_of("x^2 - 4")) {
        RayBatch<Real> one;
        one.s.fill(Real{4});
        one.newton(kernel, Real{0}, 0);
        RayBatch<Real> large_steps;
        large_steps.s.fill(Real{4});
        large_steps.newton(kernel, Real{2}, 20);
        for (std::size_t i = 0; i < pixels; ++i) {
            EXPECT_EQ(one.s[i], Real{2.5}) << name;  // one Newton step: 4 - 12/8
            EXPECT_EQ(large_steps.s[i], Real{2.5}) << name;
            EXPECT_EQ(one.per_slope[i], Real{0.125}) << name;
        }
    }
}

TEST(RayKernel, RoundsAProductAndTheSumThatUsesItOnce) {
    if (!machine_has_fma()) GTEST_SKIP() << "no fused multiply-add here";
    const auto kernel = jit::compile(*parse("x^2 - (1 + 2^(-29))"));
    ASSERT_TRUE(kernel);
    RayBatch<double> batch;
    batch.depth.fill(1 + 0x1p-30);
    batch.values(*kernel, 0);
    for (const double f : batch.f)
        EXPECT_EQ(f, 0x1p-60);
}

TYPED_TEST(RayKernel, StaysOnTheStretch) {
    using Real = TypeParam;
    for (const auto& [name, kernel] : kernels_of("sqrt(x) - 3")) {
        RayBatch<Real> batch;
        batch.s.fill(Real{0});  // the slope is infinite at 0, and undefined at pixel 1's start
        batch.from[1] = Real{-2};
        batch.s[1] = Real{-1};
        batch.newton(kernel, Real{1e-3F}, 10);
        EXPECT_EQ(batch.s[1], Real{-2}) << name;
        for (std::size_t i = 0; i < pixels; ++i) {
            EXPECT_GE(batch.s[i], batch.from[i]) << name;
            EXPECT_LE(batch.s[i], batch.to[i]) << name;
        }
    }
}

TEST(RayValue, IsExactOnExactRays) {
    for (const auto& [name, kernel] : kernels_of("x + 10y + 100z")) {
        RayBatch<double> batch;
        batch.depth.fill(2.0);
        batch.values(kernel, 0);
        for (std::size_t i = 0; i < pixels; ++i) {
            const double col = batch.col[i];
            EXPECT_EQ(batch.f[i],
                      2 + 10 * (col + 2 * col / 4) - 200.0 * static_cast<double>(batch.row[i]))
                << name;
            EXPECT_EQ(batch.depth[i], 2.0) << name;
        }
    }
}

TEST(RayValue, StepsByTheGivenSlope) {
    for (const auto& [name, kernel] : kernels_of("x^2 - 2")) {
        RayBatch<double> batch;
        batch.depth.fill(1.5);
        batch.float_per_slope.fill(0.5F);
        batch.values(kernel, 2);
        const double first = 1.5 - 0.25 / 2;
        const double second = first - (first * first - 2) / 2;
        for (std::size_t i = 0; i < pixels; ++i) {
            EXPECT_DOUBLE_EQ(batch.depth[i], second) << name;
            EXPECT_NEAR(batch.f[i], second * second - 2, 1e-15) << name;
        }
    }
}

TEST(RayValue, StepsNoFartherThanTheSlopesHold) {
    for (const auto& [name, kernel] : kernels_of("x^2 - 2")) {
        RayBatch<double> batch;
        batch.lo = -1;
        batch.hi = 3;
        batch.depth = {1, 1, 1, 1};
        batch.float_per_slope = {1, -8, std::numeric_limits<float>::quiet_NaN(), 8};
        batch.values(kernel, 1);
        const std::array<double, 4> ends{2, -1, -1, 3};
        for (std::size_t i = 0; i < ends.size(); ++i) {
            EXPECT_EQ(batch.depth[i], ends[i]) << name;
            EXPECT_EQ(batch.f[i], ends[i] * ends[i] - 2) << name;
        }
    }
}

}  // namespace
}  // namespace zeroset::test::ray_kernel_test
