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

namespace zeroset::test::language_test {
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
        // All of these sections but the last are of functions that no other program named.
        constexpr std::size_t sections = 11;
        const bool is_foreign = function.is_of_library() && !function.is_word();
        const auto all = std::span(help).last(sections);
        const auto lists = is_foreign ? all.last(1) : all.first(sections - 1);
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
        if (function.section != WordSection::Bodies) continue;
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
        const bool names_a_file = entry.typed.contains('"');
        if (!entry.typed.contains('=') || names_a_file) continue;
        const auto program = read_formula(entry.typed + "\nx + y + z = 0");
        EXPECT_TRUE(program) << entry.typed << ": " << program.error().reason;
    }
}

}  // namespace
}  // namespace zeroset::test::language_test
