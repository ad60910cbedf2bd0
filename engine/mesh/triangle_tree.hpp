#pragma once

#include "engine/mesh/triangle_mesh.hpp"
#include "engine/real/unbounded.hpp"
#include "engine/view/box.hpp"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace zeroset {

/// A mesh's triangles in boxes within boxes, for rays. The mesh must stay as it is.
class TriangleTree {
public:
    struct Hit {
        double distance;
        std::uint32_t triangle;
    };

    explicit TriangleTree(const TriangleMesh& mesh);
    /// The nearest triangle that a ray leaves by, from behind, except `own`. `direction`: of length
    /// 1. A ray along an edge meets one of the edge's triangles, if it leaves by one. Triangles
    /// farther than `most` may be missed.
    [[nodiscard]] std::optional<Hit> way_out(const glm::dvec3& from, const glm::dvec3& direction,
                                             std::uint32_t own, double most = unbounded) const;

private:
    struct Node {
        Box box;
        std::uint32_t first = 0, count = 0;  ///< of `order_`; 0: two nodes
        std::uint32_t second = 0;            ///< the other node; the first one follows this
    };

    void build(std::size_t first, std::size_t count, std::span<const Box> boxes);
    void meet(std::uint32_t triangle, const glm::dvec3& from, const glm::dvec3& direction,
              std::optional<Hit>& nearest) const;

    const TriangleMesh& mesh_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace zeroset
