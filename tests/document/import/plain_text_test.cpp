#include "document/import/plain_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zeroset::test::plain_text_test {
namespace {

std::string utf16(const std::u16string& text, bool big_endian) {
    std::string bytes = big_endian ? "\xfe\xff" : "\xff\xfe";
    for (const char16_t unit : text) {
        const auto high = static_cast<char>(unit >> 8U);
        const auto low = static_cast<char>(unit & 0xFFU);
        bytes += big_endian ? high : low;
        bytes += big_endian ? low : high;
    }
    return bytes;
}

TEST(PlainText, IsUtf8OfAnyEncodingWithAMark) {
    for (const bool big_endian : {false, true})
        EXPECT_EQ(plain_text(utf16(u"x² + é = \u20ac \U0001F600", big_endian)), "x² + é = € 😀");
    EXPECT_EQ(plain_text("\xef\xbb\xbfx = 1"), "x = 1");
    EXPECT_EQ(plain_text("x = 1"), "x = 1");
    // Halves of pairs, and of a character
    EXPECT_EQ(plain_text(utf16({0xD800, u'a', 0xDC00}, true) + "b"), "\uFFFDa\uFFFD");
    EXPECT_EQ(plain_text(utf16({0xD800}, false)), "\uFFFD");
    EXPECT_EQ(plain_text("\xff\xfe"), "");
}

TEST(PlainText, HasLineFeeds) {
    EXPECT_EQ(plain_text("a\rb\r\rc\r\nd\ne\r"), "a\nb\n\nc\r\nd\ne\n");
}

}  // namespace
}  // namespace zeroset::test::plain_text_test
