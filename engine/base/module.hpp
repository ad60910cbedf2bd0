#pragma once

#include <expected>
#include <string>

namespace zeroset {

/// Loads a module, a library of ours beside the program or in lib/zeroset, and finds its one
/// function. It stays loaded. The error: why there is none. Thread-safe.
std::expected<void*, std::string> load_module(const char* file, const char* function);

}  // namespace zeroset
