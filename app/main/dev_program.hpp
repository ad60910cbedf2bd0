#pragma once

#include <string_view>

namespace zeroset {

/// Whether the word is a tool of `zeroset dev` that is also known without `dev`.
bool is_dev_tool(std::string_view word);

/// Runs `zeroset dev`: what times Zeroset, compares it with papers, and draws its window. The first
/// argument is not read. Returns the exit code.
int run_dev(int argc, char** argv);

}  // namespace zeroset
