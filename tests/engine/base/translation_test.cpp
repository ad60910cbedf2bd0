#include "engine/base/translation.hpp"

#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace zeroset::translation_test {
namespace {

/// Speaks English again when a test is over.
class Translations : public testing::Test {
protected:
    ~Translations() override { set_language(Language::English); }
};

TEST_F(Translations, AreEnglishAtFirst) {
    EXPECT_EQ(language(), Language::English);
    EXPECT_STREQ(tr("Gallery"), "Gallery");
    EXPECT_EQ(decimal_mark(), '.');
}

TEST_F(Translations, FollowTheLanguage) {
    set_language(Language::German, ',');
    EXPECT_STREQ(tr("Language"), "Sprache");
    EXPECT_STREQ(tr_in("key", "Ctrl"), "Strg");
    EXPECT_STREQ(tr("Ctrl"), "Ctrl") << "without its context it is no text of the program";
    set_language(Language::French, ',');
    EXPECT_STREQ(tr("Language"), "Langue");
    set_language(Language::Spanish, ',');
    EXPECT_STREQ(tr("Language"), "Idioma");
    set_language(Language::English);
    EXPECT_STREQ(tr("Language"), "Language");
}

TEST_F(Translations, LeaveWhatNoCatalogHas) {
    set_language(Language::German, ',');
    EXPECT_STREQ(tr("no text of the program"), "no text of the program");
    EXPECT_STREQ(tr(""), "") << "its entry is the catalog's head";
}

TEST_F(Translations, AreHandedToOtherThreads) {
    set_language(Language::German, ',');
    std::string seen, handed;
    std::thread([&seen] { seen = tr("Language"); }).join();
    EXPECT_EQ(seen, "Language");
    std::thread(in_this_style([&handed] { handed = tr("Language") + localized("2.5"); })).join();
    EXPECT_EQ(handed, "Sprache2,5");
}

TEST_F(Translations, LastUntilTheEndOfAScope) {
    set_language(Language::German, ',');
    {
        const WithTextStyle french({.language = Language::French, .decimal_mark = '.'});
        EXPECT_STREQ(tr("Language"), "Langue");
    }
    EXPECT_STREQ(tr("Language"), "Sprache");
    EXPECT_EQ(decimal_mark(), ',');
}

TEST_F(Translations, StayWhereTheyAreWhenTheLanguageChanges) {
    set_language(Language::German, ',');
    const char* const german = tr("Language");
    set_language(Language::French, ',');
    EXPECT_STREQ(german, "Sprache");
}

TEST(FilledPatterns, HaveTheirValuesInAnyOrder) {
    EXPECT_EQ(filled("{0} of {1}", {"1", "2"}), "1 of 2");
    EXPECT_EQ(filled("{1}: {0}{0}", {"a", "b"}), "b: aa");
    EXPECT_EQ(filled("{0}", {"{1}", "x"}), "{1}") << "values are no patterns";
}

TEST(FilledPatterns, KeepOtherBraces) {
    EXPECT_EQ(filled("{z < 1} {2} {} {", {"a"}), "{z < 1} {2} {} {");
    EXPECT_EQ(filled("", {"a"}), "");
}

TEST_F(Translations, WriteNumbersWithTheMarkOfTheLanguage) {
    EXPECT_EQ(localized("2.5"), "2.5");
    set_language(Language::German, ',');
    EXPECT_EQ(localized("-1.25e-3"), "-1,25e-3");
    set_language(Language::German, '.');
    EXPECT_EQ(localized("2.5"), "2.5") << "as in Switzerland";
}

}  // namespace
}  // namespace zeroset::translation_test
