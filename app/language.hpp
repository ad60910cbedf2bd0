#pragma once

#include "ui/ui_state.hpp"

#include <string>
#include <vector>

namespace zeroset {

/// The formula language in one screen and all its functions, for the window's help.
std::vector<ui::HelpSection> language_help();

/// The same as Markdown: resources/docs/language.md.
std::string language_page();

}  // namespace zeroset
