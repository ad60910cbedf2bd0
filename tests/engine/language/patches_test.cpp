#include "engine/expr/patch_graph.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

// Rows that are given by a point: parametric surfaces, curves and points.

namespace zeroset::test::patches_test {
namespace {

constexpr double pi = std::numbers::pi;

Program program_of(const std::string& text) {
    auto program = read_program(text);
    if (!program) {
        ADD_FAILURE() << text << ": " << program.error().reason;
        return {};
    }
    return std::move(*program);
}

/// The point of a program's first row at (x, y) of the unit square.
std::array<double, 3> at(const Program& program, double x, double y, double w = 0.0) {
    std::array<double, 3> point{};
    const auto patch = program.surfaces.empty() ? std::nullopt : patch_of(program.surfaces.front());
    if (!patch) {
        ADD_FAILURE() << "no point";
        return point;
    }
    for (std::size_t i = 0; i < 3; ++i)
        point.at(i) = value_at(patch->point.at(i), {x, y, 0.0, w}).value;
    return point;
}

void expect_near(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(a.at(i), b.at(i), 1e-12) << i;
}

std::string error_of(const std::string& text) {
    const auto program = read_program(text);
    return program ? "" : program.error().reason + ": " + program.error().hint;
}

TEST(Patches, ReadsASurface) {
    const Program program = program_of("(u cos v, u sin v, v), 0 < u < 1, 0 < v < 2 pi");
    ASSERT_EQ(program.surfaces.size(), 1U);
    EXPECT_TRUE(program.parameters.empty());
    EXPECT_EQ(patch_of(program.surfaces.front())->kind, PatchKind::Surface);
    expect_near(at(program, 0.5, 0.25), {0.0, 0.5, 0.5 * pi});
    expect_near(at(program, 1.0, 1.0), {1.0, 0.0, 2.0 * pi});
    EXPECT_EQ(program.readings.front().text, "(u*cos(v), u*sin(v), v), 0 < u < 1, 0 < v < 2*pi");
}

TEST(Patches, ReadsRangesThatDescendAndDependOnEachOther) {
    expect_near(at(program_of("(u, v, 0), 3 > u > 1, u <= v <= 2u"), 0.5, 0.5), {2.0, 3.0, 0.0});
    expect_near(at(program_of("(u, v, 0), 0 < u < 1 and -1 < v < 1"), 0.5, 0.75), {0.5, 0.5, 0.0});
}

TEST(Patches, KeepsOtherLettersAsParameters) {
    const Program program = program_of("(a u, b, w + v), 0 < u < 1, 0 < v < a");
    EXPECT_EQ(program.parameters, (std::vector<std::string>{"a", "b"}));
    EXPECT_TRUE(program.surfaces.front().uses_variable(variable_w));
}

TEST(Patches, ReadsACurveInT) {
    const Program program = program_of("(cos t, sin t, t/3), 0 < t < 20");
    EXPECT_EQ(patch_of(program.surfaces.front())->kind, PatchKind::Curve);
    EXPECT_FALSE(program.surfaces.front().uses_variable(variable_w));
    expect_near(at(program, 0.5, 0.0), {std::cos(10.0), std::sin(10.0), 10.0 / 3.0});
}

TEST(Patches, ReadsAPoint) {
    const Program program = program_of("(1, 2, a)");
    EXPECT_EQ(patch_of(program.surfaces.front())->kind, PatchKind::Point);
    EXPECT_EQ(program.parameters, (std::vector<std::string>{"a"}));
}

TEST(Patches, CallsFunctionsWithItsVariables) {
    expect_near(at(program_of("f(a) = a^2; (f(u), u, v), 0 < u < 2, 0 < v < 1"), 0.75, 0.5),
                {2.25, 1.5, 0.5});
}

TEST(Patches, GivesItsVariablesToDefinitions) {
    const Program program =
        program_of("r = 2 + cos v; (r cos u, r sin u, sin v), 0 < u < 2 pi, 0 < v < 2 pi");
    ASSERT_EQ(program.surfaces.size(), 1U);
    EXPECT_TRUE(program.parameters.empty());
    EXPECT_EQ(program.readings.front().text, "r = 2 + cos(v)");
    expect_near(at(program, 0.25, 0.5), {0.0, 1.0, 0.0});
    expect_near(at(program, 0.5, 0.0), {-3.0, 0.0, 0.0});
}

TEST(Patches, GivesItsVariablesToDefinitionsOfDefinitions) {
    const Program torus = program_of(
        "X = s cos u; s = 2 + c; c = cos v; Y = s sin u; Z = a sin v; (X, Y, Z), 0 < u < 2 pi, "
        "0 < v < 2 pi");
    ASSERT_EQ(torus.surfaces.size(), 1U);
    EXPECT_EQ(torus.parameters, std::vector<std::string>{"a"});
    expect_near(at(torus, 0.25, 0.5), {0.0, 1.0, 0.0});
    const Program point = program_of("P = (cos t, sin t, t); P + (0, 0, 1), 0 < t < 2 pi");
    ASSERT_EQ(point.surfaces.size(), 1U);
    expect_near(at(point, 0.5, 0.0), {-1.0, 0.0, pi + 1.0});
    const Program function =
        program_of("f(s) = s v; h = v^2; (f(u), f(1), h), 0 < u < 1, 0 < v < 2; (0, 0, h), 0<v<1");
    EXPECT_TRUE(function.parameters.empty());
    EXPECT_EQ(function.readings.front().text, "f(s) = s*v");
    expect_near(at(function, 0.5, 0.5), {0.5, 1.0, 1.0});
}

TEST(Patches, LeavesDefinitionsOfOtherRowsTheirSliders) {
    const Program program = program_of("h = v^2; (u, v, h), 0 < u < 1, 0 < v < 2; z = h x");
    EXPECT_EQ(program.parameters, std::vector<std::string>{"v"});
    expect_near(at(program, 0.5, 0.5), {0.5, 1.0, 1.0});
}

TEST(Patches, GivesRangesTheVariablesBeforeThem) {
    const Program program = program_of("h = u^2; (u, v, 0), 0 < u < 2, 0 < v < h");
    expect_near(at(program, 0.5, 0.5), {1.0, 0.5, 0.0});
    EXPECT_EQ(program.readings.back().text, "(u, v, 0), 0 < u < 2, 0 < v < u^2");
    EXPECT_NE(error_of("h = v^2; (u, v, 0), 0 < u < h, 0 < v < 1").find("the range of u goes by v"),
              std::string::npos);
}

TEST(Patches, ReadsANamedPoint) {
    const Program program = program_of("r(u,v) = (u cos v, u sin v, v), 0<=u<=1, 0<=v<=2pi");
    ASSERT_EQ(program.surfaces.size(), 1U);
    EXPECT_TRUE(program.parameters.empty());
    EXPECT_EQ(patch_of(program.surfaces.front())->kind, PatchKind::Surface);
    expect_near(at(program, 0.5, 0.25), {0.0, 0.5, 0.5 * pi});
    const Program curves = program_of(
        "r(t) = (cos t, sin t, t), 0 < t < 6; C = (0, 0, t), 0 < t < 1; g(t) = (1, t, 0); "
        "g(t), 0 < t < 3");
    ASSERT_EQ(curves.surfaces.size(), 3U);
    EXPECT_EQ(patch_of(curves.surfaces.front())->kind, PatchKind::Curve);
    expect_near(at(curves, 0.5, 0.0), {std::cos(3.0), std::sin(3.0), 3.0});
    EXPECT_NE(error_of("f(u, v) = (u, v, 0), 0 < u < 1").find("v has no range"), std::string::npos);
}

TEST(Patches, LeavesEquationsAlone) {
    const Program program = program_of("x^2 + y^2 - 1, 0 < r < 2; (1, 2, 3)");
    ASSERT_EQ(program.surfaces.size(), 2U);
    EXPECT_FALSE(is_patch(program.surfaces.front()));
    EXPECT_TRUE(is_patch(program.surfaces.back()));
}

TEST(Patches, SaysWhatIsWrong) {
    EXPECT_NE(error_of("(u cos v, u sin v, v), 0 < u < 1").find("v has no range"),
              std::string::npos);
    EXPECT_NE(error_of("(u, v, x), 0 < u < 1, 0 < v < 1").find("x, y and z"), std::string::npos);
    EXPECT_NE(error_of("(u, v, 0), 1 < u < 0, 0 < v < 1").find("range of u is empty"),
              std::string::npos);
    EXPECT_NE(error_of("(u, v, s), 0 < u < 1, 0 < v < 1, 0 < s < 1").find("two variables"),
              std::string::npos);
    EXPECT_NE(error_of("(u, v, 0), 0 < u < 1, 0 < v < 1, u < v").find("only ranges"),
              std::string::npos);
    EXPECT_NE(error_of("(u, v, 0), 0 < u < 1, 0 < u < 1").find("two ranges"), std::string::npos);
    EXPECT_FALSE(error_of("(u, v), 0 < u < 1, 0 < v < 1").empty());
}

}  // namespace
}  // namespace zeroset::test::patches_test
