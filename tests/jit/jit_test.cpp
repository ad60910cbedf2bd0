#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "engine/real/sleef.hpp"
#include "jit/compile.hpp"
#include "tests/jit/machine_code.hpp"
#include "tests/support/compiled.hpp"
#include "tests/support/kernel_batch.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

// Compares machine code with the interpreter bit for bit, at every lane count of this machine.

namespace zeroset::test::jit_test {
namespace {

/// Describes the first item at which two answers differ; "none" if they are equal.
std::string difference(const std::vector<std::uint64_t>& expected,
                       const std::vector<std::uint64_t>& found) {
    const auto [a, b] = std::ranges::mismatch(expected, found);
    if (a == expected.end()) return "none";
    char text[80];
    std::snprintf(text, sizeof text, "item %td: expected %016" PRIx64 ", found %016" PRIx64,
                  a - expected.begin(), *a, *b);
    return text;
}

/// Batches of the same size in float and double.
struct Batches {
    KernelBatch floats;
    KernelBatchOf<double> doubles;

    Batches(RandomNumbers& random, std::size_t count)
        : floats(random, count), doubles(random, count) {}
};

void expect_same(const Bits& expected, const Bits& found, const std::string& what) {
    EXPECT_EQ("none", difference(expected.range, found.range)) << "range, " << what;
    EXPECT_EQ("none", difference(expected.value, found.value)) << "value, " << what;
}

void expect_same_bits(const Expr& expr, const Batches& batches) {
    const Kernel reference = interpret(expr);
    const Bits floats = batches.floats.run(reference);
    const Bits doubles = batches.doubles.run(reference);
    // All functions are made at one lane count, which is another one for other formulas; at the
    // others those that are compared.
    const std::vector<int> all_lanes = machine_lanes();
    const int complete = all_lanes[expr.nodes().size() % all_lanes.size()];
    for (const int lanes : all_lanes) {
        const Kernel kernel = test::compiled(
            expr, {.lanes = lanes, .with_double = true, .on_call = lanes != complete});
        expect_same(floats, batches.floats.run(kernel),
                    std::to_string(lanes) + " floats, " + expr.canonical());
        expect_same(doubles, batches.doubles.run(kernel),
                    std::to_string(lanes / 2) + " doubles, " + expr.canonical());
    }
}

class JitOperator : public ::testing::TestWithParam<OpInfo> {};

TEST_P(JitOperator, HasTheInterpretersBits) {
    RandomNumbers random(10 + static_cast<std::uint64_t>(GetParam().op));
    const Batches batches(random, 4096);
    std::vector<int> numbers{0};
    const bool all = is_long_run();
    if (GetParam().notation == Notation::Power)
        numbers = all ? std::vector{2, 3, 4, 5, 6, 7, 8, 9, 16, 17} : std::vector{2, 3, 8, 17};
    if (GetParam().notation == Notation::Wave)
        numbers = all ? std::vector{1, 2, 3, 6, 9, 18} : std::vector{1, 3, 18};
    if (GetParam().notation == Notation::Root)
        numbers = all ? std::vector{3, 5, 7, 9, 17} : std::vector{3, 9};
    for (const int n : numbers) {
        expect_same_bits(operator_on_variables(GetParam(), n), batches);
    }
}

INSTANTIATE_TEST_SUITE_P(All, JitOperator, ::testing::ValuesIn(operators()),
                         [](const auto& row) { return op_name(row); });

TEST(Jit, HasTheInterpretersBitsOnRandomFormulas) {
    RandomNumbers random(11);
    const int count = formulas_to_try(12);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        const Batches batches(random, 128);
        expect_same_bits(random_expression(random, 1 + i % 6), batches);
    }
}

TEST(Jit, HasTheInterpretersBitsOnFormulasWithConstants) {
    RandomNumbers random(12);
    const Batches batches(random, 256);
    for (const char* const text : {"0.7*x + 0.3*y - 0.1",
                                   "x*(-0.7) + 2.3e-30",
                                   "x/0.3",
                                   "0.7^3*x",
                                   "x - 16777217",
                                   "x*16777217",
                                   "x*1e40 + 1e-60*y",
                                   "x^0.3 + w",
                                   "sqrt(2)*x",
                                   "x*sin(2)",
                                   "x*sqrt(-1)",
                                   "x + 1/0",
                                   "if(x > 0, ln(y), 1/0)",
                                   "if(1 > 0, x, sqrt(-1))",
                                   "mod(x, 0.1)",
                                   "mod(x, 0)",
                                   "mod(x, 2)",
                                   "x*tan(1) + asinh(1e30)",
                                   "0.1",
                                   "0*x",
                                   "x^1000 - x^-3",
                                   "min(x, 0.7, y)",
                                   "-(-x) + 0"}) {
        expect_same_bits(parsed(text), batches);
    }
}

TEST(Jit, HasTheInterpretersBitsOnNoiseAndBlobs) {
    RandomNumbers random(16);
    const Batches batches(random, 256);
    for (const char* const text :
         {"noise(x, y, z)", "noise(3x + w, y, z, 7) - 0.1", "value_noise(x, y, z)*y",
          "cellular(2x, y, z)", "cellular2(x, y, z, 3) - cellular(x, y, z, 3)",
          "fbm(x, y, z, 3) + z", "turbulence(x, y, z, 2)", "noise(1/x, sqrt(y), z)",
          "blobs([(0, 0, 0, 1), (1, 1, 0, 0.7), (-1, 0.5, 1, -0.6)]) - 1",
          "metaballs(x + y, y, z, [(0, 0, 0, 1), (1, 1, 0, 0.7), (3, 0, 0, 0.1)]) - 1",
          "blinn([(0, 0, 0, 1), (1, 1, 0, 0.7), (30, 0, 0, 0.1)]) - 1"}) {
        SCOPED_TRACE(text);
        expect_same_bits(parsed(text), batches);
    }
}

TEST(Jit, HasTheInterpretersBitsOnTheGallery) {
    RandomNumbers random(13);
    const Batches batches(random, 64);
    const int step = is_long_run() ? 1 : 15;
    int count = 0;
    const std::filesystem::path folder(ZEROSET_SOURCE_DIR "/resources/gallery");
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ifstream file(entry.path());
        const nlohmann::json gallery = nlohmann::json::parse(file);
        for (const auto& item : gallery.at("items")) {
            SCOPED_TRACE(item.at("name"));
            const auto equation = item.at("equation").get<std::string>();
            if (equation.contains("volume(")) continue;  // no files are read here
            if (++count % step != 0) continue;
            const auto program = read_program(equation);
            ASSERT_TRUE(program.has_value()) << program.error().reason;
            for (const Expr& surface : program->surfaces)
                expect_same_bits(surface, batches);
        }
    }
    EXPECT_GT(count, 80);
}

