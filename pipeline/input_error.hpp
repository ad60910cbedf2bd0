#pragma once

#include "engine/language/vocabulary/reading.hpp"

#include <cstddef>
#include <expected>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset {

/// What the user typed wrong: one line, and the place in the text where there is one.
struct InputError {
    std::string reason;                                ///< what is wrong and what to type instead
    std::optional<std::size_t> column = std::nullopt;  ///< from 1, in characters of `line`
    std::string line = {};                             ///< the line of the text that has the place
    std::optional<std::size_t> offset = std::nullopt;  ///< of the place in the text, bytes
    bool unfinished = false;                           ///< right so far, but it stops too early
};

inline std::unexpected<InputError> wrong_input(std::string reason) {
    return std::unexpected(InputError{std::move(reason)});
}

template <class Value>
using OrInputError = std::expected<Value, InputError>;

/// What is wrong with a text.
InputError input_error(const ParseError& error, std::string_view text);

/// "error: REASON", then the text's line with a caret under the column; ends with a newline.
std::string describe(const InputError& error);

}  // namespace zeroset
