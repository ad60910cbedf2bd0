// Texts of other programs: what readings/commands.txt cannot say of them.

#include "engine/language/dialects/dialects.hpp"

#include "engine/language/parse.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace zeroset::dialects_test {
namespace {

TEST(Dialects, LeaveTextsOfTheLanguageAlone) {
    for (const std::string_view text :
         {"x^2 + y^2 + z^2 = 1", "z = x.^2 + Sin[y]", "f(x, y) = x y; z = f(x, y)",
          "var = 2; x = var", "float f(vec3 p) { return length(p) - 1.; }",
          "#declare f = function(x, y) { x*y }; f(x, z)", "show = 3; x = show", "z = x if(y)",
          "x = 5 % 3", "(u, v, u v), 0 < u < 1, 0 < v < 1", ""}) {
        const auto read = read_dialects(text);
        ASSERT_TRUE(read);
        EXPECT_FALSE(*read) << text;
    }
}

TEST(Dialects, RangesAreTheBox) {
    const auto program =
        read_program("a = 3\nContourPlot3D[x^2 + y^2 == z, {x, -Pi, a}, {y, -1, 2}, {z, 0, 1}]");
    ASSERT_TRUE(program);
    const auto& box = program->box;
    ASSERT_TRUE(box[0] && box[1] && box[2]);
    EXPECT_NEAR(box[0]->front(), -3.14159265358979, 1e-12);
    EXPECT_EQ(box[0]->back(), 3.0);
    EXPECT_EQ(*box[1], (std::array{-1.0, 2.0}));
    EXPECT_EQ(*box[2], (std::array{0.0, 1.0}));
}

TEST(Dialects, RangesThatAreNoneAreTold) {
    const auto program =
        read_program("x = 1\nContourPlot3D[y == z, {x, 2, 1}, {y, 0, 1}, {z, 0, 1}]");
    ASSERT_FALSE(program);
    EXPECT_EQ(program.error().offset, 6U);
    EXPECT_TRUE(program.error().reason.contains("lower one first"));
}

TEST(Dialects, StatementsBeginWhereTheirCommandDoes) {
    const std::string_view text =
        "with(plots):\np := implicitplot3d([x = 1, y = 2], x=-3..3, y=-3..3, z=-3..3):\nz = 3";
    const auto program = read_program(text);
    ASSERT_TRUE(program);
    ASSERT_EQ(program->readings.size(), 3U);
    EXPECT_EQ(program->readings[0].offset, text.find("p :="));
    EXPECT_EQ(program->readings[1].offset, text.find("p :="));
    EXPECT_EQ(program->readings[2].offset, text.find("z = 3"));
}

TEST(Dialects, ErrorsAreWhereTheyWereTyped) {
    const std::string_view text =
        "def f(x, y, z):\n    r = x**2\n    return r + foo(y)\nf(x, y, z) = 0";
    const auto program = read_program(text);
    ASSERT_FALSE(program);
    EXPECT_EQ(program.error().offset, text.find("foo"));
}

TEST(Dialects, ExpressionsMayUseWhatSuchATextDefines) {
    const std::string text = "def f(x, y):\n    r = x*y\n    return r + 1\nz = f(x, y)";
    const auto value = read_value("f(2, x) + ", text, {});
    ASSERT_FALSE(value);
    EXPECT_EQ(value.error().offset, 10U);
    const auto whole = read_value("f(2, x)", text, {});
    EXPECT_TRUE(whole) << whole.error().reason;
}

}  // namespace
}  // namespace zeroset::dialects_test
