#include "ui/model/text_match.hpp"

#include <gtest/gtest.h>

namespace zeroset::ui::text_match_test {
namespace {

TEST(TextMatch, NeedsNoAccents) {
    EXPECT_TRUE(contains("C\xC3\xA1mara", "camara"));
    EXPECT_TRUE(contains("Enregistrer l'\xC3\xA9tat", "etat"));
    EXPECT_TRUE(contains("Espa\xC3\xB1ol", "espanol"));
    EXPECT_TRUE(
        contains("\xC3\x9C"
                 "bersicht",
                 "\xC3\xBC"
                 "ber"))
        << "capitals with accents are like small letters";
    EXPECT_TRUE(contains("l\xE2\x80\x99\xC5\x93il", "l'oeil"));
    EXPECT_FALSE(contains("Camera", "kamera"));
    EXPECT_TRUE(contains("anything", ""));
}

TEST(TextMatch, FindsPhrasesWithoutAccents) {
    constexpr const char* phrases = "punto, selecci\xC3\xB3n";
    EXPECT_EQ(phrase_found(phrases, "seleccion"), "selecci\xC3\xB3n");
    EXPECT_EQ(phrase_found(phrases, "leccion"), "") << "it begins no word";
    EXPECT_EQ(phrase_found(phrases, " "), "");
}

TEST(TextMatch, FindsAbbreviationsWithoutAccents) {
    EXPECT_TRUE(
        abbreviation_score("Cr\xC3\xA9"
                           "er une vue",
                           "creer vue"));
    EXPECT_EQ(abbreviation_score("View", "vx"), std::nullopt);
}

TEST(TextMatch, KeepsLettersThatAreNotLatin) {
    EXPECT_TRUE(contains("\xCE\xB8 theta", "\xCE\xB8"));
    EXPECT_FALSE(contains("\xCE\xB8", "\xCF\x86"));
    EXPECT_TRUE(contains("2 \xC3\x97 3", "\xC3\x97")) << "a sign, not a letter";
}

}  // namespace
}  // namespace zeroset::ui::text_match_test
