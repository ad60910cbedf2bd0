#include "engine/language/parse.hpp"
#include "engine/rewrite/surface_functions.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zeroset::test::value_side_test {
namespace {

/// The function whose level a typed surface is, as text.
std::string side_of(const std::string& text) {
    const auto program = read_program(text);
    EXPECT_TRUE(program) << text;
    return program ? value_side(program->surfaces.front()).canonical() : "";
}

TEST(ValueSide, IsWhatIsComparedWithAConstant) {
    const std::string squares = side_of("x^2 + y^2 + z^2");
    EXPECT_EQ(side_of("x^2 + y^2 + z^2 = 4"), squares);
    EXPECT_EQ(side_of("4 = x^2 + y^2 + z^2"), squares);
    EXPECT_EQ(side_of("x^2 + y^2 + z^2 = a^2 + w"), squares);
    EXPECT_EQ(side_of("x^2 + y^2 + z^2 = 0"), squares);
    EXPECT_EQ(side_of("x^2 + y^2 + z^2 = 4, z > 0"), squares);
}

TEST(ValueSide, IsFWhereNothingIsCompared) {
    EXPECT_EQ(side_of("x^2 = y"), side_of("x^2 - y"));
    EXPECT_EQ(side_of("x y z + 1"), side_of("x y z + 1 = 0"));
    EXPECT_NE(side_of("x^2 - y"), side_of("x^2"));
}

}  // namespace
}  // namespace zeroset::test::value_side_test
