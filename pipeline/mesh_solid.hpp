#pragma once

#include "engine/mesh/files/mesh_file.hpp"
#include "engine/mesh/solid.hpp"
#include "engine/scene/scene.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/picture_request.hpp"

#include <expected>
#include <string>
#include <vector>

namespace zeroset {

/// A surface of a document, ready to be meshed.
struct SurfaceSolid {
    std::size_t number = 1;  ///< among the program's surfaces, from 1 on
    std::string text;        ///< how it was read
    MeshSolid solid;
};

/// A function with enclosures of it and its derivatives, over boxes in and about `clip`.
SolidPart solid_part(const Expr& f, const Box& clip);

/// Makes the solid of each surface that the request shows: the side that sections fill, in the
/// region. Bounds of a surface end its solid as sections do. Thread-safe.
std::expected<std::vector<SurfaceSolid>, InputError> surface_solids(const PictureRequest& request);

/// Colours an object as the scene's coloring says; `surface`: its number in the scene, `eye`: where
/// distances are measured from. A range that the coloring leaves open is taken from the vertices.
void color_object(const Scene& scene, std::size_t surface, const glm::dvec3& eye,
                  MeshObject& object);

}  // namespace zeroset
