#include "app/exports/make_preview.hpp"

#include "app/exports/previews.hpp"
#include "pipeline/plans/film_plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace zeroset {
namespace {

/// The largest size of this shape that has room.
glm::ivec2 fitted(const glm::ivec2& size, const glm::ivec2& space) {
    const double scale = std::min(
        {static_cast<double>(space.x) / size.x, static_cast<double>(space.y) / size.y, 1.0});
    return {std::max(static_cast<int>(std::lround(size.x * scale)), 1),
            std::max(static_cast<int>(std::lround(size.y * scale)), 1)};
}

RgbaImage image_of(const Framebuffer& frame, const Framebuffer& painted, bool alpha) {
    RgbaImage image{.width = frame.width, .height = frame.height, .pixels = painted.color};
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const int row = static_cast<int>(i / static_cast<std::size_t>(frame.width));
        image.pixels[i] = alpha ? drawn_color(frame, painted, i,
                                              background_color(frame.background, row, frame.height))
                                : image.pixels[i] | 0xFF000000U;
    }
    return image;
}

std::optional<RgbaImage> draw(const ExportSubject& subject, const Document& document,
                              const glm::ivec2& size_px, bool alpha, ExportNews& news) {
    const auto drawn = draw_frame(subject, document, size_px, alpha, news);
    if (!drawn) return std::nullopt;
    return image_of(*drawn->frame, *drawn->painted, alpha);
}

void preview_picture(const PreviewRequest& request, Preview& preview, ExportNews& news) {
    const ui::PictureExport& wish = request.wish.picture;
    const ExportSubject subject = framed_for(smoothed(request.subject, wish.smooth), wish.size_px);
    preview.image =
        draw(subject, subject.document, fitted(wish.size_px, request.space_px), wish.alpha, news);
}

void preview_film(const PreviewRequest& request, Preview& preview, ExportNews& news) {
    const ui::FilmExport& wish = request.wish.film;
    const ExportSubject subject = framed_for(smoothed(request.subject, wish.smooth), wish.size_px);
    const double aspect = static_cast<double>(wish.size_px.x) / wish.size_px.y;
    const FilmScript script(plan_of(wish, subject.document), subject.document, aspect);
    preview.image = draw(subject, script.document_at(request.at),
                         fitted(wish.size_px, request.space_px), wish.alpha, news);
}

void preview_meshes(const PreviewRequest& request, Preview& preview, ExportNews& news) {
    if (preview.meshes == nullptr) {
        const auto meshes = make_meshes(request.subject, request.wish.mesh, news);
        if (!meshes) {
            preview.shown.warnings.push_back(meshes.error());
            return;
        }
        preview.meshes = *meshes;
    }
    describe(*preview.meshes, preview.shown);
    preview.image = mesh_picture(preview.meshes->file, request.camera, request.space_px);
}

/// Shows the picture itself, as nothing else is made of the formula.
void preview_level_sets(const PreviewRequest& request, Preview& preview, ExportNews& news) {
    const ui::MeshExport& wish = request.wish.mesh;
    const auto made = make_level_sets(request.subject, wish);
    if (!made) {
        preview.shown.warnings.push_back(made.error());
        return;
    }
    const ExportSubject subject = smoothed(request.subject, true);
    Document document = subject.document;
    const Box& clip = document.clip;
    describe(*made, wish.size_mm / clip.size() * (clip.hi - clip.lo), preview.shown);
    const glm::ivec2& space = request.space_px;
    document.camera = framed(request.camera, clip, static_cast<double>(space.x) / space.y);
    preview.image = draw(subject, document, space, false, news);
}

void preview_drawing(const PreviewRequest& request, Preview& preview, ExportNews& news) {
    const auto drawing = make_drawing(request.subject, request.wish.drawing, news);
    if (!drawing) {
        preview.shown.warnings.push_back(drawing.error());
        return;
    }
    preview.drawing = *drawing;
    describe(**drawing, style_of(request.wish.drawing), preview.shown);
}

}  // namespace

Preview make_preview(const PreviewRequest& request, const std::optional<Preview>& last,
                     ExportNews& news) {
    Preview preview{.request = request, .shown = {}, .image = {}, .meshes = {}, .drawing = {}};
    if (last && last->request.same_file(request)) preview.meshes = last->meshes;
    switch (request.wish.kind) {
        case ExportKind::Picture: preview_picture(request, preview, news); break;
        case ExportKind::Film: preview_film(request, preview, news); break;
        case ExportKind::Mesh:
            if (request.wish.mesh.shape == ui::MeshExport::Shape::Formula) {
                preview_level_sets(request, preview, news);
            } else {
                preview_meshes(request, preview, news);
            }
            break;
        case ExportKind::Drawing: preview_drawing(request, preview, news); break;
    }
    return preview;
}

}  // namespace zeroset
