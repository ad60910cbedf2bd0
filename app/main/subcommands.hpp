#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace zeroset {

/// A subcommand and what it does.
struct Subcommand {
    const CLI::App* app;
    std::function<int()> run;
};

/// Reads the arguments, of which the first is the program's name. Returns the exit code where that
/// was all: help, or an error. `complete_help` runs before help is shown.
std::optional<int> parse(CLI::App& app, int argc, char** argv, void (*complete_help)(CLI::App&));

/// Runs the one that was typed; returns the exit code. Signals end it with files whole or
/// untouched.
int run_typed(const std::vector<Subcommand>& subcommands);

}  // namespace zeroset
