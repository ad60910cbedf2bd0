#include "app/exports/exports.hpp"
#include "engine/base/translation.hpp"
#include "engine/export/png.hpp"
#include "engine/render/color_range.hpp"
#include "engine/render/render.hpp"
#include "pipeline/finish_picture.hpp"
#include "pipeline/periodic_axes.hpp"
#include "pipeline/shown_points.hpp"

#include <utility>

namespace zeroset {

std::optional<DrawnFrame> draw_frame(const ExportSubject& subject, const Document& document,
                                     const glm::ivec2& size_px, bool transparent,
                                     ExportNews& news) {
    PictureRequest request =
        picture_request(subject.formula, subject.colors, document, subject.settings, size_px);
    add_needed_code(request);
    const TimeLimit limit{.cancel = &news.cancel};
    Scene scene = scene_of(request);
    if (has_range(scene.coloring.by) && !scene.coloring.range) {
        scene.coloring.range =
            find_range(scene, request.camera, request.settings, size_px.x, size_px.y, limit);
    }
    auto frame = std::make_shared<Framebuffer>(size_px.x, size_px.y);
    render_frame(scene, request.camera, request.settings, *frame, {.limit = limit});
    if (news.cancel) return std::nullopt;
    const std::vector<ShownPoint> points =
        shown_points(request.formula.get(), document, request.camera, size_px.y);
    const auto painted = finish_picture(frame, {.document = document,
                                                .camera = request.camera,
                                                .coloring = scene.coloring,
                                                .uniforms = scene.uniforms,
                                                .section_values = scene.section_values,
                                                .points = points,
                                                .of_pi = periodic_axes(*request.formula->program),
                                                .transparent = transparent});
    return DrawnFrame{.frame = frame, .painted = painted ? *painted : frame};
}

ExportWork copy_work(ExportSubject subject, const glm::ivec2& size_px,
                     std::shared_ptr<std::vector<std::byte>> png) {
    return [subject = smoothed(std::move(subject), true), size_px,
            png = std::move(png)](ExportNews& news) -> ExportOutcome {
        news.enter(tr("drawing"));
        const auto drawn = draw_frame(subject, subject.document, size_px, false, news);
        if (!drawn) return std::unexpected(tr("it was cancelled"));
        *png = png_of(*drawn->painted);
        return filled(tr("copied the picture ({0})"),
                      {std::to_string(size_px.x) + "x" + std::to_string(size_px.y)});
    };
}

}  // namespace zeroset
