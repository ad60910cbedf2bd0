#include "engine/language/vocabulary/words_vocabulary.hpp"

#include "engine/language/vocabulary/functions.hpp"

#include <algorithm>

namespace zeroset {
namespace {

constexpr std::array<std::string_view, 13> values{"x",     "y",   "z",  "w",   "t", "r",     "rho",
                                                  "theta", "phi", "pi", "tau", "e", "golden"};
constexpr std::array<std::string_view, 7> places{"x", "y", "z", "r", "rho", "theta", "phi"};
constexpr std::string_view coordinates = "xyzwtr";
constexpr std::array<std::string_view, 3> logic_words{"and", "or", "not"};
constexpr std::size_t longest_word = 24;

}  // namespace

std::span<const std::string_view> built_in_values() { return values; }

bool is_built_in_value(std::string_view name) {
    return std::ranges::find(values, name) != values.end();
}

bool is_place(std::string_view name) { return std::ranges::find(places, name) != places.end(); }

bool is_logic_word(std::string_view word) {
    return std::ranges::find(logic_words, word) != logic_words.end();
}

bool is_built_in(std::string_view word) {
    return is_built_in_value(word) || find_fixed_function(word) != nullptr || is_logic_word(word);
}

std::string in_small_letters(std::string_view word) {
    std::string result(word);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
    }
    return result;
}

Vocabulary::Vocabulary() {
    for (const std::string_view value : values)
        expect_word(value);
    for (const std::string_view function : function_spellings())
        expect_word(function);
}

void Vocabulary::expect_word(std::string_view word) {
    if (word.empty() || word.size() > longest_word) return;
    lengths_.at(static_cast<unsigned char>(word[0])) |= 1U << word.size();
}

void Vocabulary::add_word(std::string_view word) {
    words_.emplace(word);
    expect_word(word);
}

bool Vocabulary::may_know(std::string_view word) const {
    return (lengths_.at(static_cast<unsigned char>(word[0])) & (1U << word.size())) != 0;
}

bool Vocabulary::knows_letter(char letter) const {
    return is_built_in_value({&letter, 1}) || has_letter(letter);
}

bool Vocabulary::knows_word(std::string_view word) const {
    return !is_logic_word(word) && (is_built_in(word) || words_.contains(word));
}

bool Vocabulary::knows(std::string_view name) const {
    return name.size() == 1 ? knows_letter(name[0]) : may_know(name) && knows_word(name);
}

std::vector<std::size_t> Vocabulary::pieces(std::string_view run, bool subscript) const {
    const auto unknown = std::ranges::count_if(run, [&](char c) { return !knows_letter(c); });
    const auto known_places =
        std::ranges::count_if(run, [](char c) { return coordinates.contains(c); });
    if (unknown == 1 && known_places + unknown == std::ssize(run)) {
        return std::vector<std::size_t>(run.size(), 1);  // an unknown letter, as a in axy, is a
                                                         // coefficient
    }
    // Splits the run into the fewest names: best[i] names for its first i letters, the last of them
    // of last[i] letters.
    constexpr std::size_t never = ~std::size_t{0};
    std::vector<std::size_t> best(run.size() + 1, never);
    std::vector<std::size_t> last(run.size() + 1, 0);
    best[0] = 0;
    for (std::size_t end = 1; end <= run.size(); ++end) {
        const bool only_letter = subscript && end == run.size();
        const std::size_t most = only_letter ? 1 : std::min(end, longest_word);
        for (std::size_t length = most; length >= 1; --length) {
            const std::size_t start = end - length;
            if (best[start] == never || best[start] + 1 >= best[end]) continue;
            const std::string_view piece = run.substr(start, length);
            if (piece == "e" && find_fixed_function(run.substr(start - last[start], last[start])))
                continue;  // "sine" is not sin(e)
            if (!only_letter && !knows(piece)) continue;
            best[end] = best[start] + 1;
            last[end] = length;
        }
    }
    std::vector<std::size_t> lengths;
    if (best.back() == never) return lengths;
    for (std::size_t end = run.size(); end > 0; end -= last[end])
        lengths.push_back(last[end]);
    std::ranges::reverse(lengths);
    return lengths;
}

}  // namespace zeroset
