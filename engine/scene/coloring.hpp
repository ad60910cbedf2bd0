#pragma once

#include "engine/image/color_map.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/scene/surface_lines.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace zeroset {

/// The property that the colours of surfaces tell.
enum class ColorBy : std::uint8_t {
    Plain,   ///< which surface, and which side of it
    Normal,  ///< the direction of f's gradient: red, green and blue are x, y and z
    Height,  ///< the coordinate along Coloring::up
    Depth,   ///< the distance from the eye
    MeanCurvature,
    GaussianCurvature,
    Gradient,    ///< its length
    Expression,  ///< any formula of x, y, z, w and the parameters
};

std::span<const ColorBy> color_modes();
/// The name as it is typed: "mean-curvature".
std::string_view name_of(ColorBy by);
std::optional<ColorBy> color_by_named(std::string_view name);

/// Whether a number stands behind the colours, with a map and a range.
bool has_range(ColorBy by);
/// Whether the number is that of a formula (Coloring::values).
bool has_formula(ColorBy by);
/// Whether the number is of the surface itself, and says nothing of sections: those are plain.
bool is_of_skin(ColorBy by);
/// Whether its sign says so much that the range is symmetric about 0.
bool is_signed(ColorBy by);
/// The map that shows it best.
ColorMap usual_map(ColorBy by);

/// The numbers at the ends of a map; lo < hi.
struct ValueRange {
    double lo = 0.0;
    double hi = 1.0;

    bool operator==(const ValueRange&) const = default;
    [[nodiscard]] double place(double value) const { return (value - lo) / (hi - lo); }
};

/// The numbers that sections show (Section::values), and how. A value.
struct SectionValues {
    ColorMap map = ColorMap::Gray;
    ValueRange range = {};
    ValueRange usual_range = {};  ///< that holds most of the values in the clip box

    bool operator==(const SectionValues&) const = default;
};

/// How the surfaces of a scene are coloured. A value.
struct Coloring {
    ColorBy by = ColorBy::Plain;
    ColorMap map = ColorMap::Aurora;
    std::optional<ValueRange> range = std::nullopt;  ///< nothing: to be found from the picture
    std::vector<PointFunction> values = {};          ///< of each surface, if has_formula(by)
    glm::dvec3 up{0.0, 0.0, 1.0};                    ///< for Height; of length 1
    SurfaceLines lines = {};

    bool operator==(const Coloring&) const = default;
};

}  // namespace zeroset
