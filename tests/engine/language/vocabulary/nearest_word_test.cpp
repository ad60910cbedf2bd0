#include "engine/language/vocabulary/nearest_word.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace zeroset::nearest_word_test {
namespace {

constexpr std::array<std::string_view, 6> words{"x", "sin", "cos", "acos", "sqrt", "atan2"};

TEST(NearestWord, FindsTheWordItself) {
    for (const std::string_view word : words)
        EXPECT_EQ(nearest_word(word, words), word);
}

TEST(NearestWord, ForgivesOneSlip) {
    EXPECT_EQ(nearest_word("sqr", words), "sqrt");
    EXPECT_EQ(nearest_word("sqqrt", words), "sqrt");
    EXPECT_EQ(nearest_word("sprt", words), "sqrt");
    EXPECT_EQ(nearest_word("sqtr", words), "sqrt");
    EXPECT_EQ(nearest_word("atan", words), "atan2");
    EXPECT_EQ(nearest_word("snn", words), "sin");
}

TEST(NearestWord, TakesTheFirstOfEquals) {
    constexpr std::array<std::string_view, 2> pair{"ab", "ba"};
    EXPECT_EQ(nearest_word("zz", pair), "ab");
}

TEST(NearestWord, TakesAnyText) {
    EXPECT_EQ(nearest_word("", words), "x");
    EXPECT_EQ(nearest_word(std::string(100'000, 'q'), words), "sqrt");
}

}  // namespace
}  // namespace zeroset::nearest_word_test
