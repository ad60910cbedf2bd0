#include "engine/taylor/patch_models.hpp"

#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "engine/taylor/series.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

// Models enclose functions of two variables, against closed forms in long double; what they do not
// know they say.

namespace zeroset::test::patch_models_test {
namespace {

using Wide = long double;
constexpr double unbounded = std::numeric_limits<double>::infinity();

Uniforms one_parameter(double lo, double hi) {
    Uniforms uniforms;
    uniforms.set(0, 0.0);
    uniforms.set(1, lo, hi);
    return uniforms;
}

Expr graph(const std::string& text) {
    const auto read = parse(text);
    if (!read) {
        ADD_FAILURE() << text << ": " << read.error().reason;
        return {};
    }
    return *read;
}

std::shared_ptr<const PatchModeler> modeler_of(const std::string& text) {
    return patch_modeler({graph(text), graph("x"), graph("y")});
}

PatchModel model_of(const std::string& text, const UvBox& box,
                    const Uniforms& uniforms = one_parameter(1.0, 1.0)) {
    const auto modeler = modeler_of(text);
    if (modeler == nullptr) {
        ADD_FAILURE() << text << " has no model";
        return {};
    }
    const UpwardRounding upward;
    std::array<PatchModel, 1> models;
    modeler->make_models(std::array{box}, uniforms, models);
    return models[0];
}

Wide polynomial_at(const PatchModel& model, std::size_t k, Wide p, Wide q) {
    Wide sum = 0;
    for (std::size_t i = 0; i < patch_terms; ++i)
        sum += Wide{model.terms[k][i]} * std::pow(p, Wide(patch_powers[i].p)) *
               std::pow(q, Wide(patch_powers[i].q));
    return sum;
}

struct ModelCase {
    std::string text;
    std::function<Wide(Wide x, Wide y)> value;
};

std::vector<ModelCase> cases() {
    return {
        {"x*y - 3*x + y^3", [](Wide x, Wide y) { return x * y - 3 * x + y * y * y; }},
        {"x^7 - y^6", [](Wide x, Wide y) { return std::pow(x, Wide{7}) - std::pow(y, Wide{6}); }},
        {"sin(5*x + y)*cos(y)", [](Wide x, Wide y) { return std::sin(5 * x + y) * std::cos(y); }},
        {"exp(2*x - y)", [](Wide x, Wide y) { return std::exp(2 * x - y); }},
        {"ln(2 + x*y)", [](Wide x, Wide y) { return std::log(2 + x * y); }},
        {"log10(x + 3)*log2(y + 4)",
         [](Wide x, Wide y) { return std::log10(x + 3) * std::log2(y + 4); }},
        {"sqrt(x + y + 3)", [](Wide x, Wide y) { return std::sqrt(x + y + 3); }},
        {"x/(y + 3)", [](Wide x, Wide y) { return x / (y + 3); }},
        {"1/(x - 4)", [](Wide x, Wide) { return 1 / (x - 4); }},
        {"tan(x/2) + cot(y + 2)",
         [](Wide x, Wide y) { return std::tan(x / 2) + 1 / std::tan(y + 2); }},
        {"atan(3*x) - atan(y*x)",
         [](Wide x, Wide y) { return std::atan(3 * x) - std::atan(y * x); }},
        {"sinh(x)*cosh(2*y)", [](Wide x, Wide y) { return std::sinh(x) * std::cosh(2 * y); }},
        {"tanh(x + y)", [](Wide x, Wide y) { return std::tanh(x + y); }},
        {"abs(x)*y", [](Wide x, Wide y) { return std::abs(x) * y; }},
        {"max(x, y) + min(x, 2*y)",
         [](Wide x, Wide y) { return std::max(x, y) + std::min(x, 2 * y); }},
        {"sqrt((x + 2)^2 + (y - 3)^2)",
         [](Wide x, Wide y) { return std::sqrt((x + 2) * (x + 2) + (y - 3) * (y - 3)); }},
        {"0.1*x + y/3", [](Wide x, Wide y) { return x / 10 + y / 3; }},
    };
}

class PatchModels : public testing::TestWithParam<ModelCase> {};

TEST_P(PatchModels, EncloseTheFunction) {
    const ModelCase& c = GetParam();
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    int known = 0;
    for (int round = 0; round < 60; ++round) {
        const UvBox box{.u = place(random),
                        .v = place(random),
                        .u_radius = std::exp2(-round / 4.0),
                        .v_radius = std::exp2(-round / 3.0)};
        const PatchModel model = model_of(c.text, box);
        if (!model.known()) continue;
        ++known;
        for (int sample = 0; sample < 24; ++sample) {
            const Wide p = sample == 0 ? 1.0 : place(random);
            const Wide q = sample < 2 ? -1.0 : place(random);
            const Wide expected = c.value(box.u + p * box.u_radius, box.v + q * box.v_radius);
            const Wide found = polynomial_at(model, 0, p, q);
            EXPECT_LE(std::abs(found - expected), model.error[0] + 0x1p-60 * std::abs(expected))
                << box.u << ", " << box.v << ", " << box.u_radius;
        }
    }
    EXPECT_GT(known, 30);
}

INSTANTIATE_TEST_SUITE_P(Functions, PatchModels, testing::ValuesIn(cases()),
                         [](const auto& made) { return "f" + std::to_string(made.index); });

TEST(PatchModels, AreNarrowInSmallBoxes) {
    const auto error_at = [](double radius) {
        return model_of("sin(3*x)*exp(y)/(2 + x)", {0.3, 0.2, radius, radius}).error[0];
    };
    // By the fifth power of the radius, down to rounding.
    EXPECT_LT(error_at(0x1p-5), error_at(0x1p-3) / 700.0);
    EXPECT_LT(error_at(0x1p-5), 1e-6);
    EXPECT_LT(error_at(0x1p-12), 1e-13);
    EXPECT_GT(error_at(0x1p-12), 0.0);
}

TEST(PatchModels, EncloseAllValuesOfAParameter) {
    const UvBox box{0.5, 0.5, 0x1p-4, 0x1p-4};
    const PatchModel model = model_of("a*sin(x) + cos(a*y)", box, one_parameter(0.9, 1.1));
    for (const Wide a : {0.9L, 1.0L, 1.1L}) {
        for (const Wide p : {-1.0L, 0.0L, 1.0L}) {
            const Wide expected = a * std::sin(0.5L + p / 16) + std::cos(a * (0.5L - p / 16));
            EXPECT_LE(std::abs(polynomial_at(model, 0, p, -p) - expected), model.error[0]);
        }
    }
    EXPECT_LT(model.error[0], 0.5);
}

TEST(PatchModels, KnowNothingWhereAFunctionIsNotSmooth) {
    const UvBox about_0{0.0, 0.5, 0.25, 0.25};
    for (const std::string text :
         {"1/x", "sqrt(x)", "ln(x)", "abs(x)", "max(x, 0)", "cot(x)", "sqrt(x - 3)", "x/(x - x)"})
        EXPECT_EQ(model_of(text, about_0).error[0], unbounded) << text;
    // The others are known all the same.
    EXPECT_LT(model_of("1/x", about_0).error[1], 1e-15);
    EXPECT_FALSE(model_of("1/x", about_0).known());
}

TEST(PatchModels, DoNotOverflowUnseen) {
    const UvBox far{700.0, 0.0, 50.0, 1.0};
    EXPECT_EQ(model_of("exp(x)*exp(x)", far).error[0], unbounded);
    EXPECT_EQ(model_of("sin(exp(x))", far).error[0], unbounded);
}

TEST(PatchModels, AreNotMadeOfStepsAndConditions) {
    EXPECT_EQ(modeler_of("floor(4*x)"), nullptr);
    EXPECT_EQ(modeler_of("if(x < y, x, y)"), nullptr);
    EXPECT_NE(modeler_of("x + floor(2.5)"), nullptr);
}

}  // namespace
}  // namespace zeroset::test::patch_models_test
