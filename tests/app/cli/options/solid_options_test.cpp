#include "app/cli/options/solid_options.hpp"

#include "pipeline/picture_request.hpp"
#include "tests/support/formulas.hpp"

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
    ReadDocument read = read_document_text("a = 2; x = a; y = 1");
    take_solids({{{}, SolidSide::Below}, {2, SolidSide::Above}}, read.rows->surface_rows,
                read.document);
    ASSERT_EQ(read.document.statements.size(), 3U);
    EXPECT_EQ(read.document.statements[0].solid, SolidSide::Automatic);
    EXPECT_EQ(read.document.statements[1].solid, SolidSide::Below);
    EXPECT_EQ(read.document.statements[2].solid, SolidSide::Above);
}

TEST(SceneOfADocument, KnowsTheSidesOfItsSurfaces) {
    ReadDocument read = read_document_text("x = 2\nx^2 + y^2 = 1, z < 1");
    take_solids({{2, SolidSide::Above}}, read.rows->surface_rows, read.document);
    const auto prepared = prepare(read.document, *read.rows, Preparation::Interpreted);
    ASSERT_TRUE(prepared);
    const Scene scene =
        scene_of(picture_request(prepared->formula, prepared->colors, read.document, {}, {64, 64}));
    ASSERT_EQ(scene.solids.size(), 2U);
    EXPECT_EQ(scene.solids[0].side, SolidSide::Automatic);
    EXPECT_EQ(scene.solids[1].side, SolidSide::Above);
    EXPECT_FALSE(scene.solids[0].unrestricted);
    EXPECT_TRUE(scene.solids[1].unrestricted);
}

}  // namespace
}  // namespace zeroset::test
