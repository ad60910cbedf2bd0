#include "app/main/help.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t columns = 100;
constexpr std::size_t name_columns = 30;

/// The text in lines of so many bytes at most, where words are no longer.
std::string in_lines(std::string_view text, std::size_t width) {
    std::string lines;
    std::size_t used = 0;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, std::min(text.find(' '), text.size()));
        text.remove_prefix(std::min(word.size() + 1, text.size()));
        if (used > 0 && used + 1 + word.size() > width) {
            lines += '\n';
            used = 0;
        } else if (used > 0) {
            lines += ' ';
            ++used;
        }
        lines += word;
        used += word.size();
    }
    return lines;
}

/// Names of groups in the order of the help: those of the table, then others.
std::vector<std::string> ordered_groups(const CLI::App& app) {
    const std::vector<std::string> present = app.get_groups();
    std::vector<std::string> ordered;
    for (const HelpGroup& group : help_groups()) {
        if (std::ranges::find(present, group.name) != present.end())
            ordered.emplace_back(group.name);
    }
    for (const std::string& name : present) {
        if (std::ranges::find(ordered, name) == ordered.end()) ordered.push_back(name);
    }
    return ordered;
}

}  // namespace

std::string typed_names(const CLI::Option& option) {
    std::string names;
    for (const std::string& name : option.get_snames())
        names += (names.empty() ? "-" : ", -") + name;
    for (const std::string& name : option.get_lnames())
        names += (names.empty() ? "--" : ", --") + name;
    return names;
}

HelpFormat::HelpFormat() {
    column_width(name_columns);
    label("TEXT", "VALUE");
}

std::string HelpFormat::make_help(const CLI::App* app, std::string name,
                                  CLI::AppFormatMode mode) const {
    return make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) +
           make_ordered_groups(*app) + make_subcommands(app, mode) + "\n" + make_footer(app);
}

std::string HelpFormat::make_ordered_groups(const CLI::App& app) const {
    std::string text;
    for (const std::string& name : ordered_groups(app)) {
        const auto options = app.get_options([&](const CLI::Option* option) {
            return option->get_group() == name && option->nonpositional();
        });
        if (!name.empty() && !options.empty()) text += make_group(name, false, options);
    }
    return text;
}

std::string HelpFormat::make_option_name(const CLI::Option* option, bool is_positional) const {
    return is_positional ? option->get_name(true, false) : typed_names(*option);
}

std::string HelpFormat::make_option_opts(const CLI::Option* option) const {
    if (option->get_positional() || option->get_type_size() == 0) return {};
    return " " + get_label(option->get_type_name()) + (option->get_required() ? " (needed)" : "");
}

std::string HelpFormat::make_option_desc(const CLI::Option* option) const {
    return in_lines(option->get_description(), columns - name_columns);
}

}  // namespace zeroset
