#pragma once

#include "app/exports/export_run.hpp"
#include "app/exports/export_subject.hpp"
#include "engine/draw/drawing.hpp"
#include "engine/draw/files/drawing_style.hpp"
#include "pipeline/level_set_document.hpp"
#include "pipeline/mesh_document.hpp"
#include "pipeline/plans/film_plan.hpp"
#include "ui/model/export_page.hpp"

#include <cstddef>
#include <expected>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The makers of files. Each returns work for another thread, which uses nothing else of the window.

namespace zeroset {

/// A picture in memory, of a size for the screen.
struct DrawnFrame {
    std::shared_ptr<const Framebuffer> frame;    ///< as drawn
    std::shared_ptr<const Framebuffer> painted;  ///< with axes, markers and legend over it
};
/// Draws the document with the subject's code; nothing where it was cancelled. `transparent`: see
/// FrameSubject.
std::optional<DrawnFrame> draw_frame(const ExportSubject& subject, const Document& document,
                                     const glm::ivec2& size_px, bool transparent, ExportNews& news);
/// Draws the picture into the bytes of a PNG, which are there once this has succeeded.
ExportWork copy_work(ExportSubject subject, const glm::ivec2& size_px,
                     std::shared_ptr<std::vector<std::byte>> png);

/// A picture; its format is the path's.
ExportWork picture_work(ExportSubject subject, const ui::PictureExport& wish,
                        std::filesystem::path path);

/// A film, or numbered pictures where the name has a #.
ExportWork film_work(ExportSubject subject, const ui::FilmExport& wish, std::filesystem::path path);
/// The changes in the film that is wished for.
FilmPlan plan_of(const ui::FilmExport& wish, const Document& document);

/// Makes the meshes, or says in one line why there are none.
std::expected<std::shared_ptr<const DocumentMeshes>, std::string> make_meshes(
    const ExportSubject& subject, const ui::MeshExport& wish, ExportNews& news);
/// Makes the file of the formulas themselves, for Shape::Formula, or says in one line why not.
std::expected<EncodedLevelSets, std::string> make_level_sets(const ExportSubject& subject,
                                                             const ui::MeshExport& wish);
/// The meshes that some work has made; to be read once that has ended.
struct MadeMeshes {
    std::shared_ptr<const DocumentMeshes> meshes;
};
/// Writes meshes, or the formulas themselves; `made`: meshes that are there already, `kept`: takes
/// them where they are made now.
ExportWork mesh_work(ExportSubject subject, const ui::MeshExport& wish, std::filesystem::path path,
                     std::shared_ptr<const DocumentMeshes> made,
                     std::shared_ptr<MadeMeshes> kept = nullptr);

/// Makes the drawing, or says in one line why there is none.
std::expected<std::shared_ptr<const LineDrawing>, std::string> make_drawing(
    const ExportSubject& subject, const ui::DrawingExport& wish, ExportNews& news);
DrawingStyle style_of(const ui::DrawingExport& wish);
/// Writes a drawing; `made`: if it is there already.
ExportWork drawing_work(ExportSubject subject, const ui::DrawingExport& wish,
                        std::filesystem::path path, std::shared_ptr<const LineDrawing> made);

}  // namespace zeroset
