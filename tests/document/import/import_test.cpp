// Tests of reading other programs' files: each format's rows by their values against the formulas
// of its documentation, what is told of boxes, colours and cameras, and the list of the rest.

#include "document/import/import.hpp"

#include "document/import/import_choice.hpp"
#include "document/row_program.hpp"
#include "tests/document/import/samples.hpp"
#include "tests/support/mpfr_number.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace zeroset::test {
namespace {

Imported read(std::string_view file, std::string_view bytes) {
    auto imported = read_import(file, bytes);
    EXPECT_TRUE(imported) << imported.error();
    return imported ? *imported : Imported{};
}

/// f of a document's surface at a point, its parameters as its sliders say, without its conditions.
double value(const ImportedDocument& imported, std::size_t surface, double x, double y, double z,
             double w = 0.0) {
    Document document = imported.document;
    // Sliders become values.
    for (const auto& [name, slider] : document.parameters) {
        Statement row;
        row.id = unused_id(document);
        row.text = name + " := " + std::to_string(slider.value);
        document.statements.insert(document.statements.begin(), row);
    }
    const auto rows = read_rows(document);
    EXPECT_TRUE(rows) << rows.error().reason;
    if (!rows || surface >= rows->program->surfaces.size()) return std::nan("");
    const Reference at = reference(rows->program->surfaces[surface], std::array{x, y, z, w});
    return at.defined ? at.value.nearest() : std::nan("");
}

bool has_note(const ImportedDocument& imported, std::string_view entry) {
    return std::ranges::any_of(
        imported.notes, [entry](const ImportNote& note) { return note.entry.contains(entry); });
}

TEST(Imports, FormatsAreFoundByName) {
    EXPECT_EQ(import_format("A.JSURF")->name, "SURFER");
    EXPECT_EQ(import_format("scene.inc")->name, "POV-Ray");
    EXPECT_EQ(import_format(".pov"), nullptr);
    EXPECT_EQ(import_format("x^2 + y^2 = 1"), nullptr);
    EXPECT_EQ(import_format("a.zeroset.json"), nullptr);
}

TEST(Imports, SurferTorus) {
    const Imported imported = read("torus.jsurf", jsurf_torus);
    ASSERT_EQ(imported.documents.size(), 1U);
    const ImportedDocument& torus = imported.documents[0];
    EXPECT_EQ(torus.name, "torus");
    EXPECT_EQ(torus.refusal, "");
    const double a = 0.75;
    const double b = 0.25;
    const auto f = [&](double x, double y, double z) {
        const double s = x * x + y * y + z * z + a * a - b * b;
        return s * s - 4 * a * a * (x * x + y * y);
    };
    EXPECT_NEAR(value(torus, 0, 0.3, -0.7, 0.2), f(0.3, -0.7, 0.2), 1e-14);
    EXPECT_EQ(torus.document.parameters.at("a").value, a);
    EXPECT_EQ(torus.document.statements.back().color, 0xFF8000);
    ASSERT_TRUE(torus.document.region.ball);
    EXPECT_NEAR(torus.document.region.ball->radius, std::sqrt(10.0), 1e-12);
    // The camera sees 2 of the ball's unit, from where the rotation brings -y.
    ASSERT_TRUE(torus.document.camera);
    const Camera& camera = *torus.document.camera;
    EXPECT_EQ(camera.projection, Projection::Orthographic);
    const glm::dvec3 back = camera.eye - camera.look_at;
    EXPECT_NEAR(glm::normalize(back).y, -1.0, 1e-12);
    EXPECT_NEAR(camera.up.z, 1.0, 1e-12);
    EXPECT_NEAR(glm::length(back) * std::tan(0.5 * camera.fov_rad), std::sqrt(10.0), 1e-9);
    EXPECT_EQ(torus.document.light.background->top, 0xFFFFFF);
    EXPECT_EQ(torus.document.light.lights.size(), 1U);
    EXPECT_TRUE(has_note(torus, "front_material_shininess"));
    EXPECT_FALSE(has_note(torus, "back_material_color"));
}

TEST(Imports, SurfReadsMinusBeforePowers) {
    const Imported imported = read("ball.pic", surf_ball);
    ASSERT_EQ(imported.documents.size(), 1U);
    const ImportedDocument& ball = imported.documents[0];
    EXPECT_EQ(ball.refusal, "");
    EXPECT_NEAR(value(ball, 0, 1.0, 2.0, 3.0), 1.0 + 4.0 + 9.0 - 9.0, 1e-12);
    // Turned by a quarter about x: (x, y, z) comes from (x, z, -y).
    EXPECT_NEAR(value(ball, 1, 1.0, 2.0, 3.0), 1.0 + 9.0 - 1.0, 1e-12);
    // The clip ball of radius 5 is one of the view, in which the surface is twice as large.
    ASSERT_TRUE(ball.document.region.ball);
    EXPECT_NEAR(ball.document.region.ball->radius, 2.5, 1e-12);
    EXPECT_EQ(ball.document.statements.back().color, 0x7B68EE);
    EXPECT_TRUE(has_note(ball, "smoothness"));
}

TEST(Imports, SurfScalesAxesBySubstitution) {
    const Imported imported = read("a.pic", "scale_x=0.5; surface=x^2+y^2+z^2-9; draw_surface;");
    const ImportedDocument& ball = imported.documents[0];
    // A point of the view at 6 on its x-axis shows the surface's x = 3.
    EXPECT_NEAR(value(ball, 0, 6.0, 0.0, 0.0), 0.0, 1e-12);
    EXPECT_NEAR(value(ball, 0, 0.0, 3.0, 0.0), 0.0, 1e-12);
}

TEST(Imports, SurfPowersCountFromTheLeft) {
    const Imported imported = read("a.pic", "surface=x-2^2^3; draw_surface;");
    EXPECT_NEAR(value(imported.documents[0], 0, 64.0, 0.0, 0.0), 0.0, 1e-12);
}

TEST(Imports, MathModModels) {
    const Imported imported = read("models.js", mathmod_model);
    ASSERT_EQ(imported.documents.size(), 3U);
    const ImportedDocument& two = imported.documents[0];
    EXPECT_EQ(two.name, "Two parts");
    EXPECT_EQ(two.refusal, "");
    // The slider's N = 3 comes before the constant's 2; both parts of a condition are drawn.
    const auto rows = read_rows(two.document);
    ASSERT_TRUE(rows);
    EXPECT_EQ(rows->program->surfaces.size(), 3U);
    EXPECT_NEAR(value(two, 0, 0.1, 0.2, 0.3), 0.14 - 0.25, 1e-12);
    EXPECT_NEAR(value(two, 2, 2.0, 0.5, 0.0), 0.25 + 0.25 - 0.25, 1e-12);
    EXPECT_NEAR(value(two, 2, 2.0, 1.5, 0.0), 2.0 * (0.25 + 2.25 - 0.25), 1e-12);
    // % keeps the sign of the first number: -0.5 % 2 is -0.5.
    EXPECT_NEAR(value(two, 2, 2.0, -0.5, 0.0), 0.25 + 0.25 - 0.25, 1e-12);
    EXPECT_NEAR(two.document.clip.hi.y, std::numbers::pi, 1e-15);
    EXPECT_EQ(two.document.clip.lo.x, -3.0);
    EXPECT_TRUE(has_note(two, "Cnd"));
    EXPECT_TRUE(has_note(two, "Texture"));
    const ImportedDocument& helicoid = imported.documents[1];
    EXPECT_EQ(helicoid.document.statements.back().text,
              "(u*cos(v), u*sin(v), v), 0 < u < 1, 0 < v < 2*pi");
    const ImportedDocument& waves = imported.documents[2];
    EXPECT_NEAR(value(waves, 0, 0.5, 1.0, 2.0), std::cos(0.5) + std::cos(1.0) + std::cos(2.0),
                1e-12);
}

TEST(Imports, K3dSurfEquations) {
    const Imported imported = read("chair.k3ds", k3ds_equations);
    ASSERT_EQ(imported.documents.size(), 2U);
    const double s = 1.0 + 4.0 + 9.0 - 0.95 * 25.0;
    EXPECT_NEAR(value(imported.documents[0], 0, 1.0, 2.0, 3.0),
                s * s - 0.8 * (4.0 - 2.0) * (64.0 - 8.0), 1e-9);
    const ImportedDocument& cut = imported.documents[1];
    EXPECT_EQ(cut.name, "Cut ball");
    EXPECT_EQ(cut.document.clip.hi.y, 2.0);
    EXPECT_NEAR(value(cut, 0, 1.0, 1.0, 1.0, 0.5), 3.0 - 0.5 - 1.0, 1e-12);
}

TEST(Imports, Instructions) {
    const Imported imported = read("ball.vm", instruction_list);
    const ImportedDocument& ball = imported.documents[0];
    EXPECT_EQ(ball.refusal, "");
    EXPECT_NEAR(value(ball, 0, 0.3, 0.4, 0.0), 0.0, 1e-15);
    EXPECT_FALSE(ball.tells_box);
}

TEST(Imports, ImpVisPresets) {
    const Imported imported = read("presets.toml", impvis_presets);
    ASSERT_EQ(imported.documents.size(), 2U);
    const ImportedDocument& roman = imported.documents[0];
    EXPECT_EQ(roman.name, "Roman");
    EXPECT_EQ(roman.refusal, "");
    EXPECT_NEAR(value(roman, 0, 1.0, 2.0, 3.0), 4.0 + 36.0 + 9.0 - 12.0, 1e-12);
    EXPECT_TRUE(roman.document.region.ball);
    const ImportedDocument& cube = imported.documents[1];
    EXPECT_EQ(cube.name, "cube");
    EXPECT_FALSE(cube.document.region.ball);
    EXPECT_NEAR(value(cube, 0, 1.0, 2.0, 0.0), 1.0 + 16.0 - 0.5, 1e-12);
}

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

/// f of the row of a scene's surface without what closes it, at a point of POV-Ray's.
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
    EXPECT_NEAR(inner_value("isosurface { function { y #for (I, 1, 3) + pow(x, I)/I #end } open contained_by { sphere { 0, 99 } } }",
                            2, 5, 0),
                5.0 + 2.0 + 2.0 + 8.0 / 3.0, 1e-12);
    EXPECT_NEAR(
        inner_value("#declare V = <3, -2, 1>; isosurface { function { x*V.x - y*V.y } open contained_by { sphere { 0, 99 } } }", 2, 5,
                    0),
        16.0, 1e-12);
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
}

