#pragma once

#include <string_view>

namespace zeroset {

/// Whether a line loads what a program needs, or names variables, which no formula does.
bool loads_library(std::string_view line);
/// Whether a line of a program draws nothing: it loads something, opens a window or sets how it
/// looks.
bool is_idle(std::string_view line);

}  // namespace zeroset
