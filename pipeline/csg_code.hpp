#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/kernel.hpp"

namespace zeroset {

/// Tells a surface's kernel of its parts (engine/kernel/csg_parts.hpp), where the surface is a tree
/// of min and max: by machine code, as far as that can be made, or by interpreters; in the
/// precisions of the kernel.
void set_csg_parts(Kernel& kernel, const Expr& surface, bool by_machine_code);

}  // namespace zeroset
