#pragma once

#include "engine/kernel/kernel.hpp"

namespace zeroset::test {

/// A kernel whose ranges and forms are the hulls of those of the pieces of f (HeldSwitches), with
/// up to four switches held. All claims about the original kernel must hold of it. Its forms are
/// intervals where switches are open.
Kernel by_pieces(const Kernel& kernel);

}  // namespace zeroset::test
