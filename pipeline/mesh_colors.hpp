#pragma once

#include "engine/mesh/files/mesh_file.hpp"
#include "engine/scene/scene.hpp"

namespace zeroset {

/// Colours an object as the scene's coloring says; `surface`: its number in the scene, `eye`: where
/// distances are measured from. A range that the coloring leaves open is taken from the vertices.
void color_object(const Scene& scene, std::size_t surface, const glm::dvec3& eye,
                  MeshObject& object);

}  // namespace zeroset
