#include "ui/model/typed_point.hpp"

#include "document/document.hpp"
#include "engine/base/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

namespace zeroset::ui {
namespace {

/// The number, with a point or a comma before its decimals.
std::optional<double> coordinate(std::string_view typed) {
    std::string text(typed);
    std::ranges::replace(text, ',', '.');
    if (text.starts_with('+')) text.erase(0, 1);
    for (const std::string_view minus : {"\u2212", "\u2013"}) {
        if (text.starts_with(minus)) text.replace(0, minus.size(), "-");
    }
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    const bool whole = !text.empty() && read.ec == std::errc() && read.ptr == end;
    if (!whole || !(std::abs(value) <= largest_number)) return std::nullopt;
    return value;
}

std::string_view without_brackets(std::string_view text) {
    for (const std::string_view brackets : {"()", "[]", "{}"}) {
        if (text.size() >= 2 && text.front() == brackets[0] && text.back() == brackets[1])
            return trimmed(text.substr(1, text.size() - 2));
    }
    return text;
}

/// The three parts: apart by semicolons, else by two commas, else by blanks.
std::vector<std::string_view> parts_of(std::string_view text) {
    if (text.contains(';')) return split(text, ';');
    if (std::ranges::count(text, ',') == 2 && text.back() != ',') {
        const auto parts = split(text, ',');
        const auto has_blank = [](std::string_view part) { return part.contains(' '); };
        if (std::ranges::none_of(parts, has_blank)) return parts;
    }
    std::vector<std::string_view> parts = split(text, ' ');
    std::erase_if(parts, [](std::string_view part) { return part.empty(); });
    return parts;
}

}  // namespace

std::optional<glm::dvec3> point_typed(const std::string& text) {
    const std::string_view inner = without_brackets(trimmed(text));
    if (inner.empty()) return std::nullopt;
    const auto parts = parts_of(inner);
    if (parts.size() != 3) return std::nullopt;
    glm::dvec3 point(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const auto read = coordinate(parts[static_cast<std::size_t>(axis)]);
        if (!read) return std::nullopt;
        point[axis] = *read;
    }
    return point;
}

}  // namespace zeroset::ui
