#pragma once

#include <optional>
#include <string>
#include <string_view>

// Plotting commands of other programs: ContourPlot3D[...], implicit_plot3d(...), fimplicit3(...).

namespace zeroset {

/// The text with plotting commands of Mathematica, Maple, Sage, MATLAB and GeoGebra as statements:
/// Plot3D[x y, {x, -1, 1}, {y, -2, 2}] becomes z=x y,-1<x<1,-2<y<2 between spaces. It has as many
/// bytes, and expressions stay where they are as far as there is room. What only tells how a
/// surface looks is left out. nullopt: the text has no such command.
std::optional<std::string> without_commands(std::string_view text);

}  // namespace zeroset
