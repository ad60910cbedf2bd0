#pragma once

#include "engine/kernel/point_batch.hpp"
#include "engine/mesh/mesh_work.hpp"
#include "engine/mesh/solid.hpp"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// The solid's function at a point, each part and cut divided by the length of its gradient.
struct SolidValue {
    /// About the distance from the surface, below 0 inside; +inf where it is not defined.
    double level = 0.0;
    glm::dvec3 normal{0.0};  ///< the gradient's direction, of length 1; 0 where it vanishes
    std::uint32_t part = 0;  ///< the part, or parts.size() + the number of a cut, that it is

    /// Whether the point lies in the solid; points of the surface lie outside.
    [[nodiscard]] bool inside() const { return level < 0; }
    [[nodiscard]] double distance() const { return std::abs(level); }
};

/// Whether values have normals, or levels and parts alone, which is quicker.
enum class Normals : std::uint8_t { Without, With };

/// Values at points, any number of them, on all cores.
std::vector<SolidValue> field_at(const MeshSolid& solid, std::span<const glm::dvec3> points,
                                 const MeshWork& work, Normals normals = Normals::With);

/// The values at points, on this thread, in upward rounding; `values` has as many items as
/// `points`.
void field_here(const MeshSolid& solid, std::span<const glm::dvec3> points,
                std::span<SolidValue> values, Normals normals = Normals::With);

/// The part's or the cut's own value at a point, with the sign of its first leaf.
struct PartPlace {
    std::uint32_t part;
    glm::dvec3 point;
};
std::vector<SolidValue> parts_at(const MeshSolid& solid, std::span<const PartPlace> places);

}  // namespace zeroset
