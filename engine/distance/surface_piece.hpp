#pragma once

#include "engine/view/box.hpp"

#include <glm/glm.hpp>

#include <limits>
#include <span>

namespace zeroset {

/// Bounds of a distance.
struct DistanceBounds {
    double lo = std::numeric_limits<double>::infinity();
    double hi = std::numeric_limits<double>::infinity();

    [[nodiscard]] double gap() const { return hi > lo ? hi - lo : 0.0; }
};

/// A box with a slab that holds all of its zeros:
/// |dot(normal, x - middle) - offset| <= half_width.
struct SurfacePiece {
    Box box;
    glm::dvec3 normal{0.0};  ///< of length about 1; 0: the whole box may hold zeros
    double offset = 0.0, half_width = 0.0;
    /// Whether any segment along the normal through the slab, within the box, surely holds a zero.
    bool crosses = false;
    bool has_zero = false;  ///< whether the box surely holds one

    /// Bounds of the distance from a point to the zeros in the box: `lo` holds for all of them,
    /// `hi` for one that is proved. In any rounding mode.
    [[nodiscard]] DistanceBounds distance(const glm::dvec3& point) const;
    /// Whether the slab misses the box, so that it holds no zeros.
    [[nodiscard]] bool is_empty() const;
};

/// A piece that holds all zeros of some pieces, at least one, and tells of none that is proved: a
/// slab along the mean of their normals.
SurfacePiece hull_of(std::span<const SurfacePiece> pieces);

/// A lower bound of the distance from a point to a box.
double distance_below(const Box& box, const glm::dvec3& point);

}  // namespace zeroset
