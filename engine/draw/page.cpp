#include "engine/draw/page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

/// How far curves are followed beyond the page, in parts of its size.
constexpr double margin = 0.02;
/// Nearer to the eye than this part of the distance to the point looked at nothing is drawn.
constexpr double near_part = 0x1p-10;

std::array<glm::dvec3, 8> corners_of(const Box& box) {
    std::array<glm::dvec3, 8> corners;
    for (int i = 0; i < 8; ++i) {
        for (int axis = 0; axis < 3; ++axis)
            corners.at(static_cast<std::size_t>(i))[axis] =
                ((i >> axis & 1) != 0 ? box.hi : box.lo)[axis];
    }
    return corners;
}

}  // namespace

Page::Page(const Camera& camera, const PageSize& size)
    : view_(camera),
      size_(size),
      nearest_(near_part * view_.homogeneous(view_.look_at()).z),
      reach_((1.0 + margin) * glm::dvec2(size.width / size.height, 1.0)) {}

bool Page::shows(const glm::dvec3& point) const {
    const glm::dvec3 at = view_.homogeneous(point);
    return at.z >= nearest_ && std::abs(at.x) <= reach_.x * at.z &&
           std::abs(at.y) <= reach_.y * at.z;
}

// Homogeneous places are affine in the point: a box is off the page where all of its corners are
// beyond the same edge.
bool Page::may_show(const Box& box) const {
    std::array<int, 5> beyond{};
    for (const glm::dvec3& corner : corners_of(box)) {
        const glm::dvec3 at = view_.homogeneous(corner);
        const double slack = 1e-12 * (std::abs(at.x) + std::abs(at.y) + std::abs(at.z));
        beyond[0] += at.z + slack < nearest_ ? 1 : 0;
        beyond[1] += at.x - slack > reach_.x * at.z ? 1 : 0;
        beyond[2] += -at.x - slack > reach_.x * at.z ? 1 : 0;
        beyond[3] += at.y - slack > reach_.y * at.z ? 1 : 0;
        beyond[4] += -at.y - slack > reach_.y * at.z ? 1 : 0;
    }
    return std::ranges::none_of(beyond, [](int corners) { return corners == 8; });
}

glm::dvec2 Page::place(const glm::dvec3& point) const {
    const glm::dvec3 at = view_.homogeneous(point);
    return {0.5 * size_.width + half_height() * at.x / at.z, half_height() * (1.0 - at.y / at.z)};
}

glm::dvec2 Page::motion(const glm::dvec3& point, const glm::dvec3& along) const {
    const glm::dvec3 at = view_.homogeneous(point);
    const glm::dvec3 by = view_.homogeneous(point + along) - at;
    const double x = (by.x - by.z * at.x / at.z) / at.z;
    const double y = (by.y - by.z * at.y / at.z) / at.z;
    return half_height() * glm::dvec2(x, -y);
}

double Page::scale(const glm::dvec3& point) const {
    return half_height() / view_.homogeneous(point).z;
}

double Page::diameter(const Box& box) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& corner : corners_of(box))
        nearest = std::min(nearest, view_.homogeneous(corner).z);
    if (nearest < nearest_) return std::numeric_limits<double>::infinity();
    const double slant =
        std::sqrt(1.0 + glm::dot(reach_, reach_) *
                            (view_.parallel() ? 0.0 : view_.half_height * view_.half_height));
    return glm::length(box.hi - box.lo) * half_height() * slant / nearest;
}

glm::dvec3 Page::ray_direction(const glm::dvec3& point) const {
    return view_.parallel() ? view_.forward : glm::normalize(point - view_.eye);
}

}  // namespace zeroset
