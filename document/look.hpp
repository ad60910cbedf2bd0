#pragma once

#include "engine/image/color_map.hpp"
#include "engine/scene/coloring.hpp"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// What the colours of all surfaces are to tell.
struct ColorChoice {
    ColorBy by = ColorBy::Plain;
    std::string expression = {};                     ///< for ColorBy::Expression; UTF-8
    std::optional<ColorMap> map = std::nullopt;      ///< none: usual_map(by)
    std::optional<ValueRange> range = std::nullopt;  ///< none: found from the picture

    bool operator==(const ColorChoice&) const = default;
};

/// A point that was kept, with the number it is called by.
struct Marker {
    int number = 1;
    glm::dvec3 at{0.0};

    bool operator==(const Marker&) const = default;
};

inline constexpr std::size_t most_markers = 1000;

/// A marker at the point, numbered on; nothing happens where there are most_markers. Its number, or
/// 0.
int add_marker(std::vector<Marker>& markers, const glm::dvec3& at);
void remove_marker(std::vector<Marker>& markers, int number);
/// nullptr where there is none of this number.
const Marker* find_marker(const std::vector<Marker>& markers, int number);

/// Three numbers as they are typed, "(1, 2, 3)", with as many decimals as a number closer than
/// `resolution` needs, all where it is 0.
std::string coordinates_text(const glm::dvec3& at, double resolution = 0.0);
/// One number likewise.
std::string number_text(double number, double resolution = 0.0);

}  // namespace zeroset
