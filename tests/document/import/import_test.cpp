// Tests of reading other programs' files: each format's rows by their values against the formulas
// of its documentation, what is told of boxes, colours and cameras, and the list of the rest.

#include "document/import/import.hpp"

#include "document/import/import_choice.hpp"
#include "tests/document/import/imported_values.hpp"
#include "tests/document/import/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace zeroset::test::import_test {
namespace {

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

TEST(Imports, SurfScriptsGoOnFromTheirSurfaces) {
    const Imported imported =
        read("a.pic",
             "surface = x^2 + y^2 - z^2;\nsurface = rotate(surface, Pi/2, xAxis);\n"
             "surface = surface*surface - 1; surface2 = surface + x; draw_surface;");
    const ImportedDocument& cone = imported.documents[0];
    EXPECT_TRUE(cone.notes.empty() || !has_note(cone, "surface"));
    // Turned by a quarter about x: (x, y, z) comes from (x, z, -y).
    const double f = 4.0 + 9.0 - 25.0;
    EXPECT_NEAR(value(cone, 0, 2.0, 5.0, 3.0), f * f - 1.0, 1e-9);
    EXPECT_NEAR(value(cone, 1, 2.0, 5.0, 3.0), f * f - 1.0 + 2.0, 1e-9);
}

TEST(Imports, SurfScriptsThatLoseTheirSurfaceSayWhy) {
    const auto reason = [](const std::string& script) {
        const auto imported = read_import("a.pic", script);
        return imported ? std::string() : imported.error();
    };
    EXPECT_EQ(reason("\nsurface=x^2 y+z;\ndraw_surface;"),
              "line 2: surface: 'y' does not continue the formula; it is left out");
    EXPECT_EQ(reason("surface=hesse(x);\ndraw_surface;"),
              "line 1: surface: hesse() is not known; it is left out");
    EXPECT_EQ(reason("surface=x+who;"), "line 1: surface: who is not known; it is left out");
    EXPECT_EQ(reason("draw_surface;"), "no surface has been named before");
    EXPECT_EQ(reason("curve=x y; draw_curve;"), "it draws plane curves only, no surface");
    EXPECT_EQ(reason("n = 3;"), "it has no draw_surface, as a script of surf has");
    EXPECT_EQ(reason("surface=rotate(x*y, Pi/2, xAxis); draw_surface;"), "");
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

TEST(Imports, K3dSurfNotesHaveItsWords) {
    const ImportedDocument surface =
        read("a.k3ds", "F(): x + who\n[x]: 1\n[y]: -1, 1\n[z]: -1, 1\nA[u]: 3\n;").documents[0];
    EXPECT_TRUE(has_note(surface, "[x]"));
    EXPECT_TRUE(has_note(surface, "F()"));
    EXPECT_TRUE(has_note(surface, "A[u]"));
    EXPECT_FALSE(has_note(surface, "Iso3D"));
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

/// f of the row of a scene's surface without what closes it, at a point of POV-Ray's.
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

TEST(Imports, RowsAreReadOnlySoOften) {
    const auto rows = [](int wrong, std::size_t remarks) {
        std::string text = "x^2 + y^2 + z^2 = 1\n";
        for (int i = 0; i < wrong; ++i)
            text += "x^2 + qq0(( = " + std::to_string(i) + "\n";
        for (std::size_t i = 0; i < remarks; ++i)
            text += "# " + std::string(98, 'r') + "\n";
        return text;
    };
    EXPECT_EQ(read("a.txt", rows(30, 0)).documents[0].refusal, "");
    EXPECT_EQ(read("a.txt", rows(30, 4500)).documents[0].refusal, "");
    EXPECT_TRUE(
        read("a.txt", rows(201, 0))
            .documents[0]
            .refusal.starts_with("200 of its rows are refused, and there are more; the first: "));
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
}  // namespace zeroset::test::import_test
