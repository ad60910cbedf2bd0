#include "engine/language/dialects/source_text.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace zeroset::source_text_test {
namespace {

TEST(SourceText, KnowsWhereItsBytesWereTyped) {
    const std::string_view typed = "Plot[a b, c]";
    SourceText text(typed);
    text.put("z = ", 0);
    text.keep(typed.substr(5, 3));
    text.put("; ", 8);
    text.keep(typed.substr(10, 1));
    EXPECT_EQ(text.words(), "z = a b; c");
    EXPECT_EQ(text.typed_offset(0), 0U);
    EXPECT_EQ(text.typed_offset(3), 0U);
    EXPECT_EQ(text.typed_offset(4), 5U);
    EXPECT_EQ(text.typed_offset(6), 7U);
    EXPECT_EQ(text.typed_offset(8), 8U);
    EXPECT_EQ(text.typed_offset(9), 10U);
    EXPECT_EQ(text.typed_offset(10), 11U);
    EXPECT_EQ(text.place_of(6), 5U);
    EXPECT_EQ(text.place_of(10), 9U);
    EXPECT_EQ(text.place_of(12), text.words().size());
}

TEST(SourceText, ForgetsWhatIsCutBack) {
    const std::string_view typed = "a b c";
    SourceText text(typed);
    text.keep(typed.substr(0, 2));
    text.put("sum(", 2);
    text.keep(typed.substr(2, 1));
    text.cut_back(2);
    text.keep(typed.substr(4));
    EXPECT_EQ(text.words(), "a c");
    EXPECT_EQ(text.typed_offset(2), 4U);
    EXPECT_TRUE(text.is_changed());
}

TEST(SourceText, TellsPartsFromOtherWords) {
    const std::string_view typed = "abc";
    const SourceText text(typed);
    EXPECT_TRUE(text.is_part(typed.substr(1, 1)));
    EXPECT_TRUE(text.is_part(typed));
    EXPECT_FALSE(text.is_part("abc2"));
}

}  // namespace
}  // namespace zeroset::source_text_test
