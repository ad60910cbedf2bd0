#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace zeroset {

/// A subcommand and what it does.
using Subcommand = std::pair<const CLI::App*, std::function<int()>>;

/// Reads the arguments, of which the first is the program's name. Returns the exit code where that
/// was all: help, or an error. `complete_help` runs before help is shown.
std::optional<int> parse(CLI::App& app, int argc, char** argv, void (*complete_help)(CLI::App&));

/// Runs the one that was typed; returns the exit code. Signals end it with files whole or
/// untouched.
int run_typed(const std::vector<Subcommand>& subcommands);

/// Whether the word is a tool of `zeroset dev` that is also known without `dev`.
bool is_dev_tool(std::string_view word);

/// Runs `zeroset dev`: what times Zeroset, compares it with papers, and draws its window. The first
/// argument is not read. Returns the exit code.
int run_dev(int argc, char** argv);

}  // namespace zeroset
