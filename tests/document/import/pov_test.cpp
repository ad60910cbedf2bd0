// Tests of reading scenes of POV-Ray: what is placed where, macros, patterns, random numbers.

#include "document/import/import.hpp"
#include "tests/document/import/imported_values.hpp"
#include "tests/document/import/samples.hpp"
#include "tests/support/long_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace zeroset::test::pov_test {
namespace {

TEST(Imports, PovScenePlacesItsSurfaces) {
    const Imported imported = read("scene.pov", pov_scene);
    ASSERT_EQ(imported.documents.size(), 1U);
    const ImportedDocument& scene = imported.documents[0];
    EXPECT_EQ(scene.refusal, "");
    const auto rows = read_rows(scene.document);
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->program->surfaces.size(), 3U);
    // (x, y, z) of POV-Ray is (x, z, y) here. The second cylinder stands at x = 3, with the radius
    // R + threshold, and is closed at y = +-1.
    EXPECT_NEAR(value(scene, 1, 3.75, 0.0, 0.0), 0.0, 1e-12);
    EXPECT_NEAR(value(scene, 1, 3.0, 0.0, 1.0), 0.0, 1e-12);
    EXPECT_NEAR(value(scene, 1, 3.0, 0.0, 2.0), 1.0, 1e-12);
    EXPECT_LT(value(scene, 1, 3.0, 0.0, 0.0), 0.0);
    // The open one: x^2 + z^2 = (mod(-3, 2) + 2)*log(100)/2 = 1 about y, turned to lie along z, at
    // (0, 5, 1): here at z = 5, along y.
    EXPECT_NEAR(value(scene, 2, 1.0, 1.0, 5.0), 0.0, 1e-12);
    EXPECT_NEAR(value(scene, 2, 0.0, 1.5, 6.0), 0.0, 1e-12);
    EXPECT_EQ(scene.document.statements.back().color, 0x0000FF);
    EXPECT_NEAR(scene.document.statements.back().opacity.value_or(1.0), 0.75, 1e-12);
    ASSERT_TRUE(scene.document.camera);
    EXPECT_EQ(scene.document.camera->eye, glm::dvec3(0.0, -10.0, 0.0));
    EXPECT_EQ(scene.document.camera->up, glm::dvec3(0.0, 0.0, 1.0));
    EXPECT_TRUE(has_note(scene, "light_source"));
    EXPECT_TRUE(has_note(scene, "sphere"));
}

TEST(Imports, PovTurnsAxisByAxis) {
    const Imported imported =
        read("a.pov",
             "isosurface { function { x - 2*y + 3*z } open contained_by { sphere { 0, 9 } } "
             "scale <1, 2, 1> rotate <90, 0, 90> translate <1, 0, 0> }");
    const ImportedDocument& plane = imported.documents[0];
    // The object's (1, 2, 1): scaled (1, 4, 1), turned about x (1, -1, 4), about z (1, 1, 4), moved
    // (2, 1, 4), which is (2, 4, 1) here.
    EXPECT_NEAR(value(plane, 0, 2.0, 4.0, 1.0), 1.0 - 4.0 + 3.0, 1e-12);
    // (0, 1, 0): (0, 2, 0), (0, 0, 2), (0, 0, 2), (1, 0, 2): (1, 2, 0) here.
    EXPECT_NEAR(value(plane, 0, 1.0, 2.0, 0.0), -2.0, 1e-12);
    // (1, 0, 0): (1, 0, 0), (0, 1, 0), (1, 1, 0): (1, 0, 1) here.
    EXPECT_NEAR(value(plane, 0, 1.0, 0.0, 1.0), 1.0, 1e-12);
}

double inner_value(std::string_view scene, double x, double y, double z) {
    const Imported imported = read("a.pov", std::string(scene));
    return value(imported.documents[0], 0, x, z, y);
}

