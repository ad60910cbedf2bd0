#pragma once

#include "engine/language/vocabulary/reading.hpp"

#include <cstddef>
#include <expected>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset {

/// An error in what the user typed: one line and, if known, its place in the text.
struct InputError {
    std::string reason;                                ///< what is wrong, and what to type instead
    std::optional<std::size_t> column = std::nullopt;  ///< from 1, in characters of `line`
    std::string line = {};  ///< the line of the text that contains the error
    std::optional<std::size_t> offset = std::nullopt;  ///< offset of the error in the text, bytes
    bool unfinished = false;  ///< the text is correct so far but ends too early
};

inline std::unexpected<InputError> wrong_input(std::string reason) {
    return std::unexpected(InputError{.reason = std::move(reason)});
}

template <class Value>
using OrInputError = std::expected<Value, InputError>;

/// Converts a parser's error in `text`.
InputError input_error(const ParseError& error, std::string_view text);

/// Formats "error: REASON", then the text's line with a caret under the column. Ends with a
/// newline.
std::string describe(const InputError& error);

}  // namespace zeroset
