#include "engine/image/frame_pictures.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <numeric>

namespace zeroset {
namespace {

std::uint32_t color_of(float cost) {
    const double above = std::log(static_cast<double>(cost) / cheapest_pixel);
    const double place = above / std::log(dearest_pixel / cheapest_pixel);
    return shown_color_at(cost_map, std::clamp(place, 0.0, 1.0));
}

}  // namespace

std::vector<std::uint32_t> cost_colors(const Framebuffer& frame) {
    assert(frame.cost.size() == frame.color.size());
    std::vector<std::uint32_t> colors;
    colors.reserve(frame.cost.size());
    std::ranges::transform(frame.cost, std::back_inserter(colors), color_of);
    return colors;
}

double mean_cost(const Framebuffer& frame) {
    if (frame.cost.empty()) return 0.0;
    return std::accumulate(frame.cost.begin(), frame.cost.end(), 0.0) /
           static_cast<double>(frame.cost.size());
}

}  // namespace zeroset