TEST(Imports, PovMacrosAreCalled) {
    constexpr std::string_view open = " } open contained_by { sphere { 0, 99 } } }";
    const auto macros = [&](const std::string& definitions, const std::string& formula) {
        return definitions + " isosurface { function { " + formula + std::string(open);
    };
    // In a formula arguments stand as they are written, as one operand.
    EXPECT_NEAR(inner_value(macros("#macro Twice(A) 2*A #end", "Twice(x + 1) - y"), 3, 1, 0), 7.0,
                1e-12);
    // Elsewhere they are values, which end with the call; the macro's own names do, too.
    const std::string square = "#macro Square(A) #local R = A*A; R #end ";
    EXPECT_NEAR(inner_value(macros("#declare R = 5; #declare A = 7;" + square +
                                       "#declare B = Square(R + 1);",
                                   "x + B + R + 100*A"),
                            0, 0, 0),
                36.0 + 5.0 + 700.0, 1e-12);
    // A macro that declares its parameter changes the name that it was given.
    EXPECT_NEAR(inner_value(macros("#macro Add(N) #declare N = N + 1; #end #declare K = 1; Add(K) "
                                   "Add(K)",
                                   "x + K"),
                            0, 0, 0),
                3.0, 1e-12);
    // Macros call others, in loops, with their parameters.
    EXPECT_NEAR(inner_value(macros(square + "#macro Sum(N) #local S = 0; #for (I, 1, N) #local S = "
                                            "S + Square(I); #end S #end #declare T = Sum(4);",
                                   "x + T"),
                            0, 0, 0),
                30.0, 1e-12);
    // Objects are arguments, too.
    const Imported twice = read(
        "a.pov",
        "#macro Pair(Object) union { object { Object } object { Object translate <9, 0, 0> } } "
        "#end Pair(isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 2 } "
        "} })");
    const auto rows = read_rows(twice.documents[0].document);
    ASSERT_TRUE(rows);
    EXPECT_EQ(rows->program->surfaces.size(), 2U);
    EXPECT_NEAR(value(twice.documents[0], 1, 10.0, 0.0, 0.0), 0.0, 1e-12);
}

TEST(Imports, PovFormulasMayHaveLoops) {
    EXPECT_NEAR(inner_value("isosurface { function { y #for (I, 1, 3) + pow(x, I)/I #end } open "
                            "contained_by { sphere { 0, 99 } } }",
                            2, 5, 0),
                5.0 + 2.0 + 2.0 + 8.0 / 3.0, 1e-12);
    EXPECT_NEAR(inner_value("#declare V = <3, -2, 1>; isosurface { function { x*V.x - y*V.y } open "
                            "contained_by { sphere { 0, 99 } } }",
                            2, 5, 0),
                16.0, 1e-12);
}

TEST(Imports, PovParametricSurfacesBecomeRows) {
    const Imported imported = read(
        "a.pov",
        "#declare R = 2; parametric { function { R*cos(u) } function { v } function { R*sin(u) } "
        "<0, -1> <2*pi, 1.5> contained_by { box { -3, 3 } } scale <1, 2, 1> translate <1, 0, 0> "
        "pigment { color rgb <0, 1, 0> } }");
    const ImportedDocument& tube = imported.documents[0];
    EXPECT_EQ(tube.refusal, "");
    EXPECT_EQ(
        tube.document.statements.back().text,
        "(shape(u, v) + 1, shape_3(u, v), 2*shape_2(u, v)), 0 < u < 6.283185307179586, -1 < v < "
        "1.5");
    EXPECT_EQ(tube.document.statements.back().color, 0x00FF00);
    EXPECT_NEAR(tube.document.clip.hi.z, 6.0 * 1.02, 1e-9);
    // Its container cuts it, whatever else the scene shows.
    ASSERT_TRUE(tube.document.statements.back().box);
    EXPECT_EQ(tube.document.statements.back().box->lo, glm::dvec3(-2.0, -3.0, -6.0));
    EXPECT_EQ(tube.document.statements.back().box->hi, glm::dvec3(4.0, 3.0, 6.0));
    EXPECT_TRUE(has_note(tube, "pigment"));
    EXPECT_TRUE(has_note(
        read("b.pov", "isosurface { function { x } } parametric { function { u } <0, 0> <1, 1> }")
            .documents[0],
        "parametric"));
}

TEST(Imports, PovPatternsAreFunctions) {
    // A gradient of period 2 that begins at x = 1: white from 3/4 on.
    const std::string scene =
        "#declare P = function { pigment { gradient x color_map { [0.25 rgb 0] "
        "[0.75 rgb <1, 0.5, 1>] } scale 2 translate <1, 0, 0> } }"
        "isosurface { function { y + P(x, y, z).";
    const auto part = [&](const std::string& name, double x) {
        return inner_value(scene + name + " } open contained_by { sphere { 0, 99 } } }", x, 0, 0);
    };
    EXPECT_NEAR(part("red", 2.0), 0.5, 1e-12);
    EXPECT_NEAR(part("green", 2.0), 0.25, 1e-12);
    EXPECT_NEAR(part("red", 2.75), 1.0, 1e-12);
    EXPECT_NEAR(part("red", 1.25), 0.0, 1e-12);
    EXPECT_NEAR(part("gray", 2.75), 0.297 + 0.5 * 0.589 + 0.114, 1e-12);
    EXPECT_NEAR(part("hf", 2.75), 0.996093 * (1.0 + 0.5 / 255.0), 1e-12);
}

