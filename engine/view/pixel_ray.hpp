#pragma once

#include "engine/view/camera.hpp"

#include <glm/glm.hpp>

#include <optional>

namespace zeroset {

/// The ray of a pixel: the point at the distance t (see ViewFrame) is origin + t direction.
struct PixelRay {
    glm::dvec3 origin;
    glm::dvec3 direction;  ///< of length 1

    [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// The ray through the point (col, row) of an image, in pixels. The centre of a pixel is at
/// (i + 0.5, j + 0.5).
inline PixelRay pixel_ray(const ViewFrame& view, double col, double row, int width_px,
                          int height_px) {
    return {.origin = view.origin(col, row, width_px, height_px),
            .direction = glm::normalize(view.direction(col, row, width_px, height_px))};
}

/// The place at which a point shows in the image, in heights of it from its centre, x to the right,
/// y upwards, and the point's distance along its ray. Nothing for a point on no ray, which is one
/// not in front of the eye of a perspective view.
struct PlaceInView {
    glm::dvec2 place;
    double distance;
};
inline std::optional<PlaceInView> place_in_view(const ViewFrame& view, const glm::dvec3& point) {
    const glm::dvec3 shown = view.homogeneous(point);
    if (!(shown.z > 0.0)) return std::nullopt;
    return PlaceInView{.place = 0.5 / shown.z * glm::dvec2(shown),
                       .distance = view.distance_of(point)};
}

}  // namespace zeroset
