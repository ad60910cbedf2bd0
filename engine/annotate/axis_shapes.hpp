#pragma once

#include "engine/annotate/axes.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/image/background.hpp"

#include <cstdint>

namespace zeroset {

/// Opacity of a line behind a surface, as a part of what it would be before it.
inline constexpr double hidden_opacity = 0.22;

/// How axes look on a canvas.
struct AxisStyle {
    AxisColors colors = axes_on_dark;
    double em = 12.0;                      ///< size of the labels, as in the AxesView
    double least_width = 1.0;              ///< of lines
    double hidden_label = hidden_opacity;  ///< opacity of a label behind a surface, as a part
    std::uint32_t label_outline = 0;       ///< about a label before surfaces; 0: none
    std::uint32_t halo = 0;  ///< beside axes, ticks and edges of the box before surfaces; 0: none
};

/// The style that is readable on this background and on surfaces before it.
AxisStyle axis_style_on(const Background& background, double em);

/// The style for pictures without a background, on whatever they are laid: no halos, and colours
/// that are neither light nor dark.
AxisStyle axis_style_on_anything(double em);

/// Halos, lines, then labels.
Shapes axis_shapes(const Axes& axes, const AxisStyle& style);

/// Size of the labels in a picture of this size.
double label_em(int width_px, int height_px);

}  // namespace zeroset
