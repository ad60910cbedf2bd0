#pragma once

#include "engine/language/dialects/expressions.hpp"

#include <cstddef>
#include <optional>

namespace zeroset {

/// Writes the function of a program that starts at offset `at` of the typed text, as `float f(x, y)
/// { ... return ...; }`, and returns the offset behind it. Nothing where none starts there, or one
/// that the language reads itself; the writer may have got a part of it then. Read are Python's
/// def, JavaScript's and R's function, Rust's fn, Maple's proc, and function ... end of MATLAB and
/// Julia.
std::optional<std::size_t> write_program_function(std::size_t at, ExpressionWriter& writer);

}  // namespace zeroset
