#include "app/cli/options/surface_options.hpp"

#include "document/row_program.hpp"
#include "pipeline/picture_request.hpp"
#include "tests/support/formulas.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// Tests of the options that are of all surfaces or of one, such as --solid and --color.

namespace zeroset::test::surface_options_test {
namespace {

using Side = SurfaceChoice<SolidSide>;

TEST(ReadSolids, TakeASideForAllSurfacesOrOne) {
    const auto choices = read_surface_choices({.solids = {"f<0", "2 : f > 0", "12:auto"}});
    ASSERT_TRUE(choices) << choices.error().reason;
    EXPECT_EQ(choices->solids,
              (std::vector<Side>{
                  {{}, SolidSide::Below}, {2, SolidSide::Above}, {12, SolidSide::Automatic}}));
}

TEST(ReadSolids, RefuseWhatIsNoSide) {
    for (const char* const wrong : {"", "f", "f=0", "0:f<0", "x:f<0", "256:f<0", "1:", "f<0:1"}) {
        const auto choices = read_surface_choices({.solids = {wrong}});
        ASSERT_FALSE(choices) << wrong;
        EXPECT_EQ(choices.error().reason.find("--solid"), 0U) << choices.error().reason;
    }
}

TEST(ReadSolids, RefuseSurfacesThatTheFormulaDoesNotHave) {
    const auto program = read_formula("a = 2; x = a; y = 1");
    ASSERT_TRUE(program);
    EXPECT_FALSE(check_surface_choices(
        *program, {.solids = {{{}, SolidSide::Below}, {2, SolidSide::Above}}}));
    EXPECT_TRUE(check_surface_choices(*program, {.solids = {{3, SolidSide::Above}}}));
    EXPECT_TRUE(check_surface_choices(*program, {.looks = {{3, Look::Metal}}}));
}

TEST(TakeSolids, SetsTheRowsOfSurfaces) {
    ReadDocument read = read_document_text("a = 2; x = a; y = 1");
    take_surface_choices({.solids = {{{}, SolidSide::Below}, {2, SolidSide::Above}}},
                         read.rows->surface_rows, read.document);
    ASSERT_EQ(read.document.statements.size(), 3U);
    EXPECT_EQ(read.document.statements[0].solid, SolidSide::Automatic);
    EXPECT_EQ(read.document.statements[1].solid, SolidSide::Below);
    EXPECT_EQ(read.document.statements[2].solid, SolidSide::Above);
}

TEST(SceneOfADocument, KnowsTheSidesOfItsSurfaces) {
    ReadDocument read = read_document_text("x = 2\nx^2 + y^2 = 1, z < 1");
    take_surface_choices({.solids = {{2, SolidSide::Above}}}, read.rows->surface_rows,
                         read.document);
    const auto prepared = prepare(read.document, *read.rows, Preparation::Interpreted);
    ASSERT_TRUE(prepared);
    const Scene scene =
        scene_of(picture_request(prepared->formula, prepared->colors, read.document, {}, {64, 64}));
    ASSERT_EQ(scene.surfaces.size(), 2U);
    EXPECT_EQ(scene.surfaces[0].solid.side, SolidSide::Automatic);
    EXPECT_EQ(scene.surfaces[1].solid.side, SolidSide::Above);
    EXPECT_FALSE(scene.surfaces[0].solid.unrestricted);
    EXPECT_TRUE(scene.surfaces[1].solid.unrestricted);
}

TEST(ReadOpacities, TakeNumbersFrom0To1) {
    const auto read = read_surface_choices({.opacities = {"0.5", "2:1"}});
    ASSERT_TRUE(read);
    using Opacity = SurfaceChoice<double>;
    EXPECT_EQ(read->opacities,
              (std::vector<Opacity>{{.value = 0.5}, {.surface = 2, .value = 1.0}}));
    for (const char* const text : {"1.5", "-0.1", "2:", "x", "0:0.5"})
        EXPECT_FALSE(read_surface_choices({.opacities = {text}})) << text;
}

TEST(ReadLooks, TakeNamesAndSayThem) {
    const auto read = read_surface_choices({.looks = {"glass", "2:metal"}});
    ASSERT_TRUE(read);
    using Made = SurfaceChoice<Look>;
    EXPECT_EQ(read->looks,
              (std::vector<Made>{{.value = Look::Glass}, {.surface = 2, .value = Look::Metal}}));
    const auto wrong = read_surface_choices({.looks = {"2:gold"}});
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().reason,
              "--surface-look 2:gold: type standard, phong, matte, porcelain, metal, glass, clay "
              "or technical; 2:metal is for the second surface alone");
}

TEST(SurfaceOptions, AreOfAllSurfacesOrOfOne) {
    const auto read = read_surface_choices({.colors = {"#102030", "2:#FFFFFF"},
                                            .thicknesses = {"0.25", "1:3 px"},
                                            .boxes = {"2", "1:-1,1,-2,2,0,3"}});
    ASSERT_TRUE(read);
    using Color = SurfaceChoice<std::uint32_t>;
    using Width = SurfaceChoice<Thickness>;
    using Cut = SurfaceChoice<Box>;
    EXPECT_EQ(read->colors,
              (std::vector<Color>{{.value = 0x102030}, {.surface = 2, .value = 0xFFFFFF}}));
    EXPECT_EQ(read->thicknesses,
              (std::vector<Width>{{.value = {.width = 0.25}},
                                  {.surface = 1, .value = {.width = 3.0, .in_pixels = true}}}));
    EXPECT_EQ(read->boxes,
              (std::vector<Cut>{{.value = Box::cube(2.0)},
                                {.surface = 1, .value = {.lo = {-1, -2, 0}, .hi = {1, 2, 3}}}}));
}

TEST(SurfaceOptions, AreTakenByTheRowsOfTheirSurfaces) {
    Document document = read_text("(1, 2, 3); x = 1; a = 2", nullptr).document;
    const auto rows = read_rows(document);
    ASSERT_TRUE(rows);
    const auto read = read_surface_choices({.looks = {"2:clay"},
                                            .colors = {"1:#102030"},
                                            .thicknesses = {"1:5px"},
                                            .boxes = {"2:0.5"}});
    ASSERT_TRUE(read);
    EXPECT_FALSE(check_surface_choices(*rows->program, *read));
    take_surface_choices(*read, rows->surface_rows, document);
    EXPECT_EQ(document.statements[0].color, 0x102030U);
    EXPECT_EQ(document.statements[0].thickness, (Thickness{.width = 5.0, .in_pixels = true}));
    EXPECT_FALSE(document.statements[0].box);
    EXPECT_EQ(document.statements[1].box, Box::cube(0.5));
    EXPECT_FALSE(document.statements[0].look);
    EXPECT_EQ(document.statements[1].look, Look::Clay);
    const auto of_plane =
        read_surface_choices({.colors = {}, .thicknesses = {"2:5px"}, .boxes = {}});
    ASSERT_TRUE(of_plane);
    EXPECT_TRUE(check_surface_choices(*rows->program, *of_plane)) << "the plane is no curve";
}

}  // namespace
}  // namespace zeroset::test::surface_options_test
