#pragma once

#include "engine/trace/trace_frame.hpp"
#include "papers/octree/octree_space.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace zeroset {

/// The octants that may hold a surface down to a level, where they are voxels [Stolte05, sec. 2.2].
/// Compact: a node is a byte for its eight octants and the place of the first of those that there
/// are; voxels have no nodes. Read-only; any thread.
///
/// Octants count as in the paper: bit 0 is set on the upper side of x, bit 1 of y, bit 2 of z.
struct Octree : PreparedSurface {
    struct Node {
        std::uint32_t first = 0;  ///< place in the next level of the node's first octant
        std::uint8_t octants = 0;
    };
    static constexpr std::uint32_t no_node = std::numeric_limits<std::uint32_t>::max();

    OctreeSpace space;
    std::vector<std::vector<Node>> levels;  ///< of levels 0, 1, ...; none: nothing is voxelised

    /// The level of the voxels.
    [[nodiscard]] int depth() const { return static_cast<int>(levels.size()); }
    [[nodiscard]] const Node& node(int level, std::uint32_t place) const {
        return levels[static_cast<std::size_t>(level)][place];
    }
    /// The place in the next level of an octant that the node has.
    static std::uint32_t place_of(const Node& node, unsigned octant) {
        const unsigned before = node.octants & ((1U << octant) - 1U);
        return node.first + static_cast<std::uint32_t>(std::popcount(before));
    }
    [[nodiscard]] std::size_t bytes() const {
        std::size_t nodes = 0;
        for (const std::vector<Node>& level : levels)
            nodes += level.size();
        return nodes * sizeof(Node);
    }
    [[nodiscard]] std::size_t voxels() const {
        std::size_t count = 0;
        if (levels.empty()) return count;
        for (const Node& node : levels.back())
            count += static_cast<std::size_t>(std::popcount(node.octants));
        return count;
    }
};

}  // namespace zeroset
