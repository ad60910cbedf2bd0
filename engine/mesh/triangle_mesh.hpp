#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace zeroset {

/// Three numbers of vertices, counter-clockwise as seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// The kind of place on the surface where a vertex lies.
enum class VertexKind : std::uint8_t { Smooth, Crease, Corner };

struct MeshVertex {
    glm::dvec3 point{0.0};
    glm::dvec3 normal{0.0};  ///< of length 1, outward; 0 where it is not known
    VertexKind kind = VertexKind::Smooth;
    std::uint32_t part = 0;  ///< SolidValue::part there
    float error = 0.0F;      ///< about how far the surface is, world units
};

struct TriangleMesh {
    std::vector<MeshVertex> vertices;
    std::vector<Triangle> triangles;
};

}  // namespace zeroset
