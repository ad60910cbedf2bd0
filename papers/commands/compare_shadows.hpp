#pragma once

#include "papers/commands/paper_commands.hpp"

namespace zeroset {

/// `zeroset dev compare` of the ways to find shadows: by beams, by boxes that beams reject, by
/// rays.
int run_compare_shadows(const CompareCommand& command);

}  // namespace zeroset
