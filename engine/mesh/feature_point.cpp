#include "engine/mesh/feature_point.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

// Normals that turn by less than 26 degrees are of one side.
constexpr double same_side = 0.9;

std::optional<glm::dvec3> on_line(const FeatureSide& a, const FeatureSide& b,
                                  const glm::dvec3& near) {
    const double between = glm::dot(a.normal, b.normal);
    const double determinant = 1.0 - between * between;
    if (determinant < 0.02) return std::nullopt;
    const double to_a = glm::dot(a.normal, a.point - near);
    const double to_b = glm::dot(b.normal, b.point - near);
    return near +
           ((to_a - between * to_b) * a.normal + (to_b - between * to_a) * b.normal) / determinant;
}

std::optional<glm::dvec3> at_corner(const std::vector<FeatureSide>& sides, const glm::dvec3& near) {
    glm::dmat3 squares(0.0);
    glm::dvec3 sum(0.0);
    for (const FeatureSide& side : sides) {
        squares += glm::outerProduct(side.normal, side.normal);
        sum += side.normal * glm::dot(side.normal, side.point - near);
    }
    if (std::abs(glm::determinant(squares)) < 0.01) return std::nullopt;
    return near + glm::inverse(squares) * sum;
}

}  // namespace

std::vector<FeatureSide> sides_of(const std::vector<const MeshVertex*>& vertices) {
    std::vector<FeatureSide> sides;
    for (const MeshVertex* vertex : vertices) {
        if (vertex->normal == glm::dvec3(0.0)) continue;
        const bool known = std::ranges::any_of(sides, [&](const FeatureSide& side) {
            return glm::dot(side.normal, vertex->normal) > same_side;
        });
        if (!known) {
            sides.push_back({.base = vertex->point,
                             .point = vertex->point,
                             .normal = vertex->normal,
                             .part = vertex->part});
        }
    }
    return sides;
}

std::optional<glm::dvec3> meeting_point(const std::vector<FeatureSide>& sides,
                                        const glm::dvec3& near) {
    if (sides.size() < 2) return std::nullopt;
    return sides.size() == 2 ? on_line(sides[0], sides[1], near) : at_corner(sides, near);
}

}  // namespace zeroset
