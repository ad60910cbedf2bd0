#pragma once

#include "engine/image/background.hpp"
#include "engine/image/color_map.hpp"
#include "engine/scene/coloring.hpp"
#include "engine/scene/lighting.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// The number whose contour lines are drawn.
enum class Contours : std::uint8_t {
    None,
    Height,       ///< the coordinate upwards
    Coordinates,  ///< each of x, y and z: the grid of the coordinate system
    Expression,
};
/// The name as it is typed: none, height, xyz, expression.
std::string_view name_of(Contours contours);
std::optional<Contours> contours_named(std::string_view name);

inline constexpr double least_line = 0.25;
inline constexpr double most_line = 20.0;

/// Lines on all surfaces.
struct LineChoice {
    Contours contours = Contours::None;
    std::string expression = {};  ///< for Contours::Expression; UTF-8
    /// From line to line; above 0. None: some twenty lines in the clip box, some ten on the
    /// surfaces for expressions.
    std::optional<double> step = std::nullopt;
    bool labels = false;  ///< with numbers along contour lines
    /// least_line to most_line: pixels of a picture, points of a drawing. None: 1.4 pixels, thin
    /// lines of a drawing.
    std::optional<double> width = std::nullopt;
    bool intersections = false;  ///< lines where two surfaces meet

    bool operator==(const LineChoice&) const = default;
};

/// The quantity that colours all surfaces, and its scale; and lines on them.
struct ColorChoice {
    ColorBy by = ColorBy::Plain;
    std::string expression = {};                     ///< for ColorBy::Expression; UTF-8
    std::optional<ColorMap> map = std::nullopt;      ///< none: usual_map(by)
    std::optional<ValueRange> range = std::nullopt;  ///< none: found from the picture
    LineChoice lines = {};

    bool operator==(const ColorChoice&) const = default;
};

/// How sections show values (Section::values).
struct SectionChoice {
    std::optional<ColorMap> map = std::nullopt;      ///< none: gray
    std::optional<ValueRange> range = std::nullopt;  ///< none: found from the clip box

    bool operator==(const SectionChoice&) const = default;
};

/// How all surfaces are lit, and what they look as if they were made of.
struct LightChoice {
    Look look = Look::Standard;
    std::vector<Light> lights = {};  ///< at most max_lights; none: the look's own
    int reflections = 0;             ///< 0 to max_reflections
    double absorption = 0.0;         ///< 0 to max_absorption, as in Lighting
    Tone tone = Tone::Plain;
    /// None: the window's own, or the dark one of pictures.
    std::optional<Background> background = std::nullopt;

    bool operator==(const LightChoice&) const = default;
};
inline constexpr double max_absorption = 1e6;

/// A point that was kept, and the number that names it.
struct Marker {
    int number = 1;
    glm::dvec3 at{0.0};
    std::string label = {};  ///< shown in place of the number; UTF-8, at most longest_label bytes

    bool operator==(const Marker&) const = default;
};

inline constexpr std::size_t most_markers = 1000;
/// The longest label of a marker or name of an axis, bytes.
inline constexpr std::size_t longest_label = 80;

/// The label of a marker, or else its number.
std::string name_of(const Marker& marker);

/// Adds a marker at the point with the next number and returns that number; 0, and no marker, where
/// there are most_markers.
int add_marker(std::vector<Marker>& markers, const glm::dvec3& at, const std::string& label = {});
void remove_marker(std::vector<Marker>& markers, int number);
/// The marker of this number, or nullptr.
const Marker* find_marker(const std::vector<Marker>& markers, int number);

/// A point as it is typed, "(1, 2, 3)", with as many decimals as a precision of `resolution` needs,
/// or with all where it is 0.
std::string coordinates_text(const glm::dvec3& at, double resolution = 0.0);
/// A number as coordinates_text writes it.
std::string number_text(double number, double resolution = 0.0);

}  // namespace zeroset
