#pragma once

#include "engine/view/camera.hpp"
#include "engine/view/unit_vector.hpp"

#include <glm/glm.hpp>

#include <optional>

namespace zeroset {

/// The ray of a pixel: the point at the distance t (see ViewFrame) is origin + t direction.
struct PixelRay {
    glm::dvec3 origin;
    UnitVector direction;

    [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// The ray through a point of an image.
inline PixelRay pixel_ray(const ViewFrame& view, const PixelPoint& at, const ImageSize& image) {
    return {.origin = view.origin(at, image), .direction = UnitVector(view.direction(at, image))};
}
inline PixelRay pixel_ray(const ViewFrame& view, const ViewPoint& at) {
    return pixel_ray(view, pixel_point(at, unit_image), unit_image);
}

/// The place at which a point shows in the image, and the point's distance along its ray. Nothing
/// for a point on no ray, which is one not in front of the eye of a perspective view.
struct PlaceInView {
    ViewPoint place;
    double distance;
};
inline std::optional<PlaceInView> place_in_view(const ViewFrame& view, const glm::dvec3& point) {
    const glm::dvec3 shown = view.homogeneous(point);
    if (!(shown.z > 0.0)) return std::nullopt;
    return PlaceInView{.place = {.x = 0.5 / shown.z * shown.x, .y = 0.5 / shown.z * shown.y},
                       .distance = view.distance_of(point)};
}

}  // namespace zeroset
