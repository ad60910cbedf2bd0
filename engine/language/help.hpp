#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// One line of the help: what to type, and what it does.
struct HelpEntry {
    std::string typed;
    std::string meaning;
};

struct HelpSection {
    std::string title;
    std::vector<HelpEntry> entries;
};

/// The formula language in one screen and all its functions.
std::vector<HelpSection> language_help();

/// How a text is built, in EBNF.
std::string_view language_grammar();

}  // namespace zeroset
