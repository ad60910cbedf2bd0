#pragma once

#include "engine/interpret/parts.hpp"
#include "engine/kernel/kernel.hpp"

namespace zeroset::test {

/// An interpreter of the choices of a formula, with code by `make` for its parts; their constants
/// are uniforms, as if there were other parts of the same shapes.
Kernel interpret_with_parts(const Expr& expr, const MakeCode& make);

/// The same with interpreters of the parts.
Kernel interpret_with_parts(const Expr& expr);

}  // namespace zeroset::test
