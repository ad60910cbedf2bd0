#pragma once

#include "pipeline/input_error.hpp"

#include <string>

// The end of a command: its exit code, and one line on stderr for an error.

namespace zeroset {

inline constexpr int exit_ok = 0;
inline constexpr int exit_run_time = 1;
inline constexpr int exit_wrong_input = 2;

/// Prints the error and returns its exit code.
int report(const InputError& error);
int report_run_time(const std::string& message);

}  // namespace zeroset
