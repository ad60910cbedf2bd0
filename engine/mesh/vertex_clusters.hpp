#pragma once

#include "engine/mesh/triangle_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

// Groups of vertices of a closed mesh become one vertex each. If each group's part of the mesh, its
// vertices with all sides and triangles between them, can be drawn together to a point, what is
// left is a surface of the same topology; and it is a mesh if no two sides have the same ends. A
// connected part of a closed mesh can be drawn together if V - E + F = 1.

namespace zeroset {

class VertexClusters {
public:
    static constexpr std::uint64_t alone = ~std::uint64_t{0};
    /// For each vertex whether it is one of these; groups are in a set as a whole.
    using Set = std::vector<std::uint8_t>;

    /// A closed mesh, which outlives this; each vertex is a group.
    VertexClusters(std::span<const Triangle> triangles, std::size_t vertices);

    /// Makes the groups of a set anew: neighbours with the same label, which `alone` is not.
    void join(std::span<const std::uint64_t> labels, const Set& set);
    /// The vertex that stands for v's group.
    [[nodiscard]] std::uint32_t root(std::uint32_t v) const { return roots_[v]; }
    [[nodiscard]] std::uint32_t size(std::uint32_t root) const { return sizes_[root]; }
    /// Roots of groups that must not become one vertex each, where that has to do with the set.
    [[nodiscard]] std::vector<std::uint32_t> defects(const Set& set) const;

    [[nodiscard]] Triangle roots_of(const Triangle& t) const {
        return {root(t[0]), root(t[1]), root(t[2])};
    }
    /// Whether a triangle is left, given by the roots of its vertices.
    static bool is_left(const Triangle& roots) {
        return roots[0] != roots[1] && roots[1] != roots[2] && roots[2] != roots[0];
    }
    static bool touches(const Triangle& t, const Set& set) {
        return (set[t[0]] | set[t[1]] | set[t[2]]) != 0;
    }

private:
    std::uint32_t find(std::uint32_t v);
    void find_holed(const Set& set, std::vector<std::uint32_t>& found) const;

    std::span<const Triangle> triangles_;
    std::vector<std::uint32_t> roots_, sizes_;
};

}  // namespace zeroset
