#pragma once

#include "engine/draw/drawing.hpp"
#include "engine/draw/files/drawing_style.hpp"
#include "engine/level_sets/level_set_file.hpp"
#include "pipeline/mesh_document.hpp"
#include "ui/model/export_page.hpp"

namespace zeroset {

/// Says what the meshes are: triangles, size, volume, what is proved of them.
void describe(const DocumentMeshes& meshes, ui::ExportPreview& shown);

/// Says what the file of the formulas themselves holds; `size_mm`: of the clip box.
void describe(const EncodedLevelSets& level_sets, const glm::dvec3& size_mm,
              ui::ExportPreview& shown);

/// Says what the drawing holds, and gives its lines.
void describe(const LineDrawing& drawing, const DrawingStyle& style, ui::ExportPreview& shown);

}  // namespace zeroset
