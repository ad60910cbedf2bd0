#include "engine/antialias/seen_sheet.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// How far beside the hit, in pixels, the sheet's reach along rays is taken.
constexpr double most_pixels = 4.0;
/// The least cosine between ray and normal: sheets seen more from aside are taken as seen so.
constexpr double least_slant = 0.02;

}  // namespace

SeenSheet::SeenSheet(const TileRays& rays, double col, double row, double distance,
                     const glm::dvec3& gradient_of_f)
    : gradient(gradient_of_f) {
    const ViewFrame& view = rays.axes();
    const glm::dvec3 direction = view.forward + rays.u(col) * view.right + rays.v(row) * view.up;
    slope = glm::dot(gradient, direction);
    const double sizes = std::sqrt(glm::dot(gradient, gradient) * glm::dot(direction, direction));
    // With parallel rays `distance` is so large that its sum with a depth is the same everywhere.
    const double away = view.parallel() ? rays.distance() : distance;
    const double width = most_pixels * rays.pixel() * away;
    reach = width * sizes / std::max(std::abs(slope), least_slant * sizes);
}

}  // namespace zeroset
