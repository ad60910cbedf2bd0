#pragma once

#include "app/cli/options/options.hpp"

#include <optional>
#include <string>

// Subcommands that compare with papers, as those of app/cli/commands.hpp.

namespace zeroset {

/// Times tracers on a paper's surfaces, beside what it printed.
struct CompareCommand {
    std::optional<std::string> table, surfaces, tracers, d_stop, threads, size, repeat, budget,
        json;
};
int run_compare(const CompareCommand& command);

/// Repeats the traversals of octrees in 128 bits and prints what differs, as JSON.
struct TraversalCommand {
    std::string equation;
    ViewText view;
    std::optional<std::string> levels, threads;
    std::string size = "512x512";
};
int run_traversal(const TraversalCommand& command);

/// The values of their options.
struct PaperCommands {
    CompareCommand compare;
    TraversalCommand traversal;
};

}  // namespace zeroset
