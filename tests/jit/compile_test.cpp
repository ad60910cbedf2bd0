#include "jit/compile.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/real/processor.hpp"
#include "engine/real/rounding.hpp"
#include "tests/jit/machine_code.hpp"
#include "tests/support/kernel_batch.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <thread>
#include <vector>

// Tests of which code is compiled when, and which code is shared.

namespace zeroset::test::compile_test {
namespace {

/// Returns the form's centres c and errors e over cells without width across the view, at depths
/// 0, 1/8, 2/8, ... with radius 1/16.
std::vector<float> centres_and_errors(const KernelFunction<FormBatch>& form) {
    constexpr std::size_t count = batch_multiple;
    using Column = std::array<float, count>;
    FrustumOf<float> view{};
    for (std::size_t i = 0; i < 3; ++i) {
        view.right[i] = i == 0 ? 1.0F : 0.0F;
        view.up[i] = i == 1 ? 1.0F : 0.0F;
        view.forward[i] = i == 2 ? 1.0F : 0.0F;
        view.size[i] = view.direction_size[i] = 4.0F;
    }
    view.distance = 1.0F;
    Column u{}, v{}, s{}, s_radius{}, c{}, ku{}, kv{}, ks{}, e{}, r{}, neg_lo{}, hi{};
    u.fill(0.25F);
    v.fill(-0.5F);
    s_radius.fill(0.0625F);
    for (std::size_t i = 0; i < count; ++i)
        s.at(i) = 0.125F * static_cast<float>(i);
    std::array<ContinuityMask<float>, count> continuous{}, nowhere{};
    const UpwardRounding upward;
    form(FormBatch{count,
                   u.data(),
                   v.data(),
                   s.data(),
                   s_radius.data(),
                   view.base,
                   nullptr,
                   c.data(),
                   {ku.data(), kv.data(), ks.data()},
                   e.data(),
                   r.data(),
                   neg_lo.data(),
                   hi.data(),
                   continuous.data(),
                   nowhere.data()});
    std::vector<float> result(c.begin(), c.end());
    result.insert(result.end(), e.begin(), e.end());
    return result;
}

void expect_same_bits(const Kernel& a, const Kernel& b, const KernelBatch& batch,
                      const std::string& text) {
    EXPECT_EQ(centres_and_errors(a.in_float.form), centres_and_errors(b.in_float.form)) << text;
    EXPECT_EQ(centres_and_errors(a.in_float.ray_form), centres_and_errors(b.in_float.ray_form))
        << text;
    EXPECT_EQ(batch.run(a), batch.run(b)) << text;
}

TEST(Jit, SharesTheCodeOfEqualGraphs) {
    const Kernel first = compiled(parsed("x^2 + y^2 + z^2 - 1.25"), 4);
    const Kernel second = compiled(parsed("x*x + y*y + z*z = 1.25"), 4);
    const Kernel other = compiled(parsed("x*x + y*y + z*z = 1.26"), 4);
    EXPECT_EQ(first.in_float.range, second.in_float.range);
    EXPECT_EQ(first.in_float.form, second.in_float.form);
    EXPECT_NE(first.in_float.range, other.in_float.range);
}

TEST(Jit, MakesDoubleWhenAskedAndApart) {
    const Expr expr = parsed("x^2 + y^2 + z^2 - 1.75");
    const Kernel floats = compiled(expr, 4);
    EXPECT_FALSE(floats.has_double);
    const Kernel both = compiled(expr, 4, true);
    EXPECT_TRUE(both.has_double);
    EXPECT_EQ(floats.in_float.range, both.in_float.range);
    EXPECT_EQ(floats.in_double.value, both.in_double.value);
    EXPECT_NE(floats.in_double.form, both.in_double.form);
    EXPECT_EQ(both.in_double.range, compiled(expr, 4, true).in_double.range);
}

TEST(Jit, LetsOtherCodeWorkUntilAFunctionIsMade) {
    const Expr expr = parsed("x^3*y + 1.0625*sin(y*z) - x*z^2");
    RandomNumbers random(19);
    const KernelBatch batch(random, 64);
    const Kernel quick = test::compiled(expr, {.quick = true});
    const Kernel meanwhile = quick.without_waiting();
    EXPECT_NE(meanwhile.in_float.range, quick.in_float.range);
    EXPECT_EQ(meanwhile.in_float.form, quick.in_float.form);
    EXPECT_EQ(batch.run(interpret(expr)), batch.run(meanwhile));

    EXPECT_NE(meanwhile.in_float.ray_form, quick.in_float.ray_form);
    EXPECT_EQ(centres_and_errors(meanwhile.in_float.ray_form),
              centres_and_errors(quick.in_float.form));
    const auto of_rays = centres_and_errors(quick.in_float.ray_form);
    const auto interpreted = centres_and_errors(interpret(expr).in_float.ray_form);
    // Equal except for fused roundings. Where there is no FMA, compiled code rounds a ray twice
    // more than the interpreter, which fuses there all the same.
    const float most_apart = machine_has_fma() ? 1e-6F : 2e-4F;
    for (std::size_t i = 0; i < of_rays.size(); ++i)
        EXPECT_NEAR(of_rays[i], interpreted[i], most_apart);
    EXPECT_EQ(centres_and_errors(meanwhile.in_float.ray_form), of_rays);
    EXPECT_EQ(batch.run(quick), batch.run(meanwhile));
}

TEST(Jit, MakesAFunctionWhenItIsCalledWithTheBitsOfThoseMadeAtOnce) {
    RandomNumbers random(24);
    const KernelBatch batch(random, 64);
    for (const char* const text :
         {"x^3*y + 1.0703125*sin(y*z) - x*z^2", "max(abs(x) - 0.6, y/z)"}) {
        const Expr expr = parsed(text);
        EXPECT_FALSE(jit::is_compiled(expr, {}));
        const Kernel on_call = test::compiled(expr, {.on_call = true});
        EXPECT_FALSE(jit::is_compiled(expr, {}));
        const Kernel at_once = test::compiled(expr, {});
        EXPECT_NE(on_call.in_float.form, at_once.in_float.form);
        expect_same_bits(on_call, at_once, batch, text);
    }
}

TEST(Jit, HasTheSameBitsInHaste) {
    RandomNumbers random(20);
    const KernelBatch batch(random, 64);
    for (const char* const text : {"x^3*y + 1.0625*sin(y*z) - x*z^2", "max(abs(x) - 0.7, y/z)",
                                   "if(x < y, exp(z), sqrt(x^2 + z^2))"}) {
        const Expr expr = parsed(text);
        const Kernel thorough = test::compiled(expr, {});
        const Kernel hasty = test::compiled(expr, {.hasty = true});
        EXPECT_NE(hasty.in_float.form, thorough.in_float.form);
        expect_same_bits(hasty, thorough, batch, text);
    }
}

TEST(Jit, HasTheSameBitsBeforeAndAfterItsPatienceEnds) {
    RandomNumbers random(21);
    const KernelBatch batch(random, 64);
    const Expr expr = parsed("x^3*y + 1.09375*sin(y*z) - x*z^2");
    const auto expected = batch.run(interpret(expr));
    const Kernel patient = test::compiled(expr, {.patient_nodes = 64 * 8 * expr.nodes().size()});
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(batch.run(patient), expected) << i;
}

TEST(Jit, MakesDoubleWhenItIsCalledWithTheInterpretersBits) {
    RandomNumbers random(22);
    const KernelBatchOf<double> batch(random, 64);
    for (const char* const text : {"x^3*y + 1.03125*sin(y*z) - x*z^2", "max(abs(x) - 0.7, y/z)",
                                   "if(x < y, exp(z), sqrt(x^2 + z^2)) - w"}) {
        const Expr expr = parsed(text);
        const auto expected = batch.run(interpret(expr));
        for (const std::size_t calls : {0UL, 3UL}) {
            jit::forget_code();
            const jit::CompileOptions options{.patient_nodes = calls * 64 * expr.nodes().size()};
            const Kernel kernel = jit::compile_when_called(expr, options);
            for (int i = 0; i < 8; ++i)
                EXPECT_EQ(batch.run(kernel), expected) << text << ", " << i;
            const Kernel again = jit::compile_when_called(expr, options);
            EXPECT_EQ(again.in_double.range, kernel.in_double.range) << "equal graphs share code";
            EXPECT_EQ(again.in_double.value, kernel.in_double.value);
            EXPECT_EQ(again.in_double.form, kernel.in_double.form);
        }
    }
}

TEST(Jit, MakesOneCodeForManyThreadsThatCallIt) {
    RandomNumbers random(23);
    const KernelBatchOf<double> batch(random, 64);
    const Expr expr = parsed("x^3*y + 1.015625*cos(y*z) - x*z^2");
    const auto expected = batch.run(interpret(expr));
    const Kernel kernel = jit::compile_when_called(expr, {.patient_nodes = 1});
    std::vector<std::thread> threads;
    std::array<bool, 4> same{};
    for (bool& is_same : same) {
        threads.emplace_back([&] {
            is_same = true;
            for (int i = 0; i < 8; ++i)
                is_same = is_same && batch.run(kernel) == expected;
        });
    }
    for (std::thread& thread : threads)
        thread.join();
    for (const bool is_same : same)
        EXPECT_TRUE(is_same);
}

TEST(Jit, InterpretsWhatNoMachineCanCompileWhenItIsCalled) {
    RandomNumbers random(24);
    const KernelBatchOf<double> batch(random, 64);
    const Expr expr = parsed("x^3*y + sin(y*z) - x*z^2");
    const Kernel kernel = jit::compile_when_called(expr, {.lanes = 5});
    EXPECT_EQ(batch.run(kernel), batch.run(interpret(expr)));
}

TEST(Jit, KeepsLaneCountsApart) {
    const Expr expr = parsed("x^2 + y^2 + z^2 - 1.5");
    const std::vector<int> lanes = machine_lanes();
    for (std::size_t i = 1; i < lanes.size(); ++i) {
        EXPECT_NE(compiled(expr, lanes[i - 1]).in_float.range,
                  compiled(expr, lanes[i]).in_float.range);
    }
    EXPECT_EQ(compiled(expr, 0).in_float.range, compiled(expr, jit::host_lanes()).in_float.range);
    EXPECT_EQ(jit::host_lanes(), lanes.back());
}

TEST(Jit, RefusesLanesThatNoMachineHas) {
    const Expr expr = parsed("x");
    for (const int lanes : {-4, 1, 2, 5, 32}) {
        const auto kernel = jit::compile(expr, {.lanes = lanes});
        ASSERT_FALSE(kernel.has_value()) << lanes;
        EXPECT_NE(kernel.error().message.find(std::to_string(lanes)), std::string::npos)
            << kernel.error().message;
        EXPECT_FALSE(jit::ir(expr, {.lanes = lanes}).has_value());
        EXPECT_FALSE(jit::assembly(expr, {.lanes = lanes}).has_value());
    }
}

TEST(Jit, CompilesOnManyThreadsAtOnce) {
    constexpr int threads = 6;
    RandomNumbers random(16);
    const KernelBatch batch(random, 64);
    std::array<int, threads> differences{};
    const auto work = [&](int thread) {
        for (int i = 0; i < 4; ++i) {
            // For even i all threads compile the same graph, else each thread its own.
            const int number = i % 2 == 0 ? i : 10 * thread + i;
            const auto expr = parse("x^3 + sin(y*" + std::to_string(number) + ") - z");
            const auto kernel = jit::compile(*expr);
            const bool same = kernel && batch.run(*kernel) == batch.run(interpret(*expr));
            if (!same) ++differences.at(static_cast<std::size_t>(thread));
        }
    };
    std::vector<std::jthread> running;
    for (int thread = 0; thread < threads; ++thread)
        running.emplace_back(work, thread);
    running.clear();
    EXPECT_EQ(differences, (std::array<int, threads>{}));
}

TEST(Jit, OutlivesTheCache) {
    RandomNumbers random(17);
    const KernelBatch batch(random, 16);
    const Expr expr = parsed("x*y - z*0.5");
    const Kernel kernel = compiled(expr, 4);
    for (int i = 0; i < 70; ++i)
        compiled(parsed("x + " + std::to_string(i)), 4);
    EXPECT_EQ(batch.run(interpret(expr)), batch.run(kernel));
}

}  // namespace
}  // namespace zeroset::test::compile_test
