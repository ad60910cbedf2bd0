#include "engine/base/text.hpp"

#include <gtest/gtest.h>

#include <string>

// Bytes that others wrote, as a terminal may be shown them.

namespace zeroset::test::printable_test {
namespace {

TEST(Printable, KeepsWords) {
    const std::string text = "x^2 \u2264 1, h\u00F6he \U0001D465";
    EXPECT_EQ(printable(text), text);
    EXPECT_EQ(printable(""), "");
}

TEST(Printable, MarksControlCharacters) {
    EXPECT_EQ(printable("a\x1B[2Jb"), "a\uFFFD[2Jb");
    EXPECT_EQ(printable("a\nb\r\tc"), "a\uFFFDb\uFFFD\uFFFDc");
    EXPECT_EQ(printable(std::string("a\0b\x7F", 4)), "a\uFFFDb\uFFFD");
    EXPECT_EQ(printable("\u009B2J \u00A0"), "\uFFFD2J \u00A0");  // CSI in one character
    EXPECT_EQ(printable("\u202Eabc\u2066\u2028"), "\uFFFDabc\uFFFD\uFFFD");
}

TEST(Printable, MarksBytesThatAreNotUtf8) {
    EXPECT_EQ(printable("\xFBy"), "\uFFFDy");
    EXPECT_EQ(printable("\x80\xBFy"), "\uFFFD\uFFFDy");
    EXPECT_EQ(printable("\xE2\x89"), "\uFFFD\uFFFD");            // cut
    EXPECT_EQ(printable("\xC0\x9B"), "\uFFFD\uFFFD");            // ESC in two bytes
    EXPECT_EQ(printable("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // a surrogate
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");
    EXPECT_EQ(printable("\xC3\xA9\x80"), "\u00E9\uFFFD");
}

}  // namespace
}  // namespace zeroset::test::printable_test