TEST(Imports, RowsThatTheLanguageRefusesBecomeRemarks) {
    const Imported imported = read(
        "a.pov", "isosurface { function { x + f_waves(x, y, z) } }\nisosurface { function { y } }");
    const ImportedDocument& half = imported.documents[0];
    EXPECT_EQ(half.refusal, "");
    EXPECT_TRUE(has_note(half, "shape(x, y, z) = x + f_waves"));
    EXPECT_TRUE(half.document.statements.front().text.starts_with("# "));
    EXPECT_LT(value(half, 0, 0.0, 0.0, -0.5), 0.0);
    const Imported none = read("a.pov", "isosurface { function { f_waves(x, y, z) } }");
    EXPECT_NE(none.documents[0].refusal, "");
    EXPECT_TRUE(none.documents[0].document.statements.front().text.starts_with("shape"));
}

TEST(Imports, ConstantsAreNoSurfaces) {
    const Imported imported =
        read("a.js", R"js({"Iso3D": {"Const": ["r=2"], "Fxyz": ["x"], "Xmin": ["-1"], "Xmax": ["1"],
                   "Ymin": ["-1"], "Ymax": ["1"], "Zmin": ["-1"], "Zmax": ["1"]}})js");
    const auto rows = read_rows(imported.documents[0].document);
    ASSERT_TRUE(rows);
    EXPECT_EQ(rows->program->surfaces.size(), 1U);
}

