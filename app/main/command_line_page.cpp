#include "app/cli/language.hpp"
#include "app/main/help.hpp"
#include "engine/base/text.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr std::string_view beginning = R"(# The command line

This page is what `zeroset command-line` prints, from the program's own table of options. `zeroset --help` and
`zeroset SUBCOMMAND --help` show their part of it. In a folder of sources `./run.sh ARGS` is `zeroset ARGS`. No
subcommand needs a display.

Wherever an equation is expected, `@NAME` takes one of the gallery, `FILE.zeroset.json` a saved session, a PNG that
Zeroset wrote the session in it, `-` reads it from standard input, and files of other programs open in its place
([import.md](import.md)). How equations are typed: [language.md](language.md).

**Exit codes**: 0; 2 for what was typed wrong (one line with the reason, a caret under the place in a formula); 1 for
what went wrong at run time, or was ended by a signal; 3 of `mesh` for a file that was written but is farther from the
surface than the tolerance, as stderr says. Files are written beside their place and renamed: they are whole or untouched.
On a terminal a line shows how far it is after a second; Ctrl+C and SIGTERM end it at once.
)";

/// An option of the same names and meaning in one or more subcommands.
struct Row {
    std::string option, meaning;
    std::vector<std::string> of;  ///< subcommands; "" is the window

    [[nodiscard]] bool is_same_option(const Row& other) const {
        return option == other.option && meaning == other.meaning;
    }
};

std::string listed(const std::vector<std::string>& subcommands) {
    std::string text;
    for (const std::string& name : subcommands)
        text += (text.empty() ? "" : ", ") + (name.empty() ? "the window" : "`" + name + "`");
    return text;
}

std::string typed(const CLI::Option& option) {
    return option.get_positional()
               ? option.get_name(true, false)
               : typed_names(option) + (option.get_items_expected_max() == 0 ? "" : " VALUE");
}

void add_rows(const CLI::App& app, const std::string& name, std::string_view group,
              std::vector<Row>& rows) {
    for (const CLI::Option* const option : app.get_options()) {
        if (option->get_group() != group || !option->nonpositional()) continue;
        Row row{.option = typed(*option), .meaning = option->get_description(), .of = {}};
        auto same =
            std::ranges::find_if(rows, [&](const Row& other) { return other.is_same_option(row); });
        if (same == rows.end()) same = rows.insert(same, std::move(row));
        same->of.push_back(name);
    }
}

/// The subcommands that most of the rows are of.
std::vector<std::string> usual_subcommands(const std::vector<Row>& rows) {
    return std::ranges::max_element(
               rows, {}, [&](const Row& row) { return std::ranges::count(rows, row.of, &Row::of); })
        ->of;
}

std::vector<std::string> without(std::vector<std::string> names,
                                 const std::vector<std::string>& others) {
    std::erase_if(names, [&](const std::string& name) {
        return std::ranges::find(others, name) != others.end();
    });
    return names;
}

/// The rows; those that are not of the usual subcommands say whose they are.
std::string table(const std::vector<Row>& rows, const std::vector<std::string>& usual) {
    std::string text = "\n| option | meaning |\n|---|---|\n";
    for (const Row& row : rows) {
        const auto missing = without(usual, row.of);
        const auto further = without(row.of, usual);
        text += "| `" + markdown_cell(row.option) + "` | " + markdown_cell(row.meaning);
        if (row.of.size() < missing.size()) {
            text += " (only of " + listed(row.of) + ")";
        } else if (!missing.empty()) {
            text += " (not of " + listed(missing) + ")";
        } else if (!further.empty()) {
            text += " (also of " + listed(further) + ")";
        }
        text += " |\n";
    }
    return text;
}

/// The rows of a group that the page shows together: those of pictures, if there are such, or all.
std::vector<Row> rows_of(const CLI::App& app, const HelpGroup& group) {
    std::vector<Row> rows;
    add_rows(app, "", group.name, rows);
    for (const CLI::App* const subcommand : app.get_subcommands({}))
        add_rows(*subcommand, subcommand->get_name(), group.name, rows);
    const auto is_of_pictures = [](const Row& row) {
        return std::ranges::find(row.of, "render") != row.of.end();
    };
    if (std::ranges::any_of(rows, is_of_pictures)) std::erase_if(rows, std::not_fn(is_of_pictures));
    std::erase_if(rows, [](const Row& row) { return row.option == "-h, --help"; });
    return rows;
}

std::string section(const HelpGroup& group, const std::vector<Row>& rows) {
    const std::vector<std::string> usual = usual_subcommands(rows);
    std::string text = "\n## " + std::string(group.name) + "\n\n" + std::string(group.about) +
                       "\n\nOf " + listed(usual) + ":\n" + table(rows, usual);
    if (group.examples.empty()) return text;
    text += "\n```\n";
    for (const std::string_view line : split(group.examples, '\n'))
        text += "zeroset " + std::string(line) + "\n";
    return text + "```\n";
}

/// The footer of a subcommand, and its options that the sections of groups do not show.
std::string rest_of(const CLI::App& app, const std::string& name, const std::vector<Row>& shown) {
    std::string text;
    if (!app.get_footer().empty()) text += "\n" + app.get_footer() + "\n";
    std::vector<Row> rows;
    for (const CLI::Option* const option : app.get_options()) {
        Row row{.option = typed(*option), .meaning = option->get_description(), .of = {name}};
        const bool is_shown =
            std::ranges::any_of(shown, [&](const Row& other) { return other.is_same_option(row); });
        if (!is_shown && row.option != "-h, --help") rows.push_back(std::move(row));
    }
    return rows.empty() ? text : text + table(rows, {name});
}

}  // namespace

std::string command_line_page(const CLI::App& app) {
    std::string page(beginning);
    page += "\n## Subcommands\n\n| type | to |\n|---|---|\n";
    page += "| `zeroset [EQUATION]` | open the window |\n";
    const auto subcommands = app.get_subcommands({});
    for (const CLI::App* const subcommand : subcommands)
        page += "| `zeroset " + subcommand->get_name() + "` | " +
                markdown_cell(subcommand->get_description()) + " |\n";
    std::vector<Row> shown;
    for (const HelpGroup& group : help_groups()) {
        std::vector<Row> rows = rows_of(app, group);
        page += section(group, rows);
        std::ranges::move(rows, std::back_inserter(shown));
    }
    page += "\n## The window\n" + rest_of(app, "", shown);
    for (const CLI::App* const subcommand : subcommands) {
        const std::string rest = rest_of(*subcommand, subcommand->get_name(), shown);
        if (!rest.empty()) page += "\n## zeroset " + subcommand->get_name() + "\n" + rest;
    }
    return page;
}

}  // namespace zeroset
