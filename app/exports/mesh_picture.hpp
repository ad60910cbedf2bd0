#pragma once

#include "engine/image/rgba_image.hpp"
#include "engine/mesh/files/mesh_file.hpp"
#include "engine/view/camera.hpp"

#include <glm/ext/vector_int2.hpp>

namespace zeroset {

/// Draws the triangles of a file, with their edges where there is room for them, from the camera's
/// direction. Transparent where there is none.
RgbaImage mesh_picture(const MeshFile& file, const Camera& camera, const glm::ivec2& size_px);

}  // namespace zeroset
