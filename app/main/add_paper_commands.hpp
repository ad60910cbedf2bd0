#pragma once

#include "papers/commands/paper_commands.hpp"

#include <CLI/CLI.hpp>

namespace zeroset {

CLI::App* add_compare(CLI::App& app, CompareCommand& compare);
CLI::App* add_traversal(CLI::App& app, TraversalCommand& traversal);

}  // namespace zeroset
