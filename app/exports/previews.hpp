#pragma once

#include "engine/draw/drawing.hpp"
#include "engine/draw/files/drawing_style.hpp"
#include "engine/image/rgba_image.hpp"
#include "engine/level_sets/level_set_file.hpp"
#include "engine/mesh/files/mesh_file.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/mesh_document.hpp"
#include "ui/model/export_page.hpp"

#include <glm/ext/vector_int2.hpp>

namespace zeroset {

/// Says what the meshes are: triangles, size, volume, what is proved of them.
void describe(const DocumentMeshes& meshes, ui::ExportPreview& shown);

/// Says what the file of the formulas themselves holds; `size_mm`: of the clip box.
void describe(const EncodedLevelSets& level_sets, const glm::dvec3& size_mm,
              ui::ExportPreview& shown);

/// Says what the drawing holds, and gives its lines.
void describe(const LineDrawing& drawing, const DrawingStyle& style, ui::ExportPreview& shown);

/// Draws the triangles of a file, with their edges where there is room for them, from the camera's
/// direction. Transparent where there is none.
RgbaImage mesh_picture(const MeshFile& file, const Camera& camera, const glm::ivec2& size_px);

}  // namespace zeroset
