// Names that a text does not define: built-in values and parameters.

#include "engine/language/expressions/free_names.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace zeroset::free_names_test {
namespace {

class FreeNamesTest : public testing::Test {
protected:
    std::string text(NodeId id) { return values_.builder().text(id, {}, longest_text); }

    Notes notes_;
    GraphValues values_{notes_};
    FreeNames names_{values_};
};

TEST_F(FreeNamesTest, ParametersKeepTheirOrder) {
    const auto b = names_.parameter("b", 0);
    const auto a = names_.parameter("a", 1);
    const auto again = names_.parameter("b", 2);
    ASSERT_TRUE(a && b && again);
    EXPECT_EQ(b->id, again->id);
    EXPECT_EQ(names_.parameters(), (std::vector<std::string>{"b", "a"}));
    EXPECT_TRUE(names_.has_parameter("a"));
    EXPECT_FALSE(names_.has_parameter("c"));
}

TEST_F(FreeNamesTest, ParametersAreBounded) {
    for (std::size_t i = 0; i < ProgramLimits::parameters; ++i)
        ASSERT_TRUE(names_.parameter("a_" + std::to_string(i), 0));
    EXPECT_FALSE(names_.parameter("b", 5));
    EXPECT_EQ(values_.failure().error().offset, 5U);
}

TEST_F(FreeNamesTest, BuiltInValuesAreFormulas) {
    EXPECT_EQ(text(names_.built_in("rho")), "sqrt(x^2 + y^2)");
    EXPECT_EQ(text(names_.built_in("phi")), "acos(z/sqrt(x^2 + y^2 + z^2))");
    EXPECT_EQ(text(names_.built_in("golden")), "(1 + sqrt(5))/2");
    EXPECT_EQ(names_.built_in("w"), names_.built_in("t"));
}

TEST_F(FreeNamesTest, RemembersHowTheTextCallsTheFourthCoordinate) {
    EXPECT_FALSE(names_.calls_w_t());
    names_.said("t", 0);
    EXPECT_TRUE(names_.calls_w_t());
    names_.said("w", 0);
    EXPECT_FALSE(names_.calls_w_t());
}

TEST_F(FreeNamesTest, NotesCapitalsOnce) {
    names_.parameter("X", 0);
    names_.parameter("X", 0);
    names_.parameter("E", 0);
    std::vector<Reading> readings{{.kind = StatementKind::Value, .offset = 0, .text = {}}};
    notes_.hand_over(readings);
    EXPECT_EQ(readings[0].notes,
              (std::vector<std::string>{"X is a parameter; for the coordinate type x",
                                        "E is a parameter; for 2.718... type e"}));
}

}  // namespace
}  // namespace zeroset::free_names_test
