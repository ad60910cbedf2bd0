#pragma once

#include "engine/mesh/solid.hpp"
#include "engine/mesh/triangle_mesh.hpp"
#include "engine/trace/time_limit.hpp"

#include <glm/glm.hpp>

#include <cstddef>
#include <functional>
#include <vector>

namespace zeroset {

/// The steps of the work, for who watches it.
enum class MeshStage : std::uint8_t { Dividing, Proving, Contouring, Thinning };

struct MeshOptions {
    double tolerance = 0.004;  ///< how far the mesh may be from the surface, world units; above 0
    int depth = 0;             ///< the smallest cells are the root's edge * 2^-depth; 0: as the
                               ///< tolerance wants it
    std::size_t most_cells = 1'000'000;
    std::size_t most_uncertain = 40'000;  ///< GrowthLimits::most_uncertain
    std::size_t most_triangles = 0;  ///< raises the tolerance of thinning until no more are left;
                                     ///< 0: any number
    bool thin = true;                ///< takes away triangles that the tolerance does not need
    int threads = 0;                 ///< 0: all cores
    /// Cells are divided for two fifths of the time, proved for a fifth, roots are looked for for
    /// another one, triangles thinned for the rest.
    TimeLimit limit = {};
    std::function<void(MeshStage)> on_stage = {};  ///< on the caller's thread
};

/// A place where the topology is not proved: a group of cells.
struct UnprovedPlace {
    glm::dvec3 cell{0.0};  ///< the middle of one of them
    double reach = 0.0;    ///< half the longest edge of the box that holds the cells
    std::size_t cells = 0;
};

/// A report on how a mesh was made and what of it is proved.
struct MeshReport {
    std::size_t cells = 0;     ///< of the octree, in all
    std::size_t proved = 0;    ///< leaves at the surface whose topology is proved
    std::size_t unproved = 0;  ///< and those where it is not
    /// Leaves where the function is proved to rise along one direction, so that nothing closed is
    /// lost in them, but the mesh is not: sharp edges.
    std::size_t rough = 0;
    std::vector<UnprovedPlace> places, rough_places;
    double smallest_cell = 0.0;    ///< its edge
    bool cut = false;              ///< cells or time did not suffice
    bool dense = false;            ///< GrowthLimits::most_uncertain ended the division
    bool isotopic = false;         ///< the mesh of roots is proved isotopic to the surface
    bool unchanged = true;         ///< the mesh is that one: no edges were put in, nothing thinned
    double tolerance = 0.0;        ///< what thinning kept
    double deviation = 0.0;        ///< the greatest distance from the surface that was measured
    std::size_t thinned_from = 0;  ///< triangles before
};

struct MadeMesh {
    TriangleMesh mesh;
    MeshReport report;
};

/// The surface of a solid as triangles: closed, every edge in two triangles, outward. Without any
/// where the work was cancelled.
MadeMesh make_mesh(const MeshSolid& solid, const MeshOptions& options);

}  // namespace zeroset
