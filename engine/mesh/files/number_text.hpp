#pragma once

#include <charconv>
#include <concepts>
#include <string>

namespace zeroset {

/// Appends the shortest text that reads as this float, or the whole number.
template <class Number>
void append_number(std::string& text, Number value) {
    char room[32];
    text.append(room, std::to_chars(room, room + sizeof room, value).ptr);
}

}  // namespace zeroset
