#pragma once

#include "papers/commands/paper_commands.hpp"
#include "papers/compare/printed_tables.hpp"

namespace zeroset {

/// `zeroset dev compare` of an animation: frames by one grid for several of them, and by one for
/// each.
int run_compare_animation(const CompareCommand& command, const PrintedAnimation& animation);

}  // namespace zeroset
