#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

namespace zeroset {

/// printf into a string; a line of a table.
template <class... Values>
std::string formatted(const char* format, const Values&... values) {
    std::array<char, 400> text{};
    const int size = std::snprintf(text.data(), text.size(), format, values...);
    return {text.data(), std::min(static_cast<std::size_t>(size), text.size() - 1)};
}

}  // namespace zeroset
