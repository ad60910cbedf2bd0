#pragma once

#include "engine/language/words/lexer.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// A "|" among the tokens of a text.
struct Bar {
    std::size_t at;           ///< index of the token
    std::size_t comparisons;  ///< number of comparisons before it in the same brackets
};

/// The brackets that the bars are in.
struct BarPlace {
    std::size_t comparisons = 0;  ///< number of comparisons in them
    bool is_condition = false;    ///< a condition is expected there
};

/// Which of the bars mean "or": the first of "||", one that no other bar can close to an absolute
/// value, and one between conditions. All must be in the same brackets and between the same commas.
std::vector<std::size_t> bars_that_mean_or(std::span<const Token> tokens, std::span<const Bar> bars,
                                           const BarPlace& place, Notes& notes);

/// Whether an operand can end with the token.
bool ends_operand(const Token& token);
/// Whether the token can only begin an operand.
bool begins_operand(const Token& token);
/// Whether there is a space between the token and the one before it.
bool has_space_before(std::span<const Token> tokens, std::size_t at);

}  // namespace zeroset
