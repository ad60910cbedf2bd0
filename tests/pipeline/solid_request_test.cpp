// Which side of a surface is solid where that was not chosen.

#include "engine/scene/scene.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

namespace zeroset::solid_request_test {
namespace {

std::vector<SolidSide> sides_of(const char* text, SolidSide chosen = SolidSide::Automatic) {
    ReadDocument read = read_document_text(text);
    if (!read.rows) return {};
    for (Statement& row : read.document.statements)
        row.solid = chosen;
    auto formula = prepare_formula(*read.rows, read.document.clip, Preparation::Interpreted);
    if (!formula) return {};
    const PictureRequest request =
        picture_request(std::make_shared<const Formula>(std::move(*formula)), nullptr,
                        read.document, TraceSettings(), {16, 16});
    std::vector<SolidSide> sides;
    for (const ShownSurface& surface : request.surfaces)
        sides.push_back(surface.solid);
    return sides;
}

TEST(SolidRequest, IsWhereAConditionHolds) {
    const std::vector below{SolidSide::Below};
    EXPECT_EQ(sides_of("x^2 + y^2 + z^2 > 1"), below) << "all but the ball";
    EXPECT_EQ(sides_of("z > x^2 + y^2"), below);
    EXPECT_EQ(sides_of("x < 1; x^2 + y^2 + z^2 = 1"),
              (std::vector{SolidSide::Below, SolidSide::Automatic}));
}

TEST(SolidRequest, IsWhatWasChosen) {
    EXPECT_EQ(sides_of("x^2 + y^2 + z^2 > 1", SolidSide::Above), (std::vector{SolidSide::Above}));
    EXPECT_EQ(sides_of("x^2 + y^2 + z^2 = 1"), (std::vector{SolidSide::Automatic}));
}

}  // namespace
}  // namespace zeroset::solid_request_test