TEST(Imports, WrongFilesSayWhatIsMissing) {
    for (const auto& [file, bytes] :
         std::vector<std::pair<std::string, std::string>>{{"a.jsurf", "x=1"},
                                                          {"a.jsurf", ""},
                                                          {"a.pic", "curve=x; draw_curve;"},
                                                          {"a.pic", "\xFF\x00\x01"},
                                                          {"a.js", "var a = 1;"},
                                                          {"a.js", "{}"},
                                                          {"a.js", std::string(1'000'000, '[')},
                                                          {"a.k3ds", "hello"},
                                                          {"a.vm", "x^2 = 1"},
                                                          {"a.vm", ""},
                                                          {"a.toml", "[a"},
                                                          {"a.toml", "a = '''"},
                                                          {"a.pov", "sphere { 0, 1 }"},
                                                          {"a.pov", "#while (1) #end"},
                                                          {"a.pov", std::string(100'000, '{')}}) {
        const auto imported = read_import(file, bytes);
        ASSERT_FALSE(imported) << file << ": " << bytes.substr(0, 30);
        EXPECT_FALSE(imported.error().empty());
        EXPECT_FALSE(imported.error().contains('\n'));
    }
}

TEST(Imports, DeepFormulasAreRefused) {
    const std::string deep(100'000, '(');
    for (const std::string& text :
         {"isosurface { function { " + deep + " } }", "#declare a = " + deep + ";",
          "#if (" + deep + ") #end", std::string("union { union { ") + deep}) {
        const auto imported = read_import("a.pov", text);
        EXPECT_FALSE(imported && imported->documents[0].refusal.empty());
    }
    const auto surf = read_import("a.pic", "surface = " + deep + "; draw_surface;");
    EXPECT_FALSE(surf);
    const auto repeated = [](const std::string& part) {
        std::string text;
        for (int i = 0; i < 100'000; ++i)
            text += part;
        return text;
    };
    EXPECT_FALSE(read_import("a.pic", "surface = x" + repeated("^1") + "; draw_surface;"));
    const auto joined = read_import("a.pov", "#if (1" + repeated("&1") + ") #end");
    EXPECT_FALSE(joined && joined->documents[0].refusal.empty());
    const auto remainders =
        read_import("a.js", R"({"Iso3D": {"Fxyz": ["x)" + repeated("%3") + R"("]}})");
    ASSERT_TRUE(remainders) << remainders.error();
    EXPECT_TRUE(std::ranges::any_of(remainders->documents[0].notes, [](const ImportNote& note) {
        return note.reason.starts_with("too many remainders");
    }));
    std::string unions;
    for (int i = 0; i < 50'000; ++i)
        unions += "union { ";
    EXPECT_FALSE(read_import("a.pov", unions));
}

TEST(Imports, NumbersAreNotTooLarge) {
    EXPECT_FALSE(read_import("a.js", R"({"Iso3D": {"Fxyz": ["x"], "Xmin": [1e999]}})"));
    const auto surf = read_import(
        "a.pic", "radius = 1/0; first = 1e20; clip = 0/0; surface = x^2 + y^2 - 1; draw_surface;");
    ASSERT_TRUE(surf);
    EXPECT_TRUE(std::isfinite(surf->documents[0].document.clip.size()));
}

TEST(Imports, ScenesOfPovRayEnd) {
    std::string text =
        "#declare A = isosurface { function { x } contained_by { sphere { 0, 1 } } }"
        " #declare B = union {";
    for (int i = 0; i < 10'000; ++i)
        text += " object { A }";
    text += " } #while (1)" + text.substr(text.find(" object")) + " #end";
    const auto imported = read_import("a.pov", text);
    ASSERT_TRUE(imported);
    EXPECT_LE(imported->documents[0].document.statements.size(), 1'000U);
}

TEST(Imports, NotesSayWhere) {
    EXPECT_EQ(note_text("a.pic", {.line = 3, .entry = "diffuse", .reason = "not taken over"}),
              "a.pic:3: diffuse: not taken over");
    EXPECT_EQ(note_text("a.js", {.reason = "why"}), "a.js: why");
    EXPECT_EQ(notes_listed({}), "");
    EXPECT_EQ(notes_listed({{.reason = "why"}, {.line = 2, .entry = "a", .reason = "left out"}}),
              "why\nline 2: a: left out");
    const std::string many = notes_listed(std::vector<ImportNote>(20, {.reason = "why"}));
    EXPECT_EQ(std::ranges::count(many, '\n'), 12);
    EXPECT_TRUE(many.ends_with("and 8 more, which zeroset import lists"));
}

}  // namespace
}  // namespace zeroset::test
