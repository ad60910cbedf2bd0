#include "pipeline/sample_grid.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/kernel/point_batch.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace zeroset::sample_grid_test {
namespace {

Uniforms uniforms_of(const std::vector<double>& numbers) {
    Uniforms uniforms;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        uniforms.set(i, numbers[i]);
    return uniforms;
}

/// f at the samples, point by point, by the whole graph at once.
std::vector<float> point_by_point(const Expr& f, const Uniforms& uniforms, const GridPlan& plan) {
    const Geometry geometry = geometry_of(plan);
    const std::size_t count = plan.size[0] * plan.size[1] * plan.size[2];
    PointBatch<double> batch(count, PointBatch<double>::Asks::Value);
    for (std::size_t i = 0; i < count; ++i) {
        const std::array index{i % plan.size[0], i / plan.size[0] % plan.size[1],
                               i / plan.size[0] / plan.size[1]};
        std::array<double, 3> at{};
        const UpwardRounding upward;
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] = geometry.origin[k] +
                    geometry.world_from_index[k][k] * static_cast<double>(index[k]);
        }
        batch.set(i, at[0], at[1], at[2]);
    }
    batch.pad();
    {
        const UpwardRounding upward;
        batch.evaluate(interpret_points(f), uniforms.points<double>(), [] { return false; });
    }
    std::vector<float> samples(count);
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = static_cast<float>(batch.f(i));
    return samples;
}

void expect_same_bits(std::span<const float> a, std::span<const float> b, const std::string& text) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        const bool same = std::bit_cast<std::uint32_t>(a[i]) == std::bit_cast<std::uint32_t>(b[i]);
        ASSERT_TRUE(same || (std::isnan(a[i]) && std::isnan(b[i])))
            << text << " at sample " << i << ": " << a[i] << " for " << b[i];
    }
}

std::vector<float> in_order(const GridFunction& function) {
    std::vector<float> samples;
    EXPECT_TRUE(sample_in_order(function, [&](std::span<const float> some) {
        samples.insert(samples.end(), some.begin(), some.end());
        return true;
    }));
    return samples;
}

TEST(GridFunction, HasTheBitsOfTheWholeFormulaAtEachPoint) {
    test::RandomNumbers random(51);
    const GridPlan plan{.box = {.lo = {-2, -1, -1.5}, .hi = {1.25, 1.75, 2}}, .size = {19, 5, 4}};
    for (int i = 0; i < 300; ++i) {
        const Expr f = test::random_expression(random, 1 + i % 6);
        const Uniforms uniforms = uniforms_of({0.625});
        const std::vector<float> samples = in_order({f, uniforms, plan});
        expect_same_bits(samples, point_by_point(f, uniforms, plan), f.canonical());
    }
}

TEST(GridFunction, HasTheBitsOfFormulasWithParameters) {
    const GridPlan plan{.box = {.lo = {-1, -1, -1}, .hi = {1, 1, 1}}, .size = {33, 7, 6}};
    for (const char* text : {"a x^2 + b y^3 - sin(a z) x", "a y + b z", "exp(a x) - b", "a + b",
                             "sqrt(x) + ln(a y) + b z"}) {
        const Expr f = *parse(text);
        const Uniforms uniforms = uniforms_of({0, 1.5, -0.25});
        const std::vector<float> samples = in_order({f, uniforms, plan});
        expect_same_bits(samples, point_by_point(f, uniforms, plan), text);
    }
}

TEST(GridFunction, GivesSamplesInTheirOrderAndInMemoryAlike) {
    const Expr f = *parse("x + 100 y + 10000 z");
    const GridPlan plan{.box = {.lo = {0, 0, 0}, .hi = {99, 99, 49}}, .size = {100, 100, 50}};
    const Samples samples = sampled(f, uniforms_of({0}), plan);
    const auto* const numbers = static_cast<const float*>(samples.data.get());
    const std::span<const float> in_memory(numbers, samples.count());
    expect_same_bits(in_order({f, uniforms_of({0}), plan}), in_memory, "");
    for (std::size_t i = 0; i < in_memory.size(); ++i)
        ASSERT_EQ(in_memory[i], static_cast<float>(i));
}

TEST(GridFunction, EndsEarlyWhereSamplesAreNotTaken) {
    const GridPlan plan{.box = {.lo = {0, 0, 0}, .hi = {1, 1, 1}}, .size = {256, 256, 64}};
    int calls = 0;
    EXPECT_FALSE(sample_in_order({*parse("x"), uniforms_of({0}), plan},
                                 [&](std::span<const float> /*some*/) { return ++calls < 3; }));
    EXPECT_EQ(calls, 3);
}

}  // namespace
}  // namespace zeroset::sample_grid_test
