#pragma once

#include "engine/mesh/triangle_mesh.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace zeroset {

/// A smooth side of the surface near a feature: a point on it and its tangent plane.
struct FeatureSide {
    glm::dvec3 base{0.0};                ///< a vertex on this side
    glm::dvec3 point{0.0}, normal{0.0};  ///< of the plane
    std::uint32_t part = 0;              ///< SolidValue::part at the base
};

/// Sides of vertices: each with a normal that turns from the others' by more than an angle.
std::vector<FeatureSide> sides_of(const std::vector<const MeshVertex*>& vertices);

/// Where two planes or three meet, nearest to `near`; of more, where they come closest. Nothing
/// where they are nearly parallel.
std::optional<glm::dvec3> meeting_point(const std::vector<FeatureSide>& sides,
                                        const glm::dvec3& near);

}  // namespace zeroset
