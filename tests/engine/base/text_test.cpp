#include "engine/base/text.hpp"

#include <gtest/gtest.h>

#include <string>

// Places in a text, counted in characters, of any number of bytes each.

namespace zeroset::test::text_test {
namespace {

TEST(ColumnOf, CountsCharactersFromOne) {
    EXPECT_EQ(column_of("", 0), 1U);
    EXPECT_EQ(column_of("abc", 0), 1U);
    EXPECT_EQ(column_of("abc", 2), 3U);
    EXPECT_EQ(column_of("abc", 3), 4U);
    EXPECT_EQ(column_of("abc", 99), 4U);
}

TEST(ColumnOf, CountsCharactersOfManyBytesOnce) {
    const std::string text = "\u00e9\u2212\U0001d465+";  // 2, 3 and 4 bytes
    EXPECT_EQ(column_of(text, 0), 1U);
    EXPECT_EQ(column_of(text, 2), 2U);
    EXPECT_EQ(column_of(text, 5), 3U);
    EXPECT_EQ(column_of(text, 9), 4U);
    EXPECT_EQ(column_of(text, 10), 5U);
}

TEST(ColumnOf, StartsAnewInEachLine) {
    const std::string text = "x +\n \u00e9 )\ny";
    EXPECT_EQ(column_of(text, 3), 4U);  // the end of the first line
    EXPECT_EQ(column_of(text, 4), 1U);
    EXPECT_EQ(column_of(text, 8), 4U);  // the parenthesis
    EXPECT_EQ(column_of(text, 10), 1U);
}

TEST(LineAt, FindsTheLineOfAByte) {
    const std::string text = "first\n\nthird";
    EXPECT_EQ(line_at(text, 0), "first");
    EXPECT_EQ(line_at(text, 4), "first");
    EXPECT_EQ(line_at(text, 5), "first");
    EXPECT_EQ(line_at(text, 6), "");
    EXPECT_EQ(line_at(text, 7), "third");
    EXPECT_EQ(line_at(text, 12), "third");
    EXPECT_EQ(line_at(text, 99), "third");
    EXPECT_EQ(line_at("", 0), "");
    EXPECT_EQ(line_at("\n", 1), "");
}

TEST(Excerpt, KeepsAShortLine) {
    const Excerpt part = excerpt("x\t+ \u00e9", 4);
    EXPECT_EQ(part.text, "x + \u00e9");
    EXPECT_EQ(part.caret, 4U);
}

/// The character of an excerpt above its caret. The text is ASCII.
char above_caret(const Excerpt& part) {
    return part.caret < part.text.size() ? part.text[part.caret] : '\0';
}

TEST(Excerpt, CutsALongLineAroundTheCaret) {
    std::string line(1000, '.');
    for (const std::size_t place : {0U, 49U, 50U, 51U, 500U, 949U, 998U, 999U}) {
        line[place] = '!';
        const Excerpt part = excerpt(line, place);
        EXPECT_EQ(above_caret(part), '!') << place;
        EXPECT_LE(part.text.size(), 110U);
        line[place] = '.';
    }
}

TEST(Excerpt, PutsTheCaretBehindTheEnd) {
    EXPECT_EQ(excerpt("x +", 3).caret, 3U);
    const std::string line(300, 'x');
    const Excerpt part = excerpt(line, line.size());
    EXPECT_EQ(part.caret, part.text.size());
}

TEST(Excerpt, CountsCharactersOfManyBytesOnce) {
    std::string line;
    for (int i = 0; i < 200; ++i)
        line += "\u00e9";
    line += ")";
    const Excerpt part = excerpt(line, 200);
    EXPECT_EQ(part.text.back(), ')');
    EXPECT_EQ(column_of(part.text, part.text.size() - 1), part.caret + 1);
}

TEST(Trimmed, DropsBlanksAtBothEnds) {
    EXPECT_EQ(trimmed(" \t x + y \r\n"), "x + y");
    EXPECT_EQ(trimmed(""), "");
    EXPECT_EQ(trimmed(" \n"), "");
}

TEST(ShortNumber, IsAsAPersonWritesIt) {
    EXPECT_EQ(short_number(2.0), "2");
    EXPECT_EQ(short_number(-0.5), "-0.5");
    EXPECT_EQ(short_number(1.0 / 3.0), "0.333333");
    EXPECT_EQ(short_number(0.1, 17), "0.10000000000000001");
}

}  // namespace
}  // namespace zeroset::test::text_test
