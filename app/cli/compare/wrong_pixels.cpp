#include "app/cli/compare/wrong_pixels.hpp"

#include "engine/view/pixel_ray.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// The distance along a ray for a step of 1 along its dominant axis.
double stretch_of(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    return glm::length(direction) / std::max({size.x, size.y, size.z});
}

}  // namespace

WrongPixels wrong_pixels(const Framebuffer& frame, const Framebuffer& proved, const Camera& camera,
                         double tolerance) {
    const ViewFrame view(camera);
    const ImageSize image{.width = frame.width, .height = frame.height};
    WrongPixels wrong;
    for (int row = 0; row < frame.height; ++row) {
        for (int col = 0; col < frame.width; ++col) {
            const std::size_t i = frame.index(col, row);
            const bool is_shown = std::isfinite(frame.depth[i]);
            bool claims = false;
            if (proved.certificate[i] == Certificate::Miss) {
                if (!is_shown) continue;
                ++wrong.added;
                claims = is_proved(frame.certificate[i]);
            } else if (!is_proved(proved.certificate[i])) {
                continue;
            } else if (!is_shown) {
                ++wrong.missed;
                claims = frame.certificate[i] == Certificate::Miss;
            } else {
                const auto depth = static_cast<double>(proved.depth[i]);
                const double rounding = 0x1p-20 * (std::abs(depth) + glm::length(view.eye));
                const double allowed =
                    tolerance * stretch_of(view.direction(pixel_centre(col, row), image)) +
                    rounding;
                if (std::abs(static_cast<double>(frame.depth[i]) - depth) <= allowed) continue;
                ++wrong.moved;
                claims = is_proved(frame.certificate[i]);
            }
            wrong.refuted += claims ? 1 : 0;
        }
    }
    return wrong;
}

}  // namespace zeroset
