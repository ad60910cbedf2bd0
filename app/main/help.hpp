#pragma once

#include <CLI/CLI.hpp>

#include <span>
#include <string>
#include <string_view>

namespace zeroset {

// The groups in which the help and the page of the command line show options.

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

/// "--shadows, --no-shadows": an option's names as they are typed.
std::string typed_names(const CLI::Option& option);

/// Writes the help: options in groups (HelpGroup), texts in lines of 100 columns.
class HelpFormat : public CLI::Formatter {
public:
    HelpFormat();
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override;
    std::string make_option_name(const CLI::Option* option, bool is_positional) const override;
    std::string make_option_opts(const CLI::Option* option) const override;
    std::string make_option_desc(const CLI::Option* option) const override;

private:
    [[nodiscard]] std::string make_ordered_groups(const CLI::App& app) const;
};

/// The page of the command line (resources/docs/command-line.md), in Markdown: the subcommands and
/// all options of `app`, in groups (HelpGroup).
std::string command_line_page(const CLI::App& app);

}  // namespace zeroset
