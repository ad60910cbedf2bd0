#pragma once

#include "engine/kernel/point_batch.hpp"
#include "engine/mesh/solid.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// The solid's function at a point: the greatest of its parts and cuts.
struct FieldValue {
    double f = 0.0;  ///< above 0 outside; +inf where it is not defined
    glm::dvec3 gradient{0.0};
    std::uint32_t part = 0;  ///< the greatest: a part, or parts.size() + the number of a cut

    /// Whether the point lies in the solid; points of the surface lie outside.
    [[nodiscard]] bool inside() const { return f < 0; }
    /// About how far the surface is: |f| over the gradient's length.
    [[nodiscard]] double distance() const;
};

/// Values at points, any number of them, on all cores.
std::vector<FieldValue> field_at(const MeshSolid& solid, std::span<const glm::dvec3> points,
                                 int threads);

}  // namespace zeroset
