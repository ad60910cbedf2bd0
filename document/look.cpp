#include "document/look.hpp"

#include "engine/base/enum_names.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace zeroset {
namespace {

constexpr auto contour_names = enum_names<Contours>("none", "height", "xyz", "expression");

/// `number` without the zeros at the end of its decimals.
std::string shortened(std::string number) {
    if (!number.contains('.') || number.contains('e')) return number;
    number.erase(number.find_last_not_of('0') + 1);
    if (number.ends_with('.')) number.pop_back();
    return number;
}

std::string all_digits(double number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

}  // namespace

std::string_view name_of(Contours contours) { return contour_names.of(contours); }

std::optional<Contours> contours_named(std::string_view name) { return contour_names.named(name); }

std::string name_of(const Marker& marker) {
    return marker.label.empty() ? std::to_string(marker.number) : marker.label;
}

int add_marker(std::vector<Marker>& markers, const glm::dvec3& at, const std::string& label) {
    if (markers.size() >= most_markers) return 0;
    int number = 1;
    for (const Marker& marker : markers)
        number = std::max(number, marker.number + 1);
    markers.push_back({.number = number, .at = at, .label = label});
    return number;
}

void remove_marker(std::vector<Marker>& markers, int number) {
    std::erase_if(markers, [number](const Marker& marker) { return marker.number == number; });
}

const Marker* find_marker(const std::vector<Marker>& markers, int number) {
    const auto found = std::ranges::find(markers, number, &Marker::number);
    return found == markers.end() ? nullptr : &*found;
}

std::string number_text(double number, double resolution) {
    constexpr double most_decimals = 17.0;
    constexpr double largest = 1e7;
    if (!(resolution > 0.0) || !std::isfinite(number)) return all_digits(number);
    if (std::abs(number) < 0.5 * resolution) return "0";
    const double decimals = std::clamp(std::ceil(-std::log10(resolution)), 0.0, most_decimals);
    std::array<char, 64> text{};
    const bool fixed = std::abs(number) < largest;
    const int length = std::snprintf(text.data(), text.size(), fixed ? "%.*f" : "%.*g",
                                     fixed ? static_cast<int>(decimals) : 9, number);
    std::string digits = shortened({text.data(), static_cast<std::size_t>(length)});
    if (digits == "-0") return "0";
    return digits;
}

std::string coordinates_text(const glm::dvec3& at, double resolution) {
    return "(" + number_text(at.x, resolution) + ", " + number_text(at.y, resolution) + ", " +
           number_text(at.z, resolution) + ")";
}

}  // namespace zeroset
