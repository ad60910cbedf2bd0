#include "app/cli/language.hpp"

#include "app/cli/commands.hpp"
#include "app/cli/report.hpp"
#include "engine/language/help.hpp"

#include <iostream>
#include <string_view>

namespace zeroset {
namespace {

/// Escapes bars, which Markdown's table cells require even in code.
std::string cell(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '|') result += '\\';
        result += c;
    }
    return result;
}

}  // namespace

std::string language_page() {
    std::string page =
        "# The formula language\n\n"
        "This page is what `zeroset language` prints, from the program's own tables.\n";
    for (const HelpSection& section : language_help()) {
        page += "\n## " + section.title + "\n\n| type | meaning |\n|---|---|\n";
        for (const HelpEntry& entry : section.entries)
            page += "| `" + cell(entry.typed) + "` | " + cell(entry.meaning) + " |\n";
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
