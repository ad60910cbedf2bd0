#include "pipeline/code_choice.hpp"

#include "engine/trace/tracer.hpp"
#include "tests/support/formulas.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace zeroset::test::code_choice_test {
namespace {

std::optional<CodeUse> code_for(const std::string& text, int size, int threads = 0) {
    const Box clip = Box::cube(2.0);
    const auto formula = prepared_formula(text, clip, Preparation::Interpreted);
    EXPECT_TRUE(formula.has_value()) << text;
    if (!formula) return std::nullopt;
    TraceSettings settings;
    settings.threads = threads;
    const RenderRequest picture{make_scene(*formula, clip, 0.0, {}), default_camera(clip), settings,
                                size, size};
    return code_for_one(picture, *formula, nullptr);
}

/// Returns `count` surfaces of degree 8, each with a sine.
std::string octics(int count) {
    std::string text;
    for (int k = 1; k <= count; ++k) {
        text += "(x^2 + " + std::to_string(k) + "*y^2)^4 + sin(" + std::to_string(k) +
                "*x*z)*z^6 - (x*y + z)^2*(y*z + " + std::to_string(k) + ")^3 + x^5*y - 1;";
    }
    return text;
}

/// Returns the minimum of many spheres, of which only one or two matter in a small cell.
std::string spheres(int count) {
    std::string text = "1";
    for (int k = 0; k < count; ++k) {
        text = "min(" + text + ", (x - " + std::to_string(k % 5) + "/3)^2 + (y - " +
               std::to_string(k / 5) + "/9)^2 + (z - " + std::to_string(k % 3) + "/2)^2 - 0.003)";
    }
    return text;
}

/// Returns a function with many folds, all of which matter everywhere.
std::string folds(int count) {
    std::string text = "x + y*z";
    for (int k = 1; k <= count; ++k) {
        const std::string factor = std::to_string(k);
        text += " + max(sin(" + factor + "*x), cos(" + factor + "*y*z))/" + factor;
    }
    return text;
}

TEST(CodeChoice, InterpretsASmallPictureOfASimpleFormula) {
    EXPECT_EQ(code_for("x^2 + y^2 + z^2 = 1", 256), std::nullopt);
    EXPECT_EQ(code_for("x = y; x = z; y = z", 64), std::nullopt);
    EXPECT_EQ(code_for("x^2 + y^2 + z^2 = 100", 2048), std::nullopt) << "nothing is in the box";
}

TEST(CodeChoice, CompilesForMuchWork) {
    EXPECT_EQ(code_for("x^2 + y^2 + z^2 = 1", 4096), CodeUse::Pictures);
    EXPECT_EQ(code_for(octics(1), 512), CodeUse::OnePicture);
    EXPECT_EQ(code_for(octics(1), 1024), CodeUse::Pictures);
    EXPECT_EQ(code_for(octics(3), 1024), CodeUse::Pictures);
}

TEST(CodeChoice, CompilesThePartsWhereMuchIsLeftOut) {
    const auto formula = prepared_formula(spheres(100), Box::cube(2.0), Preparation::Interpreted);
    ASSERT_TRUE(formula.has_value());
    EXPECT_TRUE(has_many_choices(*formula));
    EXPECT_TRUE(is_made_of_parts(*formula));
    EXPECT_EQ(code_for(spheres(100), 256), CodeUse::OnePicture);
    EXPECT_EQ(code_for(spheres(100), 1024), CodeUse::OnePicture);
}

TEST(CodeChoice, CompilesAllOfWhatTakesLongByParts) {
    const auto formula = prepared_formula(folds(30), Box::cube(2.0), Preparation::Interpreted);
    ASSERT_TRUE(formula.has_value());
    EXPECT_TRUE(has_many_choices(*formula));
    EXPECT_FALSE(is_made_of_parts(*formula));
    EXPECT_EQ(code_for(folds(30), 32), std::nullopt);
    EXPECT_EQ(code_for(folds(30), 96), CodeUse::OnePicture);
    EXPECT_EQ(code_for(folds(30), 512), CodeUse::LongPicture);
}

TEST(CodeChoice, IsTheSameForAnyNumberOfThreads) {
    for (const int size : {64, 128, 256, 384, 512, 768}) {
        const auto one = code_for(octics(1), size, 1);
        EXPECT_EQ(one, code_for(octics(1), size, 2)) << size;
        EXPECT_EQ(one, code_for(octics(1), size, 4)) << size;
    }
}

}  // namespace
}  // namespace zeroset::test::code_choice_test
