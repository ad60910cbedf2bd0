#pragma once

#include "engine/expr/expr.hpp"

#include <optional>

namespace zeroset {

/// The function without its restrictions: what it would be where they do not hold. Nothing where it
/// has none.
std::optional<Expr> unrestricted(const Expr& expr);

}  // namespace zeroset
