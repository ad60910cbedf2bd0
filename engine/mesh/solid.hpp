#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/scene/region.hpp"
#include "engine/view/box.hpp"

#include <array>
#include <cstddef>
#include <vector>

// What is meshed, as plain values: the points of a box where no function is above 0.

namespace zeroset {

/// A function f of a solid, which lies where sign * f <= 0.
struct SolidPart {
    KernelFunction<RangeBatchOf<double>> range;
    /// Enclosures of f's derivatives by x, y and z; where f has a kink, of all that they are nearby.
    std::array<KernelFunction<RangeBatchOf<double>>, 3> gradient;
    KernelFunction<ValueBatchOf<double>> value;
    double sign = 1.0;                ///< -1 or 1
    bool branches = false;            ///< Kernel::branches
    bool defined_everywhere = false;  ///< Kernel::defined_everywhere
};

/// A half space or a ball that holds the solid. Its function is below 0 inside and has a slope of
/// length 1 at its border.
struct SolidCut {
    bool is_ball = false;
    glm::dvec3 place{0.0};  ///< the half space's normal, of length 1; the ball's centre
    double reach = 0.0;     ///< the half space's offset; the ball's radius

    [[nodiscard]] double value(const glm::dvec3& point) const;
    [[nodiscard]] glm::dvec3 gradient(const glm::dvec3& point) const;
};

/// The solid: where every part's sign * f <= 0 and every cut's function <= 0. Parts that are not
/// defined at a point do not hold it. The first `surface_parts` parts are what was asked for, the
/// rest only ends it, as cuts do.
struct MeshSolid {
    std::vector<SolidPart> parts;
    std::size_t surface_parts = 1;
    std::vector<SolidCut> cuts;
    Uniforms uniforms;
    Box box;
};

/// The faces of the box, the region's ball and its sections as cuts.
std::vector<SolidCut> cuts_of(const Box& box, const Region& region);

}  // namespace zeroset