TEST(Imports, PovRandomNumbersAreThoseOfPovRay) {
    // 1812433253 x + 12345 modulo 2^32, divided by 2^32 - 1, from 7 on.
    EXPECT_NEAR(
        inner_value("#declare S = seed(7); #declare A = rand(S); #declare B = rand(S); "
                    "isosurface { function { x + B } open contained_by { sphere { 0, 99 } } }",
                    0, 0, 0),
        static_cast<double>(
            (((7ULL * 1812433253ULL + 12345ULL) % 4294967296ULL) * 1812433253ULL + 12345ULL) %
            4294967296ULL) /
            4294967295.0,
        1e-15);
}

std::size_t surfaces_in(const std::string& scene) {
    const Imported imported = read("a.pov", scene);
    if (imported.documents.empty()) return 0;
    const auto rows = read_rows(imported.documents[0].document);
    return rows ? rows->program->surfaces.size() : 0;
}

TEST(Imports, PovBreakLeavesTheLoopAroundAnIf) {
    EXPECT_EQ(surfaces_in("#declare N = 0; #while (1) isosurface { function { x + y + z } "
                          "contained_by { box { -2, 2 } } translate x*N } #declare N = N + 1; "
                          "#if (N > 2) #break #end #end isosurface { function { x } "
                          "contained_by { box { -2, 2 } } }"),
              4U);
}

TEST(Imports, PovPatternsThatAreDeclaredAnewHaveTheirOwnColors) {
    const std::string box = " open contained_by { sphere { 0, 99 } } }";
    const Imported imported =
        read("a.pov",
             "#for(N, 1, 2) #declare F = function { pigment { planar color_map { [0 rgb <1,0,0>] "
             "[1 rgb <0,N,1>] } } } isosurface { function { y - F(x,y,z).gray }" +
                 box +
                 " #end "
                 "#declare G = F; isosurface { function { G(x,y,z).green }" +
                 box);
    const ImportedDocument& scene = imported.documents[0];
    // The plane y = 0 has the last colour: (0, N, 1).
    EXPECT_NEAR(value(scene, 0, 0.3, 0.2, 0.0), -(0.589 + 0.114), 1e-12);
    EXPECT_NEAR(value(scene, 1, 0.3, 0.2, 0.0), -(2 * 0.589 + 0.114), 1e-12);
    EXPECT_NEAR(value(scene, 2, 0.3, 0.2, 0.0), 2.0, 1e-12);
}

TEST(Imports, PovColorMapsMayBeOfTheOldForm) {
    const Imported imported =
        read("a.pov",
             "#declare F = function { pigment { planar color_map { [0.0, 0.5 color rgb <1,1,1> "
             "color rgb <0,0,0>] [0.5, 1.0 color rgb 0 color rgb 1] } } } isosurface { function { "
             "F(x,y,z).red } contained_by { box { -1, 1 } } }");
    // planar is 1 - |y|, y upwards.
    EXPECT_NEAR(value(imported.documents[0], 0, 0.0, 0.0, 0.75), 0.5, 1e-12);
    EXPECT_NEAR(value(imported.documents[0], 0, 0.0, 0.0, 0.25), 0.5, 1e-12);
    EXPECT_NEAR(value(imported.documents[0], 0, 0.0, 0.0, 0.5), 0.0, 1e-12);
}

TEST(Imports, PovTurbulenceLooksAtNothingBehindItsFunction) {
    EXPECT_EQ(surfaces_in("#declare F = function { pigment { agate turbulence 0.5 color_map { "
                          "[0 rgb 0] [1 rgb 0.5] } } }\n#declare H = function { y - "
                          "0.2*F(x,y,z).red }\nisosurface { function { H(x,y,z) } contained_by { "
                          "box { -1, 1 } } }"),
              1U);
}

const std::string in_ball = " open contained_by { sphere { 0, 99 } } }";

