#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace zeroset {

/// The page of the command line (resources/docs/command-line.md), in Markdown: the subcommands and
/// all options of `app`, in groups (help_groups.hpp).
std::string command_line_page(const CLI::App& app);

}  // namespace zeroset
