#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/scene/region.hpp"
#include "engine/view/box.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// The solid that is meshed, as plain values: the points of a box where its function is not above 0.

namespace zeroset {

/// A function of a solid.
struct SolidPart {
    KernelFunction<RangeBatchOf<double>> range;
    /// Enclosures of its derivatives by x, y and z; where it has a kink, of all that they are
    /// nearby.
    std::array<KernelFunction<RangeBatchOf<double>>, 3> gradient;
    KernelFunction<ValueBatchOf<double>> value;
    bool branches = false;            ///< Kernel::branches
    bool defined_everywhere = false;  ///< SurfaceFacts::defined_everywhere
};

/// A step of what the solid's function is made of its parts.
struct SolidNode {
    enum class Kind : std::uint8_t { Leaf, Max, Min };
    Kind kind = Kind::Leaf;
    std::uint32_t a = 0, b = 0;  ///< nodes before this one; of a leaf, `a` is the part
    double sign = 1.0;           ///< of a leaf: its value is sign * the part's
};

/// A half space or a ball that holds the solid. Its function is below 0 inside and has a slope of
/// length 1 at its border.
struct SolidCut {
    bool is_ball = false;
    glm::dvec3 place{0.0};  ///< the half space's normal, of length 1; the ball's centre
    double reach = 0.0;     ///< the half space's offset; the ball's radius

    [[nodiscard]] double value(const glm::dvec3& point) const {
        if (!is_ball) return glm::dot(place, point) - reach;
        const glm::dvec3 away = point - place;
        return (glm::dot(away, away) - reach * reach) / (2.0 * reach);
    }
    [[nodiscard]] glm::dvec3 gradient(const glm::dvec3& point) const {
        return is_ball ? (point - place) / reach : place;
    }
};

/// The solid: where the function that `nodes` make of the parts, and all cuts, are <= 0. Points
/// where it is not defined are not in the solid. The first `surface_parts` parts are of what was
/// asked for, the rest only ends it, as cuts do.
struct MeshSolid {
    std::vector<SolidPart> parts;
    std::vector<SolidNode> nodes;  ///< the last is the root
    std::size_t surface_parts = 1;
    std::vector<SolidCut> cuts;
    Uniforms uniforms;
    Box box;

    /// Adds a node; returns its number.
    std::uint32_t add(const SolidNode& node) {
        nodes.push_back(node);
        return static_cast<std::uint32_t>(nodes.size() - 1);
    }
};

/// The faces of the box, the region's ball and its sections as cuts.
std::vector<SolidCut> cuts_of(const Box& box, const Region& region);

}  // namespace zeroset
