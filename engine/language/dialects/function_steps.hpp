#pragma once

#include "engine/language/dialects/function_body.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

// Private to the room: reads the steps of functions.

namespace zeroset {

/// Writes the steps behind a colon of Python at `at`: on the same line, or on lines that are set in
/// further than `indent`. Returns the offset behind them.
std::size_t write_indented_steps(std::string_view text, std::size_t at, std::size_t indent,
                                 FunctionBody& body);
/// Writes steps in braces, as JavaScript, R and Rust have them; `inside`: what is in them.
void write_steps_in_braces(std::string_view inside, FunctionBody& body);
/// Writes steps between words, as Maple, MATLAB and Julia have them, from `at` to the word "end".
/// Returns the offset behind it; nothing where it is missing.
std::optional<std::size_t> write_steps_up_to_end(std::string_view text, std::size_t at,
                                                 FunctionBody& body);

}  // namespace zeroset
