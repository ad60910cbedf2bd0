#pragma once

#include "engine/expr/expr.hpp"
#include "engine/expr/kernel.hpp"

#include <cstddef>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace zeroset {

/// What the user typed wrong: one line, and the place in the text where there is one.
struct InputError {
    std::string reason;                                ///< what is wrong and what to type instead
    std::optional<std::size_t> column = std::nullopt;  ///< from 1, in characters of `line`
    std::string line = {};                             ///< the line of the text that has the place
};

inline std::unexpected<InputError> wrong_input(std::string reason) {
    return std::unexpected(InputError{std::move(reason)});
}

/// A formula ready to be drawn.
struct Formula {
    std::string text;
    Expr expr;
    Kernel kernel;
    double compile_ms = 0.0;  ///< from text to machine code
};

/// Text to graph; an equation without x, y and z is refused, as it is no surface.
std::expected<Expr, InputError> read_formula(std::string_view text);

/// Text to machine code. Thread-safe.
std::expected<Formula, InputError> compile_formula(std::string_view text);

/// "error: REASON", then the text's line with a caret under the column; ends with a newline.
std::string describe(const InputError& error);

}  // namespace zeroset
