#pragma once

#include "engine/language/words/lexer.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// A "|" among the tokens of a text.
struct Bar {
    std::size_t at;           ///< index of the token
    std::size_t comparisons;  ///< before it, in the same brackets
};

/// What is known of the place in which bars stand.
struct BarPlace {
    std::size_t comparisons = 0;  ///< in it
    bool is_condition = false;    ///< something that is true or false is wanted
};

/// Which of the bars, all in the same brackets and between the same commas, mean "or": the first of
/// "||", one that no other can close to an absolute value, one between conditions.
std::vector<std::size_t> bars_that_mean_or(std::span<const Token> tokens, std::span<const Bar> bars,
                                           const BarPlace& place, Notes& notes);

/// Whether an operand can end with the token.
bool ends_operand(const Token& token);
/// Whether an operand begins with the token, and nothing else does.
bool begins_operand(const Token& token);
/// Whether there is space between the token and the one before.
bool has_space_before(std::span<const Token> tokens, std::size_t at);

}  // namespace zeroset
