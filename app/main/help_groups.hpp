#pragma once

#include <CLI/CLI.hpp>

#include <span>
#include <string_view>

// The groups in which the help and the page of the command line show options.

namespace zeroset {

struct HelpGroup {
    std::string_view name;
    /// Sentences of the page, in Markdown, and command lines as examples.
    std::string_view about, examples;
    /// Long names of options with spaces between them, such as "--box --set". That of a subcommand
    /// alone, where others have an option of this name that means something else: "mesh:--depth".
    std::string_view options;
};

/// In the order of the help; the first holds the options that matter first.
std::span<const HelpGroup> help_groups();

/// Puts the options of the program and of all its subcommands into these groups.
void group_options(CLI::App& app);

}  // namespace zeroset
