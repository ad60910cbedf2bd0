#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// A line of the help: what to type, and what it does.
struct HelpEntry {
    std::string typed;
    std::string meaning;
};

struct HelpSection {
    std::string title;
    std::vector<HelpEntry> entries;
};

/// The help on the formula language: one screen, and all functions. In English; titles and meanings
/// are in the catalogs (engine/base/translation.hpp).
std::vector<HelpSection> language_help();

/// The grammar of the language, in EBNF.
std::string_view language_grammar();

}  // namespace zeroset
