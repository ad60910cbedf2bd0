#pragma once

#include "engine/mesh/field_on_boxes.hpp"
#include "engine/view/box.hpp"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// The octree of a mesh: cells with what enclosures tell of them.

namespace zeroset {

/// A place of the tree's lattice: 2^(deepest + 1) steps along each edge of the root, so that the
/// middles of the smallest cells have places, too.
using Place = glm::ivec3;

struct MeshCell {
    Place corner{0};                ///< the least one
    std::uint32_t first_child = 0;  ///< of eight; 0: a leaf
    std::uint8_t level = 0;
    bool uncertain = false;  ///< its topology could not be proved
    std::uint8_t tries = 0;  ///< how often an ancestor was divided for its edges' sake
    bool coarse = false;     ///< the surface in it is farther from a plane than the tolerance
    float bend = 0.0F;       ///< about the greatest curvature of the surface in it, if smooth
    BoxFacts facts;

    [[nodiscard]] bool is_leaf() const { return first_child == 0; }
    [[nodiscard]] bool is_active() const { return facts.side == BoxSide::Unknown; }
};

/// The edge of the root, in those of the box.
inline constexpr double root_edge = 1.41713;
/// Cells that the surface may go through are divided at least so often.
inline constexpr int least_level = 3;

class CellTree {
public:
    static constexpr int deepest_ever = 18;

    /// A cube that holds `box`, its places apart from the box's faces, edges and middle. `deepest`:
    /// the level of the smallest cells, at most deepest_ever.
    CellTree(const Box& box, int deepest);

    [[nodiscard]] int deepest() const { return deepest_; }
    [[nodiscard]] std::size_t size() const { return cells_.size(); }
    [[nodiscard]] const MeshCell& operator[](std::size_t i) const { return cells_[i]; }
    MeshCell& operator[](std::size_t i) { return cells_[i]; }

    /// The length of a cell's edge, in places and in the world.
    [[nodiscard]] int width(const MeshCell& cell) const { return 1 << (deepest_ + 1 - cell.level); }
    [[nodiscard]] double step() const { return step_; }
    [[nodiscard]] double edge(const MeshCell& cell) const { return step_ * width(cell); }
    [[nodiscard]] Place middle(const MeshCell& cell) const {
        return cell.corner + Place(width(cell) / 2);
    }
    [[nodiscard]] glm::dvec3 point(const Place& place) const {
        return lo_ + step_ * glm::dvec3(place);
    }
    [[nodiscard]] Box box(const MeshCell& cell) const {
        return {.lo = point(cell.corner), .hi = point(cell.corner + Place(width(cell)))};
    }
    /// Whether the place lies in the root, its upper faces excluded.
    [[nodiscard]] bool contains(const Place& place) const;
    /// The leaf that holds the place, or its ancestor at `level` where that is not deeper.
    [[nodiscard]] std::uint32_t find(const Place& place, int level = deepest_ever) const;
    /// The cell of the same size across a face, or the leaf that holds it; `size()` at the border.
    [[nodiscard]] std::uint32_t neighbour(const MeshCell& cell, int axis, int direction) const;

    /// Adds the leaves that touch a cell, itself among them.
    void add_touching(const MeshCell& cell, std::vector<std::uint32_t>& leaves) const;

    /// The leaves that touch these cells, each once.
    [[nodiscard]] std::vector<std::uint32_t> touching(std::span<const std::uint32_t> cells) const;

    /// Divides a leaf; returns its first child.
    std::uint32_t split(std::uint32_t leaf);

private:
    void add_touching(std::uint32_t under, const Place& lo, const Place& hi,
                      std::vector<std::uint32_t>& leaves) const;

    int deepest_;
    glm::dvec3 lo_;
    double step_;
    std::vector<MeshCell> cells_;
};

}  // namespace zeroset
