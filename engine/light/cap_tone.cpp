#include "engine/light/shade.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {

float cap_tone(const ViewFrame& view, int height_px, const glm::dvec3& point,
               const glm::dvec3& normal) {
    constexpr double lines_a_height = 72.0;
    constexpr double plain = 0.9;
    constexpr double line = 0.74;
    constexpr double line_share = 0.3;
    const double pixel = view.pixel_at_look(height_px);
    // A power of two, so that lines stay where they are while the view changes a little.
    const double spacing = std::exp2(std::round(std::log2(pixel * height_px / lines_a_height)));
    const glm::dvec3 size = glm::abs(normal);
    const glm::dvec3 aside = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                             : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                  : glm::dvec3(0, 0, 1);
    const glm::dvec3 a = glm::normalize(glm::cross(normal, aside));
    const double place = glm::dot(point, glm::normalize(a + glm::cross(normal, a))) / spacing;
    const double from_line = spacing * std::abs(place - std::round(place));
    const double covered =
        std::clamp((0.5 * line_share * spacing - from_line) / pixel + 0.5, 0.0, 1.0);
    return static_cast<float>(plain + covered * (line - plain));
}

}  // namespace zeroset
