#include "app/cli/language.hpp"

#include "app/cli/commands.hpp"
#include "app/cli/report.hpp"
#include "engine/language/help.hpp"
#include "engine/language/vocabulary/functions.hpp"

#include <iostream>
#include <string>
#include <string_view>

namespace zeroset {
namespace {

/// The picture of a shape or noise, which is in resources/docs/shapes; empty for other entries.
std::string picture(const HelpEntry& entry) {
    const std::string name = entry.typed.substr(0, entry.typed.find('('));
    const Function* const function = find_function(name);
    const bool is_shape = function != nullptr && entry.typed.size() > name.size() &&
                          !entry.typed.contains('"') &&
                          (function->section == WordSection::Bodies || function->is_noise());
    return is_shape ? " ![" + name + "](shapes/" + name + ".png)" : std::string();
}

}  // namespace

std::string markdown_cell(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '|') result += '\\';
        result += c;
    }
    return result;
}

std::string language_page() {
    std::string page =
        "# The formula language\n\n"
        "This page is what `zeroset language` prints, from the program's own tables.\n";
    for (const HelpSection& section : language_help()) {
        page += "\n## " + section.title + "\n\n| type | meaning |\n|---|---|\n";
        for (const HelpEntry& entry : section.entries) {
            page += "| `" + markdown_cell(entry.typed) + "` | " + markdown_cell(entry.meaning);
            page += picture(entry);
            page += " |\n";
        }
    }
    page +=
        "\n## Grammar\n\nA product without `*` binds like one with it. What is read in an unusual "
        "way, "
        "and what to type for the\nother, stands in the notes of `zeroset explain` and below the "
        "row in "
        "the window.\n\n```\n" +
        std::string(language_grammar()) + "```\n";
    return page;
}

int run_language() {
    std::cout << language_page();
    return exit_ok;
}

}  // namespace zeroset
