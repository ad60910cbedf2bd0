#include "engine/language/vocabulary/nearest_word.hpp"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

bool alike(char a, char b) {
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return small(a) == small(b);
}

/// The optimal string alignment distance of a and b.
std::size_t distance(std::string_view a, std::string_view b) {
    const std::size_t width = b.size() + 1;
    std::vector<std::size_t> d((a.size() + 1) * width);
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            std::size_t& best = d[i * width + j];
            if (i == 0 || j == 0) {
                best = i + j;
                continue;
            }
            best = std::min({d[(i - 1) * width + j] + 1, d[i * width + j - 1] + 1,
                             d[(i - 1) * width + j - 1] + (alike(a[i - 1], b[j - 1]) ? 0U : 1U)});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) best = std::min(best, d[(i - 2) * width + j - 2] + 1);
        }
    }
    return d.back();
}

}  // namespace

std::string_view nearest_word(std::string_view typed, std::span<const std::string_view> words) {
    assert(!words.empty());
    typed = typed.substr(0, 64);
    // Among words as near, one that begins like what is typed: sin rather than sign for sinn.
    return *std::ranges::min_element(words, {}, [&](std::string_view word) {
        const auto after = std::ranges::mismatch(typed, word, alike).in1;
        return std::pair(distance(typed, word), typed.end() - after);
    });
}

std::optional<std::string_view> meant_word(std::string_view typed,
                                           std::span<const std::string_view> words) {
    typed = typed.substr(0, 64);
    const std::string_view nearest = nearest_word(typed, words);
    if (2 * distance(typed, nearest) > typed.size()) return std::nullopt;
    return nearest;
}

}  // namespace zeroset
