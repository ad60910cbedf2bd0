#pragma once

#include <string>

namespace zeroset {

/// The page of the formula language as Markdown, kept as resources/docs/language.md.
std::string language_page();

}  // namespace zeroset
