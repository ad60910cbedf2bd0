#include "app/cli/options/solid_options.hpp"

#include "document/solid_choice.hpp"
#include "pipeline/document_scene.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// Tests of --solid, the side of each surface that sections fill.

namespace zeroset::test {
namespace {

using Texts = std::vector<std::string>;

TEST(ReadSolids, TakeASideForAllSurfacesOrOne) {
    const auto choices = read_solids({"f<0", "2 : f > 0", "12:auto"});
    ASSERT_TRUE(choices) << choices.error().reason;
    EXPECT_EQ(*choices,
              (std::vector<SolidChoice>{
                  {{}, SolidSide::Below}, {2, SolidSide::Above}, {12, SolidSide::Automatic}}));
}

TEST(ReadSolids, RefuseWhatIsNoSide) {
    for (const char* const wrong : {"", "f", "f=0", "0:f<0", "x:f<0", "256:f<0", "1:", "f<0:1"}) {
        const auto choices = read_solids({wrong});
        ASSERT_FALSE(choices) << wrong;
        EXPECT_EQ(choices.error().reason.find("--solid"), 0U) << choices.error().reason;
    }
}

TEST(ReadSolids, RefuseSurfacesThatTheFormulaDoesNotHave) {
    const auto program = read_formula("a = 2; x = a; y = 1");
    ASSERT_TRUE(program);
    EXPECT_FALSE(check_solids(*program, {{{}, SolidSide::Below}, {2, SolidSide::Above}}));
    EXPECT_TRUE(check_solids(*program, {{3, SolidSide::Above}}));
}

TEST(TakeSolids, SetsTheRowsOfSurfaces) {
    Surface surface;
    surface.equation = "a = 2; x = a; y = 1";
    surface.solids = {{{}, SolidSide::Below}, {2, SolidSide::Above}};
    const Document document = document_of(surface);
    ASSERT_EQ(document.statements.size(), 3U);
    EXPECT_EQ(document.statements[0].solid, SolidSide::Automatic);
    EXPECT_EQ(document.statements[1].solid, SolidSide::Below);
    EXPECT_EQ(document.statements[2].solid, SolidSide::Above);
}

TEST(DocumentScene, KnowsTheSidesOfItsSurfaces) {
    Surface surface;
    surface.equation = "x = 2\nx^2 + y^2 = 1, z < 1";
    surface.solids.push_back({.surface = 2, .side = SolidSide::Above});
    const Document document = document_of(surface);
    const auto formula = compile_formula(joined_rows(document).text);
    ASSERT_TRUE(formula);
    const Scene scene =
        document_scene(*formula, document, surface_rows(document, formula->program));
    ASSERT_EQ(scene.solids.size(), 2U);
    EXPECT_EQ(scene.solids[0].side, SolidSide::Automatic);
    EXPECT_EQ(scene.solids[1].side, SolidSide::Above);
    EXPECT_FALSE(scene.solids[0].unrestricted);
    EXPECT_TRUE(scene.solids[1].unrestricted);
}

}  // namespace
}  // namespace zeroset::test