TEST(Jit, ReadsW) {
    RandomNumbers random(14);
    KernelBatch batch(random, 64);
    const Expr expr = parsed("sin(w)*x + w^2*y - sqrt(w + 5)/z");
    const Kernel kernel = compiled(expr, 0);
    EXPECT_TRUE(kernel.uses_w);
    EXPECT_FALSE(compiled(parsed("x"), 0).uses_w);
    const Bits before = batch.run(kernel);
    for (const double w : {-3.0, 0.0, 0.1, 2.5}) {
        batch.uniforms.set(0, w);
        const Bits expected = batch.run(interpret(expr));
        EXPECT_EQ(expected, batch.run(kernel)) << w;
        EXPECT_NE(before, expected) << w;
    }
}

TEST(Jit, AnswersForASmallestBatchOnly) {
    RandomNumbers random(15);
    const Batches batches(random, batch_multiple);
    expect_same_bits(parsed("x^2 + y^2 + z^2 - 1"), batches);
}

/// Length and AngleSin begin with the same square root and quotient; the code has them once.
TEST(Jit, EmitsWhatOperatorsShareOnce) {
    ExprBuilder builder;
    const NodeId y = builder.variable(1);
    const NodeId x = builder.variable(0);
    const Expr expr = builder.finish(builder.apply(Op::Add, builder.apply(Op::Length, y, x),
                                                   builder.apply(Op::AngleSin, y, x, 0, 3)));
    const auto ir = jit::ir(expr, {.lanes = 4});
    ASSERT_TRUE(ir.has_value());
    const std::size_t begin = ir->find("define void @zeroset_value");
    ASSERT_NE(begin, std::string::npos);
    const std::string value = ir->substr(begin, ir->find("\ndefine", begin) - begin);
    const auto count = [&](const std::string& operation) {
        int found = 0;
        for (std::size_t at = 0;
             (at = value.find("= call <4 x float> @llvm.experimental." + operation, at)) !=
             std::string::npos;
             ++at) {
            ++found;
        }
        return found;
    };
    EXPECT_EQ(count("constrained.sqrt"), 1);
    EXPECT_EQ(count("constrained.fdiv"), 1);
}

