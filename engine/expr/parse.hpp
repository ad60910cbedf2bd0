#pragma once

#include "engine/expr/expr.hpp"

#include <cstddef>
#include <expected>
#include <string>
#include <string_view>

namespace zeroset {

struct ParseError {
    std::size_t offset;  ///< in bytes from the start of the text
    std::string reason;  ///< what is wrong, one line
    std::string hint;    ///< what to type instead; may be empty
};

/// Reads `f` or `lhs = rhs` (meaning lhs - rhs): numbers, x y z w, + - * / ^, unary signs,
/// parentheses and the functions of op.def.
std::expected<Expr, ParseError> parse(std::string_view text);

}  // namespace zeroset
