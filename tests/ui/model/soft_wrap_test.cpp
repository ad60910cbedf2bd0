#include "ui/model/soft_wrap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <string_view>

// Long lines that go on in the next line of their field.

namespace zeroset::ui::soft_wrap_test {
namespace {

/// Ten characters a line.
WrappedText in_tens(std::string_view plain) {
    return wrapped(plain, 10.0F, [](std::string_view) { return 1.0F; });
}

TEST(SoftWrap, LeavesShortLinesAlone) {
    for (const char* const text : {"", "x", "0123456789", "x = 1\ny = 2\n"}) {
        const WrappedText shown = in_tens(text);
        EXPECT_EQ(shown.text, text);
        EXPECT_TRUE(shown.breaks.empty());
    }
}

TEST(SoftWrap, BreaksBehindAnOperatorWhereOneIsNear) {
    EXPECT_EQ(in_tens("abcdefg + hijk").text, "abcdefg + \nhijk");
    EXPECT_EQ(in_tens("abcdefgh*ijk").text, "abcdefgh*\nijk");
    EXPECT_EQ(in_tens("a + bcdefghijkl").text, "a + bcdefg\nhijkl") << "too far";
    EXPECT_EQ(in_tens("abcdefghijklmnopqrstuvw").text, "abcdefghij\nklmnopqrst\nuvw");
}

TEST(SoftWrap, KeepsRealBreaksAndWholeCharacters) {
    EXPECT_EQ(in_tens("x = 1\nabcdefghijkl").text, "x = 1\nabcdefghij\nkl");
    EXPECT_EQ(in_tens("αβγδεζηθικλμ").text, "αβγδεζηθικ\nλμ");
}

TEST(SoftWrap, KnowsEveryPlaceInBothTexts) {
    const std::string plain = "abcdefghijkl\nmn + opqrstuvwxyz0123";
    const WrappedText shown = in_tens(plain);
    EXPECT_EQ(plain_part(shown, 0, shown.text.size()), plain);
    for (std::size_t at = 0; at <= plain.size(); ++at) {
        const std::size_t place = shown_place(shown, at);
        EXPECT_EQ(plain_place(shown, place), at);
        if (at == plain.size()) continue;
        EXPECT_EQ(shown.text[place], plain[at]) << at;
    }
    EXPECT_EQ(plain_part(shown, 8, 12), "ijk") << shown.text;
}

/// `keys` typed at a place of the plain text, as a field would do it.
PlainEdit typed(const std::string& plain, std::size_t at, const std::string& keys) {
    const WrappedText shown = in_tens(plain);
    const std::size_t place = shown_place(shown, at);
    std::string after = shown.text;
    after.insert(place, keys);
    return plain_edit(shown, after, place + keys.size(), false);
}

TEST(SoftWrap, TakesWhatIsTyped) {
    const std::string plain = "abcdefghijklmnop";
    for (std::size_t at = 0; at <= plain.size(); ++at) {
        for (const char* const keys : {"x", "α", "\n", "k", "xyz = 1\n2"}) {
            std::string wanted = plain;
            wanted.insert(at, keys);
            const PlainEdit edit = typed(plain, at, keys);
            EXPECT_EQ(edit.text, wanted) << at << keys;
            EXPECT_EQ(edit.caret, at + std::string_view(keys).size()) << at << keys;
        }
    }
}

TEST(SoftWrap, DeletesAcrossItsBreaks) {
    const WrappedText shown = in_tens("abcdefghijklm");
    std::string after = shown.text;
    after.erase(10, 1);
    const PlainEdit back = plain_edit(shown, after, 10, false);
    EXPECT_EQ(back.text, "abcdefghiklm");
    EXPECT_EQ(back.caret, 9U);
    const PlainEdit ahead = plain_edit(shown, after, 10, true);
    EXPECT_EQ(ahead.text, "abcdefghijlm");
    EXPECT_EQ(ahead.caret, 10U);
    const WrappedText greek = in_tens("αβγδεζηθικλμ");
    after = greek.text;
    after.erase(20, 1);
    EXPECT_EQ(plain_edit(greek, after, 20, false).text, "αβγδεζηθιλμ");
}

TEST(SoftWrap, ReplacesSelectionsThatHoldBreaks) {
    const WrappedText shown = in_tens("abcdefghijklmnop");
    std::string after = shown.text;
    after.replace(8, 5, "X");
    const PlainEdit edit = plain_edit(shown, after, 9, false);
    EXPECT_EQ(edit.text, "abcdefghXmnop");
    EXPECT_EQ(edit.caret, 9U);
}

TEST(SoftWrap, IsInvisibleToAnyTyping) {
    std::mt19937 random(5);
    const auto below = [&random](std::size_t bound) { return random() % bound; };
    const std::string letters = "ab +*\n=1";
    std::string plain;
    std::size_t caret = 0;
    for (int step = 0; step < 20'000; ++step) {
        const WrappedText shown = in_tens(plain);
        const std::size_t place = shown_place(shown, caret);
        std::string after = shown.text;
        std::string wanted = plain;
        PlainEdit edit;
        if (below(3) > 0 && plain.size() < 60) {
            const std::string key(1, letters[below(letters.size())]);
            after.insert(place, key);
            wanted.insert(caret, key);
            edit = plain_edit(shown, after, place + 1, false);
        } else if (place > 0) {
            after.erase(place - 1, 1);
            wanted.erase(caret - 1, 1);
            edit = plain_edit(shown, after, place - 1, false);
        } else {
            continue;
        }
        ASSERT_EQ(edit.text, wanted);
        plain = edit.text;
        caret = below(plain.size() + 1);
    }
}

}  // namespace
}  // namespace zeroset::ui::soft_wrap_test
