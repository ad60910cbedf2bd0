#pragma once

#include <nlohmann/json_fwd.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <utility>

namespace zeroset {

/// printf into a string; a line of a table.
template <class... Values>
std::string formatted(const char* format, const Values&... values) {
    std::array<char, 400> text{};
    const int size = std::snprintf(text.data(), text.size(), format, values...);
    return {text.data(), std::min(static_cast<std::size_t>(size), text.size() - 1)};
}

/// A column of a table that is printed from rows of JSON.
struct TextColumn {
    std::string title;
    std::string place;  ///< in a row, as a JSON pointer
    int width;          ///< below 0: from the left on
    int digits;         ///< of numbers, behind the point

    TextColumn(std::string its_title, std::string its_place, int its_width, int its_digits = 0)
        : title(std::move(its_title)),
          place(std::move(its_place)),
          width(its_width),
          digits(its_digits) {}
};

/// The titles, as a line.
std::string title_line(std::span<const TextColumn> columns);
/// A row, as a line; "-" for null.
std::string row_line(std::span<const TextColumn> columns, const nlohmann::ordered_json& row);

}  // namespace zeroset
