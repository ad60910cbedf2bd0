#include "app/cli/options/light_options.hpp"

#include "app/cli/options/look_options.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// Tests of the texts behind --look, --light, --contours and the like.

namespace zeroset::test::light_options_test {
namespace {

TEST(LightOptions, SetWhatTheyName) {
    LightChoice light;
    ASSERT_FALSE(
        take_light({.look = "metal",
                    .reflections = "3",
                    .absorption = "0.5",
                    .tone = "filmic",
                    .background = "#FFFFFF,#102030",
                    .lights = {"1,2,3", "camera -1,0,0.5; power 2; size 10; color #FF0000"}},
                   light));
    EXPECT_EQ(light.look, Look::Metal);
    EXPECT_EQ(light.reflections, 3);
    EXPECT_EQ(light.absorption, 0.5);
    EXPECT_EQ(light.tone, Tone::Filmic);
    EXPECT_EQ(light.background, (Background{.top = 0xFFFFFF, .bottom = 0x102030}));
    ASSERT_EQ(light.lights.size(), 2U);
    EXPECT_EQ(light.lights[0], (Light{.towards = {1, 2, 3}, .with_camera = false}));
    EXPECT_EQ(light.lights[1], (Light{.towards = {-1, 0, 0.5},
                                      .color = {1.0F, 0.0F, 0.0F},
                                      .power = 2.0,
                                      .radius_deg = 5.0}));
    ASSERT_FALSE(take_light({.background = "default"}, light));
    EXPECT_FALSE(light.background);
}

TEST(LightOptions, ThatAreWrongSayWhatToType) {
    const std::vector<std::pair<LightText, std::string>> wrong{
        {{.look = "gold"},
         "--look gold: type standard, phong, matte, porcelain, metal, glass, clay or "
         "technical; --surface-look 2:metal is for one surface"},
        {{.reflections = "6"}, "--reflections"},
        {{.reflections = "many"}, "--reflections"},
        {{.absorption = "-1"}, "--absorption -1: type a number from 0 to 1e6"},
        {{.tone = "loud"}, "--tone loud: type plain or filmic"},
        {{.background = "white"}, "--background white: type #RRGGBB"},
        {{.background = "#FFFFFF,#000000,#000000"}, "--background #FFFFFF,#000000,#000000: type"},
        {{.lights = {"1,2"}}, "--light 1,2: type X,Y,Z"},
        {{.lights = {"0,0,0"}}, "--light 0,0,0: type X,Y,Z"},
        {{.lights = {"1,2,3; power -1"}}, "--light 1,2,3; power -1: type"},
        {{.lights = {"1,2,3; colour red"}}, "--light 1,2,3; colour red: type"},
        {{.lights = {"1,0,0", "1,0,0", "1,0,0", "1,0,0", "1,0,0"}},
         "--light: there are at most 4"}};
    for (const auto& [text, reason] : wrong) {
        LightChoice light;
        const auto error = take_light(text, light);
        ASSERT_TRUE(error) << reason;
        EXPECT_TRUE(error->reason.starts_with(reason)) << error->reason;
    }
}

TEST(ContourOptions, AreANameOrAnExpressionWithStepAndWidth) {
    LineChoice lines;
    ASSERT_FALSE(read_contours("height; step 0.5; width 3", lines));
    EXPECT_EQ(lines, (LineChoice{.contours = Contours::Height, .step = 0.5, .width = 3.0}));
    ASSERT_FALSE(read_contours("height; labels; step 2", lines));
    EXPECT_TRUE(lines.labels);
    ASSERT_FALSE(read_contours("xyz", lines));
    EXPECT_FALSE(lines.labels);
    EXPECT_EQ(lines.contours, Contours::Coordinates);
    EXPECT_FALSE(lines.step);
    ASSERT_FALSE(read_contours("x^2 + y;step=2", lines));
    EXPECT_EQ(lines.contours, Contours::Expression);
    EXPECT_EQ(lines.expression, "x^2 + y");
    EXPECT_EQ(lines.step, 2.0);
    for (const char* const text : {"z;step 0", "z;step", "z;width 100", "z;2"}) {
        const auto error = read_contours(text, lines);
        ASSERT_TRUE(error) << text;
        EXPECT_TRUE(error->reason.starts_with(std::string("--contours ") + text)) << error->reason;
    }
}

}  // namespace
}  // namespace zeroset::test::light_options_test
