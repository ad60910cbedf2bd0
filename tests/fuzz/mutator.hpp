#pragma once

#include "tests/support/random_numbers.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace zeroset::test {

/// The parts of a text that most mutations keep whole: words, numbers, signs, spaces.
std::vector<std::string> pieces_of(std::string_view text);

/// The quoted words of a dictionary in libFuzzer's format.
std::vector<std::string> read_dictionary(std::string_view file);

/// Makes texts from given ones and from the language's words.
class Mutator {
public:
    Mutator(std::vector<std::string> texts, std::vector<std::string> words);

    /// A text that is mostly almost correct, of at most 110'000 bytes; equal for equal random
    /// numbers.
    std::string next(RandomNumbers& random) const;
    /// Adds a text to those that are mutated.
    void keep(std::string text, RandomNumbers& random);

private:
    using Pieces = std::vector<std::string>;

    void mutate(Pieces& pieces, RandomNumbers& random) const;
    [[nodiscard]] Pieces some_pieces(RandomNumbers& random) const;

    Pieces texts_;
    std::size_t given_;  ///< number of the first texts, which are never replaced
    Pieces words_;
};

}  // namespace zeroset::test
