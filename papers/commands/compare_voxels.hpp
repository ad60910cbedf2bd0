#pragma once

#include "papers/commands/paper_commands.hpp"
#include "papers/compare/printed_tables.hpp"

namespace zeroset {

/// `zeroset dev compare` of a table of rays in voxels [Marmitt04]; returns the exit code.
int run_compare_voxels(const CompareCommand& command, const VoxelTable& table);

}  // namespace zeroset
