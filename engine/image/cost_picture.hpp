#pragma once

#include "engine/image/color_map.hpp"
#include "engine/image/framebuffer.hpp"

#include <cstdint>
#include <vector>

namespace zeroset {

/// The colours of costs: a scale that is even in their logarithm, the same for all pictures, so
/// that those of different formulas and tracers can be compared.
inline constexpr ColorMap cost_map = ColorMap::Ember;
/// Evaluations a pixel at the ends of the scale; beyond them the colour stays.
inline constexpr double cheapest_pixel = 0.1, dearest_pixel = 1000.0;

/// The cost of each pixel, for a frame that keeps its costs, as colours of Framebuffer.
std::vector<std::uint32_t> cost_colors(const Framebuffer& frame);

/// The mean of what a pixel took; 0 for a frame that does not keep costs.
double mean_cost(const Framebuffer& frame);

}  // namespace zeroset
