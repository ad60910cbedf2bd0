#include "ui/model/text_match.hpp"

#include <algorithm>
#include <cstddef>
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

bool is_part_of_word(char letter) {
    const char small = lower(letter);
    return (small >= 'a' && small <= 'z') || (letter >= '0' && letter <= '9') ||
           static_cast<unsigned char>(letter) >= 0x80U;
}

bool begins_word(std::string_view text, std::size_t at) {
    return is_part_of_word(text[at]) && (at == 0 || !is_part_of_word(text[at - 1]));
}

/// From the best scores with the last typed character at each place of the text to those with one
/// more, `letter`.
std::vector<int> extended(std::string_view text, char letter, const std::vector<int>& scores,
                          bool first) {
    std::vector<int> next(text.size(), impossible);
    int best_before = first ? 0 : impossible;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (lower(text[i]) == lower(letter)) {
            const int here = for_a_match + (begins_word(text, i) ? for_a_beginning : 0);
            const int beside = !first && i > 0 ? scores[i - 1] + for_a_neighbour : impossible;
            next[i] = std::max(best_before, beside) + here;
        }
        if (!first) best_before = std::max(best_before, scores[i]);
    }
    return next;
}

/// Whether the text begins with what is typed, spaces in either aside.
bool begins_with(std::string_view text, std::string_view typed) {
    std::size_t at = 0;
    for (const char letter : typed) {
        if (letter == ' ') continue;
        while (at < text.size() && text[at] == ' ')
            ++at;
        if (at == text.size() || lower(text[at]) != lower(letter)) return false;
        ++at;
    }
    return true;
}

}  // namespace

bool contains(std::string_view text, std::string_view part) {
    return std::ranges::search(text, part, {}, lower, lower).begin() != text.end() || part.empty();
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
    while (!phrases.empty()) {
        const std::size_t end = std::min(phrases.find(between), phrases.size());
        const std::string_view phrase = phrases.substr(0, end);
        for (std::size_t at = 0; at < phrase.size(); ++at) {
            if (begins_word(phrase, at) && begins_with(phrase.substr(at), typed)) return phrase;
        }
        phrases.remove_prefix(std::min(end + between.size(), phrases.size()));
    }
    return {};
}

std::optional<int> abbreviation_score(std::string_view text, std::string_view typed) {
    std::vector<int> scores;
    for (const char letter : typed) {
        if (letter != ' ') scores = extended(text, letter, scores, scores.empty());
        if (letter != ' ' && scores.empty()) return std::nullopt;
    }
    const int length = static_cast<int>(text.size());
    if (scores.empty()) return -length;
    const int best = std::ranges::max(scores);
    if (best < 0) return std::nullopt;
    constexpr int for_length = 16;
    return for_length * best - length;
}

}  // namespace zeroset::ui
