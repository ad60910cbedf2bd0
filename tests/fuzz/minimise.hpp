#pragma once

#include "tests/fuzz/mutator.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace zeroset::test {

/// A text that also fails, made from a failing one by leaving out pieces: half of them at a time,
/// then a quarter, ... then single ones.
template <class Fails>
std::string minimised(const std::string& text, Fails fails) {
    std::vector<std::string> pieces = pieces_of(text);
    const auto joined = [](const std::vector<std::string>& all) {
        std::string result;
        for (const std::string& piece : all)
            result += piece;
        return result;
    };
    for (std::size_t length = pieces.size(); length > 0; length /= 2) {
        for (std::size_t at = 0; at < pieces.size();) {
            std::vector<std::string> without = pieces;
            const auto begin = without.begin() + static_cast<std::ptrdiff_t>(at);
            const std::size_t count = std::min(length, pieces.size() - at);
            without.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
            if (fails(joined(without))) {
                pieces = std::move(without);
            } else {
                at += length;
            }
        }
    }
    return joined(pieces);
}

}  // namespace zeroset::test
