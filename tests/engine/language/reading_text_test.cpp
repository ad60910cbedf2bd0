// Values as readings have them.

#include "engine/language/rows/reading_text.hpp"

#include "engine/expr/simplify.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zeroset::reading_text_test {
namespace {

TEST(ReadingText, ListsAndVectorsHaveTheirSigns) {
    Notes notes;
    GraphValues values(notes);
    FreeNames names(values);
    const BuiltValue c = names.parameter("c", 0).value();
    const BuiltValue pair = BuiltValue::vector({c, {.id = values.builder().variable(0)}});
    const ReadingText text(values, names, 1);
    EXPECT_EQ(text.of(BuiltValue::list({pair, c})), "[(c, x), c]");
}

TEST(ReadingText, ManyDefinitionsShareTheirLength) {
    Notes notes;
    GraphValues values(notes);
    FreeNames names(values);
    NodeId sum = values.builder().variable(0);
    for (int i = 1; i < 200; ++i)
        sum = make_add(values.builder(), values.builder().constant(i),
                       make_negate(values.builder(), sum));
    const std::string alone = ReadingText(values, names, 1).of(sum);
    const std::string of_many = ReadingText(values, names, 100'000).of(sum);
    EXPECT_LT(of_many.size(), 60U);
    EXPECT_GT(alone.size(), 500U);
    EXPECT_TRUE(of_many.ends_with("..."));
}

}  // namespace
}  // namespace zeroset::reading_text_test
