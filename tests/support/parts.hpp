#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/tape/parts.hpp"

namespace zeroset::test {

/// An interpreter of the choices of a formula, whose parts have code by `make`. The parts'
/// constants are uniforms, as if there were other parts of the same shapes.
Kernel interpret_with_parts(const Expr& expr, const MakeCode& make);

/// An interpreter of the choices of a formula, whose parts are interpreted, too.
Kernel interpret_with_parts(const Expr& expr);

}  // namespace zeroset::test
