#pragma once

#include <string>

namespace zeroset {

/// The page of the formula language as Markdown: resources/docs/language.md.
std::string language_page();

}  // namespace zeroset