TEST(Jit, PrintsItsFunctions) {
    const Expr expr = parsed("x^2 + sin(y)");
    for (const int lanes : machine_lanes()) {
        const auto ir = jit::ir(expr, {.lanes = lanes});
        const auto assembly = jit::assembly(expr, {.lanes = lanes});
        ASSERT_TRUE(ir.has_value());
        ASSERT_TRUE(assembly.has_value());
        for (const char* const name : {"zeroset_range", "zeroset_value", "zeroset_form"}) {
            EXPECT_TRUE(ir->contains(name)) << lanes;
            EXPECT_TRUE(assembly->contains(name)) << lanes;
        }
        EXPECT_TRUE(ir->contains("<" + std::to_string(lanes) + " x float>"));
        EXPECT_FALSE(ir->contains(" x double>"));
        const auto both = jit::ir(expr, {.lanes = lanes, .with_double = true});
        ASSERT_TRUE(both.has_value());
        EXPECT_TRUE(both->starts_with(*ir));
        EXPECT_TRUE(both->contains("<" + std::to_string(lanes / 2) + " x double>"));
    }
}

TEST(Jit, CompilesADeepFormula) {
    std::string text = "x";
    for (int i = 0; i < 900; ++i)
        text = "(" + text + "+y)";
    RandomNumbers random(18);
    const Batches batches(random, 16);
    expect_same_bits(parsed(text), batches);
}

TEST(Jit, PointsAreTheInterpretersToTheBit) {
    RandomNumbers random(11);
    for (int i = 0; i < 20; ++i) {
        const Expr expr = random_expression(random, 4);
        const auto compiled_points = jit::compile_points(expr);
        ASSERT_TRUE(compiled_points.has_value()) << compiled_points.error().message;
        std::array<std::array<double, batch_multiple>, 3> x{};
        for (auto& column : x) {
            for (double& item : column)
                item = random.uniform(-3.0, 3.0);
        }
        Uniforms uniforms;
        uniforms.set(0, 0.5);
        std::array<double, batch_multiple> found{};
        std::array<double, batch_multiple> expected{};
        ValueBatchOf<double> batch{batch_multiple,
                                   {x[0].data(), x[1].data(), x[2].data()},
                                   uniforms.points<double>(),
                                   found.data(),
                                   {}};
        const UpwardRounding upward;
        (*compiled_points)(batch);
        batch.f = expected.data();
        interpret_points(expr)(batch);
        for (std::size_t k = 0; k < batch_multiple; ++k) {
            const bool both_none = found.at(k) != found.at(k) && expected.at(k) != expected.at(k);
            EXPECT_TRUE(both_none || found.at(k) == expected.at(k)) << expr.canonical();
        }
    }
}

}  // namespace
}  // namespace zeroset::test::jit_test
