#include "app/code_choice.hpp"

#include "engine/trace/tracer.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zeroset::test {
namespace {

bool pays(const std::string& text, int size, int threads) {
    const Box clip = Box::cube(2.0);
    const auto formula = interpreted_formula(text, clip);
    EXPECT_TRUE(formula.has_value()) << text;
    if (!formula) return false;
    TraceSettings settings;
    settings.threads = threads;
    const RenderRequest picture{make_scene(*formula, clip, 0.0, {}), default_camera(clip), settings,
                                size, size};
    return machine_code_pays(picture, *formula, nullptr);
}

/// Octics, one for each k.
std::string octics(int count) {
    std::string text;
    for (int k = 1; k <= count; ++k) {
        text += "(x^2 + " + std::to_string(k) + "*y^2)^4 + sin(" + std::to_string(k) +
                "*x*z)*z^6 - (x*y + z)^2*(y*z + " + std::to_string(k) + ")^3 + x^5*y - 1;";
    }
    return text;
}

TEST(CodeChoice, InterpretsASmallPictureOfASimpleFormula) {
    EXPECT_FALSE(pays("x^2 + y^2 + z^2 = 1", 256, 0));
    EXPECT_FALSE(pays("x = y; x = z; y = z", 64, 0));
    EXPECT_FALSE(pays("x^2 + y^2 + z^2 = 100", 2048, 0)) << "nothing is in the box";
}

TEST(CodeChoice, CompilesForMuchWork) {
    EXPECT_TRUE(pays("x^2 + y^2 + z^2 = 1", 4096, 0));
    EXPECT_TRUE(pays(octics(1), 1024, 0));
    EXPECT_TRUE(pays(octics(3), 1024, 0));
}

TEST(CodeChoice, IsTheSameForAnyNumberOfThreads) {
    for (const int size : {64, 128, 256, 384, 512, 768}) {
        const bool one = pays(octics(1), size, 1);
        EXPECT_EQ(one, pays(octics(1), size, 2)) << size;
        EXPECT_EQ(one, pays(octics(1), size, 4)) << size;
    }
}

TEST(CodeChoice, MakesQuickerCodeForLargePictures) {
    EXPECT_EQ(use_in_one_picture(256, 256), CodeUse::OnePicture);
    EXPECT_EQ(use_in_one_picture(1920, 1080), CodeUse::Pictures);
}

}  // namespace
}  // namespace zeroset::test
