// Tests of the words by which actions are found beside their names.

#include "ui/actions/other_words.hpp"

#include "ui/actions/actions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <string_view>

namespace zeroset::ui::other_words_test {
namespace {

TEST(OtherWords, AreOfActionsThatThereAre) {
    std::set<std::string_view> seen;
    for (const OtherWords& item : other_words()) {
        const auto found = std::ranges::find(actions(), item.action, &Action::name);
        EXPECT_NE(found, actions().end()) << item.action;
        EXPECT_TRUE(seen.insert(item.action).second) << item.action << " twice";
        EXPECT_FALSE(item.words.empty()) << item.action;
        for (const char letter : item.words)
            EXPECT_FALSE(std::isupper(static_cast<unsigned char>(letter))) << item.words;
    }
    EXPECT_EQ(other_words_of("no such action"), "");
}

}  // namespace
}  // namespace zeroset::ui::other_words_test
