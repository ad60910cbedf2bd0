#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/kernel.hpp"

namespace zeroset {

/// Finds the parts of a surface (papers/along_rays/csg_parts.hpp) that is a tree of min and max,
/// for Kernel::memory; their code is made when it is first asked for: by machine code, as far as
/// that can be made, or by interpreters; in the precisions of the kernel.
void read_csg_parts(const Kernel& kernel, const Expr& surface, bool by_machine_code);

}  // namespace zeroset
