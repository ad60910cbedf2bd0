#include "app/cli/language.hpp"

#include "engine/language/help.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "pipeline/formula.hpp"
#include "tests/support/formulas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <span>
#include <string>

// Tests of the page on the formula language, which is generated from the program's tables.

namespace zeroset::test {
namespace {

TEST(Language, ThePageIsTheOneInTheDocuments) {
    std::ifstream file(ZEROSET_SOURCE_DIR "/resources/docs/language.md");
    const std::string page(std::istreambuf_iterator<char>(file), {});
    EXPECT_EQ(page, language_page())
        << "write it anew: zeroset language > resources/docs/language.md";
}

TEST(Language, TheHelpHasEveryFunction) {
    const auto help = language_help();
    for (const Function& function : functions()) {
        EXPECT_FALSE(function.meaning.empty()) << function.name;
        const std::string start = std::string(function.name) + "(";
        const std::size_t sections = function.is_word() ? 6 : function.is_of_library() ? 1 : 7;
        const auto lists = std::span(help).last(sections).first(function.is_word() ? 5 : 1);
        EXPECT_TRUE(std::ranges::any_of(lists, [&](const HelpSection& list) {
            return std::ranges::any_of(list.entries, [&](const HelpEntry& entry) {
                return entry.typed.starts_with(start);
            });
        })) << function.name;
    }
}

TEST(Language, ThePicturesOfShapesAreInTheDocuments) {
    std::size_t pictures = 0;
    for (const Function& function : functions()) {
        if (function.section != WordSection::Shapes) continue;
        ++pictures;
        const std::string name = "shapes/" + std::string(function.name) + ".png";
        EXPECT_TRUE(std::ifstream(ZEROSET_SOURCE_DIR "/resources/docs/" + name).good()) << name;
        EXPECT_TRUE(language_page().contains("(" + name + ")")) << name;
    }
    EXPECT_GT(pictures, 10);
}

TEST(Language, TheStatementsOfThePageAreRead) {
    const auto help = language_help();
    for (const HelpEntry& entry : help.front().entries) {
        if (!entry.typed.contains('=')) continue;
        const auto program = read_formula(entry.typed + "\nx + y + z = 0");
        EXPECT_TRUE(program) << entry.typed << ": " << program.error().reason;
    }
}

}  // namespace
}  // namespace zeroset::test
