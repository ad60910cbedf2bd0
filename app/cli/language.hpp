#pragma once

#include <string>
#include <string_view>

namespace zeroset {

/// The page of the formula language as Markdown, kept as resources/docs/language.md.
std::string language_page();

/// The text with its bars escaped, as Markdown's table cells require even in code.
std::string markdown_cell(std::string_view text);

}  // namespace zeroset
