#include "ui/model/text_match.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace zeroset::ui {
namespace {

constexpr int for_a_match = 4;
constexpr int for_a_neighbour = 8;
constexpr int for_a_beginning = 10;
/// Score of a place where no abbreviation can end; sums with it stay negative.
constexpr int impossible = -1'000'000;

char lower(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

/// The letter of ASCII that people type for a Latin letter U+00C0 to U+00FF; 0: none.
char plain_letter(unsigned code) {
    constexpr std::string_view capitals("aaaaaaaceeeeiiiidnooooo\0ouuuuyts", 32);
    constexpr std::string_view small("aaaaaaaceeeeiiiidnooooo\0ouuuuyty", 32);
    return code < 0xE0U ? capitals[code - 0xC0U] : small[code - 0xE0U];
}

/// The characters that people type for a sign that begins the text, and the sign's bytes; 0 bytes:
/// it is none of these.
std::pair<std::string_view, std::size_t> in_ascii(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> signs{
        {{"\xE2\x80\x99", "'"}, {"\xC5\x93", "oe"}, {"\xC5\x92", "oe"}, {"\xE2\x80\xAF", " "}}};
    for (const auto& [sign, typed] : signs) {
        if (text.starts_with(sign)) return {typed, sign.size()};
    }
    return {};
}

/// The text as it is compared: small letters, without accents.
std::string folded(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (const auto [letters, bytes] = in_ascii(text.substr(i)); bytes > 0) {
            result += letters;
            i += bytes - 1;
            continue;
        }
        const auto byte = static_cast<unsigned char>(text[i]);
        const bool is_latin = byte == 0xC3U && i + 1 < text.size();
        const char plain =
            is_latin ? plain_letter(0xC0U + (static_cast<unsigned char>(text[i + 1]) & 0x3FU))
                     : '\0';
        if (plain != '\0') ++i;
        result += plain != '\0' ? plain : lower(text[i]);
    }
    return result;
}

bool is_part_of_word(char letter) {
    const char small = lower(letter);
    return (small >= 'a' && small <= 'z') || (letter >= '0' && letter <= '9') ||
           static_cast<unsigned char>(letter) >= 0x80U;
}

bool begins_word(std::string_view text, std::size_t at) {
    return is_part_of_word(text[at]) && (at == 0 || !is_part_of_word(text[at - 1]));
}

/// From the folded text's best scores with the last typed character at each place of the text to
/// those with one more, `letter`.
std::vector<int> extended(std::string_view text, char letter, const std::vector<int>& scores,
                          bool first) {
    std::vector<int> next(text.size(), impossible);
    int best_before = first ? 0 : impossible;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == letter) {
            const int here = for_a_match + (begins_word(text, i) ? for_a_beginning : 0);
            const int beside = !first && i > 0 ? scores[i - 1] + for_a_neighbour : impossible;
            next[i] = std::max(best_before, beside) + here;
        }
        if (!first) best_before = std::max(best_before, scores[i]);
    }
    return next;
}

/// Whether the text begins with what is typed, both folded, spaces in either aside.
bool begins_with(std::string_view text, std::string_view typed) {
    std::size_t at = 0;
    for (const char letter : typed) {
        if (letter == ' ') continue;
        while (at < text.size() && text[at] == ' ')
            ++at;
        if (at == text.size() || text[at] != letter) return false;
        ++at;
    }
    return true;
}

/// How close one word comes to a text, both folded; nothing where its letters are scattered.
std::optional<Closeness> closeness_of(std::string_view text, std::string_view word) {
    std::optional<Closeness> best;
    for (std::size_t at = text.find(word); at != std::string_view::npos;
         at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool begins = at == 0 || !is_part_of_word(text[at - 1]);
        const bool ends = end == text.size() || !is_part_of_word(text[end]);
        const Closeness here = !begins ? Closeness::Inside
                               : ends  ? Closeness::WholeWords
                                       : Closeness::Beginnings;
        best = std::max(best.value_or(here), here);
    }
    return best;
}

}  // namespace

bool contains(std::string_view text, std::string_view part) {
    return folded(text).contains(folded(part));
}

bool contains_words(std::string_view text, std::string_view words) {
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(' '), words.size());
        if (!contains(text, words.substr(0, end))) return false;
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return true;
}

std::string_view phrase_found(std::string_view phrases, std::string_view typed) {
    constexpr std::string_view between = ", ";
    if (typed.find_first_not_of(' ') == std::string_view::npos) return {};
    const std::string wanted = folded(typed);
    while (!phrases.empty()) {
        const std::size_t end = std::min(phrases.find(between), phrases.size());
        const std::string phrase = folded(phrases.substr(0, end));
        for (std::size_t at = 0; at < phrase.size(); ++at) {
            if (begins_word(phrase, at) && begins_with(std::string_view(phrase).substr(at), wanted))
                return phrases.substr(0, end);
        }
        phrases.remove_prefix(std::min(end + between.size(), phrases.size()));
    }
    return {};
}

std::optional<int> abbreviation_score(std::string_view text, std::string_view typed) {
    const std::string in = folded(text);
    std::vector<int> scores;
    for (const char letter : folded(typed)) {
        if (letter != ' ') scores = extended(in, letter, scores, scores.empty());
        if (letter != ' ' && scores.empty()) return std::nullopt;
    }
    const int length = static_cast<int>(in.size());
    if (scores.empty()) return -length;
    const int best = std::ranges::max(scores);
    if (best < 0) return std::nullopt;
    constexpr int for_length = 16;
    return for_length * best - length;
}

std::optional<Match> match_of(std::string_view text, std::string_view typed) {
    const auto score = abbreviation_score(text, typed);
    const std::string in = folded(text);
    const std::string wanted = folded(typed);
    auto worst = Closeness::WholeWords;
    for (const auto& part : std::views::split(wanted, ' ')) {
        const std::string_view word(part.begin(), part.end());
        const auto found = word.empty() ? Closeness::WholeWords : closeness_of(in, word);
        if (!found && !score) return std::nullopt;
        worst = std::min(worst, found.value_or(Closeness::Scattered));
    }
    return Match{.closeness = worst, .score = score.value_or(-static_cast<int>(in.size()))};
}

}  // namespace zeroset::ui
