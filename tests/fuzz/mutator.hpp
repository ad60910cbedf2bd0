#pragma once

#include "tests/support/random_numbers.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace zeroset::test {

/// The parts of a text that a mutation keeps whole: words, numbers, signs, spaces.
std::vector<std::string> pieces_of(std::string_view text);

/// The quoted words of a dictionary in libFuzzer's form.
std::vector<std::string> read_dictionary(std::string_view file);

/// Makes texts out of given ones and the language's words.
class Mutator {
public:
    Mutator(std::vector<std::string> texts, std::vector<std::string> words);

    /// Mostly almost right, of at most 110'000 bytes; the same for the same random numbers.
    std::string next(RandomNumbers& random) const;
    /// Takes a text to go on from.
    void keep(std::string text, RandomNumbers& random);

private:
    using Pieces = std::vector<std::string>;

    void mutate(Pieces& pieces, RandomNumbers& random) const;
    [[nodiscard]] Pieces some_pieces(RandomNumbers& random) const;

    Pieces texts_;
    std::size_t given_;  ///< the first texts, which stay
    Pieces words_;
};

}  // namespace zeroset::test
