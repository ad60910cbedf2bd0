#include "engine/annotate/hidden.hpp"

#include "engine/view/pixel_ray.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace zeroset {

glm::ivec2 pixel_under(const Framebuffer& frame, const ViewPoint& place) {
    return {static_cast<int>(std::floor(0.5 * frame.width + place.x * frame.height)),
            static_cast<int>(std::floor((0.5 - place.y) * frame.height))};
}

bool is_behind(const Framebuffer& frame, const ViewFrame& view, const glm::dvec3& point) {
    const auto seen = place_in_view(view, point);
    if (!seen) return true;
    const glm::ivec2 pixel = pixel_under(frame, seen->place);
    // On the surface itself a pixel's centre is as near as the point, but for its slant.
    float farthest = 0.0F;
    for (int row = std::max(pixel.y - 1, 0); row <= std::min(pixel.y + 1, frame.height - 1);
         ++row) {
        for (int col = std::max(pixel.x - 1, 0); col <= std::min(pixel.x + 1, frame.width - 1);
             ++col)
            farthest = std::max(farthest, frame.depth[frame.index(col, row)]);
    }
    constexpr double slack = 1.0 + 1e-4;
    return seen->distance > slack * static_cast<double>(farthest);
}

glm::dvec3 before_ball(const ViewFrame& view, const glm::dvec3& middle, double radius) {
    constexpr double margin = 1.05;
    const glm::dvec3 drawn = view.stretch * middle;
    const glm::dvec3 towards = view.eye - drawn;
    const glm::dvec3 way = view.parallel() ? -view.forward : glm::normalize(towards);
    const double free = view.parallel() ? margin * radius : 0.5 * glm::length(towards);
    return (drawn + std::min(margin * radius, free) * way) / view.stretch;
}

}  // namespace zeroset