TEST(Imports, PovContainersAreBallsAndBoxes) {
    const auto first = [](const std::string& text) {
        return read("a.pov", text + " isosurface { function { x + y + z } " + "contained_by { " +
                                 (text.empty() ? "" : "B") + " } }")
            .documents[0];
    };
    EXPECT_NEAR(first("#declare B = box { -3, 3 };").document.clip.hi.x, 3.06, 1e-12);
    EXPECT_NEAR(first("#declare B = sphere { <1, 0, 0>, 2 }").document.clip.hi.x, 3.04, 1e-12);
    const auto contained = [](const std::string& text) {
        return read("a.pov", "isosurface { function { x + y + z } contained_by { " + text +
                                 " } translate <1, 0, 0> }")
            .documents[0];
    };
    // A radius counts without its sign.
    const ImportedDocument ball = contained("sphere { <0, 0, 0>, -3.3 }");
    EXPECT_NEAR(value(ball, 0, 1.0, 0.0, 0.0), 0.0, 1e-12);
    EXPECT_NEAR(value(ball, 0, -3.0, 0.0, 0.0), 16.0 - 3.3 * 3.3, 1e-12);
    EXPECT_TRUE(ball.notes.size() == 1) << ball.notes.size();
    for (const std::string other : {"plane { y, 0 }", "cylinder { -y, y, 2 }", "Unknown", ""}) {
        const ImportedDocument unit = contained(other);
        EXPECT_TRUE(has_note(unit, "contained_by")) << other;
        EXPECT_NEAR(unit.document.clip.hi.x, 2.02, 1e-12) << other;
        EXPECT_NEAR(unit.document.clip.hi.z, 1.02, 1e-12) << other;
    }
}

TEST(Imports, PovScenesSayWhyTheyShowNothing) {
    const auto reason = [](const std::string& text) {
        const auto imported = read_import("a.pov", text);
        return imported ? std::string() : imported.error();
    };
    EXPECT_EQ(reason("\nisosurface { function { x - Points[0][0] } }"),
              "line 2: function: '[' does not continue the formula");
    EXPECT_EQ(reason("#declare A = array[2] { 1, 2 }\nisosurface { function { x - A[2] } }"),
              "line 2: A[]: its value is not known; it is left out");
    EXPECT_EQ(reason("parametric { function { u } <0, 0> <1, 1> }"),
              "line 1: parametric: without its function it is left out");
    EXPECT_TRUE(reason("sphere { 0, 1 }").starts_with("it shows no isosurface"));
    EXPECT_EQ(reason("isosurface { transform { \"a\nb\" } }"), "line 1: a b: not taken over");
}

TEST(Imports, PovCamerasMayBeRightHanded) {
    const std::string surface = "isosurface { function { x + 10*y + 100*z }" + in_ball;
    const auto seen = [&](const std::string& camera) {
        return read("a.pov", surface + " camera { location <0, 0, -10> look_at 0 " + camera + " }")
            .documents[0];
    };
    const ImportedDocument usual = seen("right x*4/3");
    EXPECT_NEAR(value(usual, 0, 1.0, 2.0, 3.0), 1.0 + 200.0 + 30.0, 1e-12);
    const ImportedDocument turned = seen("right -x*4/3 angle 40");
    EXPECT_NEAR(value(turned, 0, 1.0, 2.0, 3.0), 1.0 - 200.0 + 30.0, 1e-12);
    EXPECT_EQ(turned.document.camera->eye, glm::dvec3(0.0, 10.0, 0.0));
    // -x is to the right in both pictures.
    const glm::dvec3 to_right = glm::cross(
        turned.document.camera->look_at - turned.document.camera->eye, turned.document.camera->up);
    EXPECT_LT(to_right.x, 0.0);
    EXPECT_FALSE(has_note(turned, "camera"));
    const ImportedDocument upright = seen("location -10*y right <-1.33, 0, 0> sky z");
    EXPECT_NEAR(value(upright, 0, 1.0, 2.0, 3.0), 1.0 + 20.0 + 300.0, 1e-12);
    EXPECT_NEAR(usual.document.camera->fov_rad, 2.0 * std::atan(0.5), 1e-12);
    // Without an angle a picture as wide as high has half the direction's length on each side.
    EXPECT_NEAR(seen("right x").document.camera->fov_rad, 2.0 * std::atan(0.5), 1e-12);
    EXPECT_NEAR(seen("right x direction 2*z").document.camera->fov_rad, 2.0 * std::atan(0.25),
                1e-12);
}

