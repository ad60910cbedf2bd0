#include "engine/base/language.hpp"

#include <gtest/gtest.h>

namespace zeroset::language_test {
namespace {

TEST(Languages, AreNamedByTheirCodes) {
    for (const Language language : all_languages) {
        EXPECT_EQ(language_named(name_of(language)), language);
        EXPECT_STRNE(own_name(language), "");
    }
    EXPECT_EQ(language_named("it"), std::nullopt);
    EXPECT_EQ(language_named(""), std::nullopt);
}

TEST(Languages, OfTheDesktopAreWhatItsVariablesWish) {
    using Variables = LocaleVariables;
    EXPECT_EQ(desktop_language({}), Language::English);
    EXPECT_EQ(desktop_language({.lang = "de_AT.UTF-8"}), Language::German);
    EXPECT_EQ(desktop_language({.lang = "fr"}), Language::French);
    EXPECT_EQ(desktop_language({.lang = "es_MX@euro"}), Language::Spanish);
    EXPECT_EQ(desktop_language({.lang = "it_IT.UTF-8"}), Language::English) << "not there";
    const Variables messages{.lc_messages = "fr_FR.UTF-8", .lang = "de_DE.UTF-8"};
    EXPECT_EQ(desktop_language(messages), Language::French);
    const Variables all{.lc_all = "es_ES.UTF-8", .lc_messages = "fr_FR.UTF-8", .lang = "de_DE"};
    EXPECT_EQ(desktop_language(all), Language::Spanish);
}

TEST(Languages, AreTakenInTheOrderOfTheWishes) {
    EXPECT_EQ(desktop_language({.language = "it:fr_CA:de", .lang = "de_DE.UTF-8"}),
              Language::French);
    EXPECT_EQ(desktop_language({.language = "it", .lang = "de_DE.UTF-8"}), Language::German);
    EXPECT_EQ(desktop_language({.language = "de", .lang = "C.UTF-8"}), Language::German);
    // The plain locale speaks English, whatever LANGUAGE says, as in gettext.
    EXPECT_EQ(desktop_language({.language = "de", .lang = "C"}), Language::English);
    EXPECT_EQ(desktop_language({.language = "de"}), Language::English);
}

TEST(Languages, WriteNumbersWithAMark) {
    EXPECT_EQ(decimal_mark_of(Language::English, {}), '.');
    EXPECT_EQ(decimal_mark_of(Language::German, {}), ',');
    EXPECT_EQ(decimal_mark_of(Language::French, {.lang = "de_DE.UTF-8"}), ',');
}

}  // namespace
}  // namespace zeroset::language_test
