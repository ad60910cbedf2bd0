#pragma once

#include "engine/view/camera.hpp"
#include "engine/view/pixel_ray.hpp"

#include <glm/glm.hpp>

#include <cmath>

// Where things are that are dragged in the picture.

namespace zeroset::ui {

/// The point that shows at `place`, as far along the view as `point`.
inline glm::dvec3 across_view(const ViewFrame& view, const glm::dvec3& point,
                              const ViewPoint& place) {
    const glm::dvec3 seen = view.homogeneous(point);
    const double x = 2.0 * seen.z * place.x - seen.x;
    const double y = 2.0 * seen.z * place.y - seen.y;
    return point + (x * view.right + y * view.up) / view.stretch;
}

/// A number of world units, to a power of ten that is no larger than a pixel there.
inline double rounded_to_pixel(double number, double pixel) {
    const double power = std::floor(std::log10(pixel));
    const double unit = std::pow(10.0, std::abs(power));
    const double whole = std::round(power < 0 ? number * unit : number / unit);
    constexpr double exact = 0x1p52;
    if (!(std::abs(whole) < exact)) return number;
    return power < 0 ? whole / unit : whole * unit;
}

}  // namespace zeroset::ui
