#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace zeroset {

/// "--shadows, --no-shadows": an option's names as they are typed.
std::string typed_names(const CLI::Option& option);

/// Writes the help: options in groups (help_groups.hpp), texts in lines of 100 columns.
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

}  // namespace zeroset
