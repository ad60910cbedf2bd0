#pragma once

#include "engine/image/color_map.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/image/rgba_image.hpp"

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

/// Takes rows of a picture over into a small one of all of it, whose sides are `most_px` at most.
/// `frame`: the part that begins at `row` of `rows`. The small one is opaque; what is not there yet
/// is transparent.
void take_over(const Framebuffer& frame, int row, int rows, int most_px, RgbaImage& small);

}  // namespace zeroset
