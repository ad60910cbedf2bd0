#pragma once

#include "engine/image/color_map.hpp"
#include "engine/scene/coloring.hpp"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// The quantity that colours all surfaces, and its scale.
struct ColorChoice {
    ColorBy by = ColorBy::Plain;
    std::string expression = {};                     ///< for ColorBy::Expression; UTF-8
    std::optional<ColorMap> map = std::nullopt;      ///< none: usual_map(by)
    std::optional<ValueRange> range = std::nullopt;  ///< none: found from the picture

    bool operator==(const ColorChoice&) const = default;
};

/// A point that was kept, and the number that names it.
struct Marker {
    int number = 1;
    glm::dvec3 at{0.0};

    bool operator==(const Marker&) const = default;
};

inline constexpr std::size_t most_markers = 1000;

/// Adds a marker at the point with the next number and returns that number; 0, and no marker, where
/// there are most_markers.
int add_marker(std::vector<Marker>& markers, const glm::dvec3& at);
void remove_marker(std::vector<Marker>& markers, int number);
/// The marker of this number, or nullptr.
const Marker* find_marker(const std::vector<Marker>& markers, int number);

/// A point as it is typed, "(1, 2, 3)", with as many decimals as a precision of `resolution` needs,
/// or with all where it is 0.
std::string coordinates_text(const glm::dvec3& at, double resolution = 0.0);
/// A number as coordinates_text writes it.
std::string number_text(double number, double resolution = 0.0);

}  // namespace zeroset
