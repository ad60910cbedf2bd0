#include "engine/language/parse.hpp"

#include <gtest/gtest.h>

namespace zeroset::fourth_coordinate_test {
namespace {

bool calls_w_t(const char* text) {
    const auto program = read_program(text);
    EXPECT_TRUE(program) << text;
    return program && program->calls_w_t;
}

TEST(FourthCoordinate, IsCalledAsItIsTyped) {
    EXPECT_TRUE(calls_w_t("x^2 + y^2 + z^2 = t"));
    EXPECT_TRUE(calls_w_t("z = 2xt"));
    EXPECT_FALSE(calls_w_t("x^2 + y^2 + z^2 = w"));
    EXPECT_FALSE(calls_w_t("x t + w = 1")) << "one name for both";
    EXPECT_FALSE(calls_w_t("x^2 + y^2 + z^2 = 1"));
    EXPECT_FALSE(calls_w_t("f(t) = t^2; f(x) + y = z")) << "t is an argument";
    EXPECT_FALSE(calls_w_t("t = 2; x + y = t")) << "t is a constant";
    EXPECT_FALSE(calls_w_t("t = 2; x + y = t + w")) << "t is a constant";
    EXPECT_TRUE(calls_w_t("w = 2; x + y = w + t")) << "w is a constant";
}

}  // namespace
}  // namespace zeroset::fourth_coordinate_test
