#pragma once

#include "pipeline/input_error.hpp"

#include <initializer_list>
#include <optional>
#include <string>

// The output of a command, and its end: the exit code, and one line on stderr for an error.

namespace zeroset {

inline constexpr int exit_ok = 0;
inline constexpr int exit_run_time = 1;
inline constexpr int exit_wrong_input = 2;
inline constexpr int exit_inexact = 3;  ///< all was written, but not as exactly as was asked

/// Prints the error and returns its exit code.
int report(const InputError& error);
int report_run_time(const std::string& message);

/// Prints to stdout at once, also where that is a pipe.
void print(const std::string& text);

/// Why the first of the files that cannot be written cannot be; absent ones, and "-" for standard
/// output, are left out.
std::optional<std::string> first_unwritable(
    std::initializer_list<std::optional<std::string>> paths);

}  // namespace zeroset
