// Values of one graph: what they are of others, and where errors and notes are shown.

#include "engine/language/values/graph_values.hpp"

#include "engine/expr/simplify.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace zeroset::graph_values_test {
namespace {

class GraphValuesTest : public testing::Test {
protected:
    BuiltValue number(double value) {
        return values_.done(values_.builder().constant(value), 0).value();
    }
    BuiltValue vector(double a, double b) { return BuiltValue::vector({number(a), number(b)}); }
    BuiltValue condition() {
        ExprBuilder& builder = values_.builder();
        const NodeId less = make_call(builder, Op::Less, builder.variable(0), builder.variable(1));
        return values_.done(less, 0, true).value();
    }
    std::string text(const BuiltValue& value) {
        return values_.builder().text(value.id, {}, longest_text);
    }
    /// The notes that were added, each with its offset.
    std::vector<std::string> notes() {
        std::vector<Reading> readings;
        for (std::size_t offset = 0; offset < 10; ++offset)
            readings.push_back({.kind = StatementKind::Value, .offset = offset, .text = {}});
        notes_.hand_over(readings);
        std::vector<std::string> all;
        for (const Reading& reading : readings) {
            for (const std::string& note : reading.notes)
                all.push_back(std::to_string(reading.offset) + " " + note);
        }
        return all;
    }

    Notes notes_;
    GraphValues values_{notes_};
};

TEST_F(GraphValuesTest, ListsMapElementByElement) {
    const BuiltValue list = BuiltValue::list({number(1), number(2), number(3)});
    const auto sums = values_.combined(list, number(10), 0, make_add);
    ASSERT_TRUE(sums && sums->is_list());
    ASSERT_EQ(sums->size(), 3U);
    EXPECT_EQ(text(sums->part(2)), "3 + 10");
}

TEST_F(GraphValuesTest, ANumberStandsForEachPartOfVectorsInAList) {
    const BuiltValue list = BuiltValue::list({vector(1, 2), vector(3, 4)});
    const auto products = values_.combined(list, number(5), 0, make_multiply);
    ASSERT_TRUE(products && products->is_list() && products->part(1).is_vector());
    EXPECT_EQ(text(products->part(1).part(0)), "3*5");
}

TEST_F(GraphValuesTest, ValuesOfDifferentSizesAreAnErrorAtTheirOffset) {
    const BuiltValue three = BuiltValue::vector({number(1), number(2), number(3)});
    EXPECT_FALSE(values_.combined(vector(1, 2), three, 7, make_add));
    ASSERT_TRUE(values_.failed());
    const ParseError error = values_.failure().error();
    EXPECT_EQ(error.offset, 7U);
    EXPECT_EQ(error.reason, "a vector of 2 numbers does not go with a vector of 3 numbers");
    EXPECT_FALSE(values_.failed());
}

TEST_F(GraphValuesTest, TheFirstErrorStays) {
    values_.fail_for_vector(1, "first", "");
    values_.fail(2, "second");
    EXPECT_EQ(values_.failure().error().reason, "first");
    EXPECT_TRUE(values_.wanted_vector());
    values_.fail(3, "third");
    EXPECT_FALSE(values_.wanted_vector());
}

TEST_F(GraphValuesTest, AConditionCountsAsANumberWithANote) {
    const auto number = values_.number_of(condition(), 4);
    ASSERT_TRUE(number);
    EXPECT_EQ(values_.builder().node(*number).op, Op::If);
    // The way back leads to the condition itself.
    EXPECT_EQ(values_.condition_of({.id = *number}, 5), condition().id);
    EXPECT_EQ(notes(), std::vector<std::string>{
                           "4 a condition counts as 1 where it holds and as 0 elsewhere"});
}

TEST_F(GraphValuesTest, NoVectorIsANumber) {
    EXPECT_FALSE(values_.number_of(vector(1, 2), 3));
    EXPECT_EQ(values_.failure().error().offset, 3U);
    EXPECT_FALSE(values_.condition_of(vector(1, 2), 6));
    EXPECT_EQ(values_.failure().error().offset, 6U);
}

TEST_F(GraphValuesTest, PartsAreNamedByLetters) {
    const BuiltValue list = BuiltValue::list({vector(1, 2), vector(3, 4)});
    const auto turned = values_.part_of(list, "yx", 0);
    ASSERT_TRUE(turned && turned->is_list());
    EXPECT_EQ(text(turned->part(1).part(0)), "4");
    const auto replaced = values_.with_parts(vector(1, 2), "y", number(9), 0);
    ASSERT_TRUE(replaced);
    EXPECT_EQ(text(replaced->part(0)), "1");
    EXPECT_EQ(text(replaced->part(1)), "9");
    EXPECT_FALSE(values_.part_of(vector(1, 2), "z", 8));
    EXPECT_EQ(values_.failure().error().offset, 8U);
}

TEST_F(GraphValuesTest, UndefinedConstantsAreErrorsUnlessTheyAreKept) {
    EXPECT_FALSE(values_.combined(number(1), number(0), 2, make_divide));
    EXPECT_EQ(values_.failure().error().reason, "this is not a number: a division by 0");
    values_.keep_undefined();
    EXPECT_TRUE(values_.combined(number(2), number(0), 2, make_divide));
}

TEST_F(GraphValuesTest, StepsAreBounded) {
    std::size_t steps = 0;
    while (values_.counts(1))
        ++steps;
    EXPECT_EQ(steps, 10'000'000U);
    EXPECT_EQ(values_.failure().error().hint, "use fewer terms");
}

TEST_F(GraphValuesTest, NodesAreBounded) {
    ExprBuilder& builder = values_.builder();
    for (std::size_t i = 0; i <= ProgramLimits::nodes; ++i)
        builder.variable(static_cast<int>(i));
    EXPECT_FALSE(values_.done(0, 6));
    EXPECT_EQ(values_.failure().error().offset, 6U);
}

TEST_F(GraphValuesTest, KnowsConstantConditions) {
    ExprBuilder& builder = values_.builder();
    const BuiltValue one = number(1);
    const BuiltValue two = number(2);
    const NodeId holds = values_.done(builder.apply(Op::Less, one.id, two.id), 0, true)->id;
    EXPECT_EQ(values_.known_truth(holds), true);
    EXPECT_FALSE(values_.never_holds(holds));
    EXPECT_EQ(values_.known_truth(condition().id), std::nullopt);
    EXPECT_TRUE(values_.uses_space(condition().id));
    EXPECT_EQ(values_.middle_of(two.id), 2.0);
}

}  // namespace
}  // namespace zeroset::graph_values_test
