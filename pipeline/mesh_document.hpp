#pragma once

#include "engine/mesh/files/mesh_file.hpp"
#include "engine/mesh/finished_mesh.hpp"
#include "engine/mesh/make_mesh.hpp"
#include "engine/mesh/mesh_facts.hpp"
#include "engine/trace/time_limit.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/mesh_solid.hpp"
#include "pipeline/picture_request.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// The settings for the meshes of a document.
struct MeshSettings {
    std::optional<double> tolerance =
        std::nullopt;                ///< world units; none: a thousandth of the clip box's edge
    double size_mm = 100.0;          ///< the longest edge of what holds all surfaces
    std::size_t most_triangles = 0;  ///< of each surface; 0: as many as the tolerance wants
    std::optional<std::size_t> surface =
        std::nullopt;   ///< its number, from 1 on; none: all that are shown
    bool open = false;  ///< without what ends the solid
    /// The thickness of a wall that each surface, taken as open, becomes instead; millimetres.
    std::optional<double> wall_mm = std::nullopt;
    bool thin = true;
    int depth = 0;  ///< MeshOptions::depth
    int threads = 0;
    TimeLimit limit = {};
    std::function<void(MeshStage)> on_stage = {};
};

/// One surface's mesh.
struct SurfaceMesh {
    std::size_t number = 1;  ///< among the program's surfaces, from 1 on
    std::string text;
    MeshReport report;
    MeshFacts facts;
    std::optional<SmallestWall> wall = std::nullopt;  ///< of a closed mesh that has one
};

/// All meshes of a document, ready for a file.
struct DocumentMeshes {
    std::vector<SurfaceMesh> surfaces;  ///< in the order of file.objects
    MeshFile file;
    double tolerance = 0.0;
    std::size_t unproved = 0;  ///< cells of surfaces without a triangle whose sign is not proved
};

/// Makes the meshes of the surfaces that the request shows, or says in one line why a wall cannot
/// be made; those without a triangle are left out.
/// Thread-safe.
OrInputError<DocumentMeshes> mesh_document(const PictureRequest& request,
                                           const MeshSettings& settings);

/// Why there is no mesh, where there is none.
std::string nothing_found(const DocumentMeshes& meshes);

/// One line on what of a surface's topology is proved.
std::string proof_line(const MeshReport& report);

/// Whether triangles were measured to be farther from the surface than the tolerance; where f jumps
/// or is not defined, that is not known.
bool misses_tolerance(const MeshReport& report);

/// The limits that ended the work on a surface before it was done, one line for each; `more_time`:
/// how to give it more of it.
std::vector<std::string> limit_lines(const MeshReport& report, const std::string& more_time);

}  // namespace zeroset
