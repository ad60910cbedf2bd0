#include "engine/mesh/cell_tree.hpp"

#include <algorithm>
#include <cassert>

namespace zeroset {

CellTree::CellTree(const Box& box, int deepest) : deepest_(std::min(deepest, deepest_ever)) {
    // The margin is wider than the largest cells that may stay active (least_level): so all cells
    // at the border are proved to be outside. Odd shares of the box keep the lattice off planes of
    // symmetry, where surfaces like to go through many places at once.
    const glm::dvec3 margin = box.size() * glm::dvec3(0.20317, 0.21129, 0.20751);
    const glm::dvec3 middle = box.centre();
    constexpr double larger = root_edge;
    lo_ = middle - glm::dvec3(0.5 * box.size()) - margin;
    step_ = larger * box.size() / static_cast<double>(1U << static_cast<unsigned>(deepest_ + 1));
    cells_.emplace_back();
}

bool CellTree::contains(const Place& place) const {
    const int width = 1 << (deepest_ + 1);
    const auto inside = [&](int i) { return i >= 0 && i < width; };
    return inside(place.x) && inside(place.y) && inside(place.z);
}

std::uint32_t CellTree::find(const Place& place, int level) const {
    std::uint32_t found = 0;
    while (!cells_[found].is_leaf() && cells_[found].level < level) {
        const MeshCell& cell = cells_[found];
        const int half = width(cell) / 2;
        const Place at = place - cell.corner;
        const int child = (at.x >= half ? 1 : 0) | (at.y >= half ? 2 : 0) | (at.z >= half ? 4 : 0);
        found = cell.first_child + static_cast<std::uint32_t>(child);
    }
    return found;
}

std::uint32_t CellTree::neighbour(const MeshCell& cell, int axis, int direction) const {
    Place place = cell.corner;
    place[axis] += direction > 0 ? width(cell) : -1;
    return contains(place) ? find(place, cell.level) : static_cast<std::uint32_t>(size());
}

void CellTree::add_touching(const MeshCell& cell, std::vector<std::uint32_t>& leaves) const {
    add_touching(0, cell.corner, cell.corner + Place(width(cell)), leaves);
}

void CellTree::add_touching(std::uint32_t under, const Place& lo, const Place& hi,
                            std::vector<std::uint32_t>& leaves) const {
    const MeshCell& cell = cells_[under];
    const Place end = cell.corner + Place(width(cell));
    for (int axis = 0; axis < 3; ++axis) {
        if (cell.corner[axis] > hi[axis] || end[axis] < lo[axis]) return;
    }
    if (cell.is_leaf()) return leaves.push_back(under);
    for (std::uint32_t child = 0; child < 8; ++child)
        add_touching(cell.first_child + child, lo, hi, leaves);
}

std::vector<std::uint32_t> CellTree::touching(std::span<const std::uint32_t> cells) const {
    std::vector<std::uint32_t> leaves;
    for (const std::uint32_t cell : cells)
        add_touching(cells_[cell], leaves);
    std::ranges::sort(leaves);
    leaves.erase(std::ranges::unique(leaves).begin(), leaves.end());
    return leaves;
}

std::uint32_t CellTree::split(std::uint32_t leaf) {
    assert(cells_[leaf].is_leaf() && cells_[leaf].level < deepest_);
    const auto first = static_cast<std::uint32_t>(cells_.size());
    const MeshCell parent = cells_[leaf];
    cells_[leaf].first_child = first;
    const int half = width(parent) / 2;
    for (int child = 0; child < 8; ++child) {
        MeshCell& cell = cells_.emplace_back();
        cell.corner = parent.corner + half * Place(child & 1, child >> 1 & 1, child >> 2);
        cell.tries = parent.tries;
        cell.level = static_cast<std::uint8_t>(parent.level + 1);
    }
    return first;
}

}  // namespace zeroset