TEST(Imports, PovArraysHaveElements) {
    EXPECT_NEAR(
        inner_value("#declare A = array[3] { 1, 2, 30 }; #declare A[1] = A[2] + 1;"
                    "#declare B = A[1]; isosurface { function { x + A[0] + 100*B - y*A[1] }" +
                        in_ball,
                    0, 2, 0),
        1.0 + 3100.0 - 62.0, 1e-12);
    EXPECT_NEAR(
        inner_value("#declare P = array[2][2] { { <1, 2, 3>, <4, 5, 6> }, { <7, 8, 9>, 0 } };"
                    "#declare S = 0; #for (I, 0, dimension_size(P, 1) - 1) "
                    "#declare S = S + P[I][0].x; #end "
                    "isosurface { function { x #for (I, 0, 1) - pow(10, I)*P[0][I].y #end + S }" +
                        in_ball,
                    0, 0, 0),
        -2.0 - 50.0 + 8.0, 1e-12);
    for (const std::string text : {"array[", "array[3] {", "array[2] { 1, { 2", "array[1] { , , }",
                                   "array { }", "array[1] { A[0] }", "array[1] { A[A[A[0]]] }"}) {
        const auto imported =
            read_import("a.pov", "isosurface { function { x } } #declare A = " + text);
        EXPECT_TRUE(imported) << text;
    }
}

TEST(Imports, PovTransformsMayBeInverse) {
    const std::string declared = "#declare T = transform { translate <1, 0, 0> scale 2 };";
    EXPECT_NEAR(
        inner_value(declared + "isosurface { function { x } open contained_by { sphere { 0, "
                               "99 } } transform { T } }",
                    4, 0, 0),
        1.0, 1e-12);
    EXPECT_NEAR(
        inner_value(declared + "isosurface { function { x } open contained_by { sphere { 0, "
                               "99 } } transform { T inverse } }",
                    4, 0, 0),
        10.0, 1e-12);
}

TEST(Imports, PovFilesThatOnlyDeclareAreDrawn) {
    const std::string ball =
        "isosurface { function { x*x + y*y + z*z - 1 } contained_by { box { -2, "
        "2 } } }";
    EXPECT_EQ(surfaces_in("#declare Ball = " + ball), 1U);
    EXPECT_EQ(surfaces_in("#declare Ball = " + ball +
                          " #declare Pair = union { object { Ball } object { Ball translate x*3 } "
                          "} #declare R = 3;"),
              2U);
    EXPECT_EQ(
        surfaces_in("#declare Ball = " + ball + " #declare Other = " + ball + " object { Ball }"),
        1U);
}

TEST(Imports, PovMacrosEnd) {
    for (const std::string text :
         {"#macro A(X) A(X) #end A(1) isosurface { function { x } }",
          "#macro A(X) A(X) A(X) #end A(1)", "#macro A(X) #while (1) A(2) #end #end A(1)",
          "#macro A(X X #end A(A(A(A(1", "#macro A( #macro B() #end A() B() #end B()",
          "#macro A(X) #end #end #end A(<1, 2) A({) A(}) isosurface { function { A(x) } }",
          "#macro A(X) } isosurface { function { x #end A(1) y } }",
          "#for (I, 0, 9) #macro A(X) #end #end A(I) #if (A(1)) #end #undef A"}) {
        const auto imported = read_import("a.pov", text);
        EXPECT_TRUE(imported || !imported.error().empty()) << text;
    }
    std::string nested = "#macro A(X) X #end #declare B = ";
    for (int i = 0; i < 20'000; ++i)
        nested += "A(";
    EXPECT_FALSE(read_import("a.pov", nested));
    // Each doubles what the one before it has.
    std::string doubled = "#macro M_0(X) X + X #end ";
    for (int i = 1; i < 60; ++i)
        doubled += "#macro M_" + std::to_string(i) + "(X) M_" + std::to_string(i - 1) + "(X) + M_" +
                   std::to_string(i - 1) + "(X) #end ";
    const auto imported =
        read_import("a.pov", doubled +
                                 "isosurface { function { M_59(x) } } isosurface { function "
                                 "{ y } }");
    EXPECT_TRUE(imported || !imported.error().empty());
    // Each of many parameters stands for many tokens.
    std::string large = "#macro M(p)";
    std::string balls = "union {";
    const int many = test::is_long_run() ? 20'000 : 5'000;
    for (int i = 0; i < many; ++i) {
        large += " p";
        balls += " sphere { 0, 1 }";
    }
    const std::string plane =
        "isosurface { function { x } contained_by { box { -1, 1 } } } #macro ";
    EXPECT_TRUE(read_import("a.pov", plane + large.substr(7) + " #end M(" + balls + " })"));
    std::string deep = "#macro M()";
    for (int i = 0; i < many / 2; ++i)
        deep += " M()";
    EXPECT_TRUE(read_import("a.pov", plane + deep.substr(7) + " #end M()"));
}

}  // namespace
}  // namespace zeroset::test::pov_test
