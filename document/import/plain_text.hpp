#pragma once

#include <string>
#include <string_view>

namespace zeroset {

/// A file's text in UTF-8, without the mark of its encoding at its start, which tells UTF-16; lines
/// that end in a carriage return alone end in a line feed.
std::string plain_text(std::string_view bytes);

}  // namespace zeroset
