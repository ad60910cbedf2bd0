#pragma once

#include <string>
#include <string_view>

namespace zeroset {

/// `text` as a terminal may show it: a U+FFFD for each control character and for each byte that is
/// not UTF-8, so that a file's words are neither commands to the terminal nor further lines.
std::string printable(std::string_view text);

}  // namespace zeroset
