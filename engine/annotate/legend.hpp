#pragma once

#include "engine/annotate/card_style.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/scene/coloring.hpp"

#include <glm/ext/vector_double2.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace zeroset {

/// Which colour stands for which number.
struct Legend {
    std::string title;
    ColorBy by = ColorBy::Plain;
    ColorMap map = ColorMap::Aurora;
    std::optional<ValueRange> range;  ///< of what has one
    bool logarithmic = false;         ///< the map is even in logarithms, between numbers above 0
};

/// The legend of cost_colors (engine/image/frame_pictures.hpp).
Legend cost_legend();

/// The legend of a picture's colours. `coloring`: the picture's own, with the range if it has one;
/// `expression`: for ColorBy::Expression.
Legend legend_of(const Coloring& coloring, const std::string& expression);

/// The legend of the values that sections show.
Legend section_legend(const SectionValues& values);

/// "mean curvature": how a choice is called.
const char* shown_name(ColorBy by);

/// Pixels that are marked by colours or stripes.
enum class PixelMark : std::uint8_t { UndecidedDrawn, UndecidedNotDrawn, Coarse };

/// A square with the corner `lo` that looks as such pixels do.
Shapes swatch_shapes(const glm::dvec2& lo, double size, PixelMark mark, const CardStyle& style);

/// The words and colours of a picture's corner.
struct CornerLegend {
    const Legend* legend = nullptr;    ///< nullptr: the colours need no words
    const Legend* sections = nullptr;  ///< with a range; nullptr: sections show no values
    bool undecided = false;            ///< undecided pixels are marked
    bool coarse = false;               ///< and there are certified ones with a coarse bracket
};

/// A card whose right lower corner is `corner`, no wider than `space`; nothing where there is
/// nothing to say or no room.
Shapes legend_shapes(const CornerLegend& legend, const glm::dvec2& corner, const glm::dvec2& space,
                     const CardStyle& style);

}  // namespace zeroset
