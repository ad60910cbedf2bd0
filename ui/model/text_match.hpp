#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset::ui {

/// Whether `part` occurs in `text`; capitals count as small letters.
bool contains(std::string_view text, std::string_view part);

/// Whether each of the words (apart by spaces) occurs in `text`.
bool contains_words(std::string_view text, std::string_view words);

/// The first of the phrases, apart by ", ", in which `typed` begins a word; spaces aside, and
/// capitals count as small letters. Empty if there is none, or nothing typed.
std::string_view phrase_found(std::string_view phrases, std::string_view typed);

/// How well `typed` abbreviates `text`: its characters occur in this order, spaces aside. Higher is
/// better: beginnings of words and runs of neighbours count most, then shortness. Nothing when it
/// does not.
std::optional<int> abbreviation_score(std::string_view text, std::string_view typed);

/// Where the words that are typed stand in a text that they find, the worst first.
enum class Closeness : std::uint8_t { Scattered, Inside, Beginnings, WholeWords };

/// How well a text is found: a greater one is better.
struct Match {
    Closeness closeness = Closeness::Scattered;  ///< of the word that stands worst
    int score = 0;                               ///< as abbreviation_score

    auto operator<=>(const Match&) const = default;
};

/// How well `typed` finds `text`: its words in any order, or its letters in theirs. Nothing when it
/// does not.
std::optional<Match> match_of(std::string_view text, std::string_view typed);

}  // namespace zeroset::ui
