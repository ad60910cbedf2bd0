#include "app/exports/exports.hpp"
#include "document/json/document_json.hpp"
#include "engine/base/translation.hpp"
#include "engine/export/pictures/picture_formats.hpp"
#include "engine/render/color_range.hpp"
#include "pipeline/periodic_axes.hpp"
#include "pipeline/plans/export_formats.hpp"
#include "pipeline/plans/poster.hpp"
#include "pipeline/shown_points.hpp"

#include <utility>

namespace zeroset {
namespace {

/// The scene of a request, with the range of its colours.
Scene finished_scene(const PictureRequest& request, const TimeLimit& limit) {
    Scene scene = scene_of(request);
    if (has_range(scene.coloring.by) && !scene.coloring.range) {
        scene.coloring.range = find_range(scene, request.camera, request.settings,
                                          request.size_px.x, request.size_px.y, limit);
    }
    return scene;
}

PictureOptions options_of(const ui::PictureExport& wish, const PictureFormat& format) {
    return {.size = {.width = wish.size_px.x, .height = wish.size_px.y},
            .bits = format.bits[1] == wish.bits ? wish.bits : format.bits[0],
            .alpha = wish.alpha && format.alpha,
            .dots_per_inch = format.density ? wish.dots_per_inch : 0.0,
            .quality = wish.quality};
}

ExportOutcome save(const ExportSubject& subject, const ui::PictureExport& wish,
                   const std::filesystem::path& path, ExportNews& news) {
    const PictureFormat* const format = picture_format_of(path);
    if (format == nullptr)
        return std::unexpected(
            filled(tr("the picture was not saved: {0}"), {other_name(ExportKind::Picture, path)}));
    PictureOptions options = options_of(wish, *format);
    if (const auto refused = refusal(*format, options)) return std::unexpected(*refused);
    if (auto writable = check_writable(path); !writable)
        return std::unexpected(writable.error().message);
    PictureRequest request = picture_request(subject.formula, subject.colors, subject.document,
                                             subject.settings, wish.size_px);
    news.enter(tr("making code"));
    add_needed_code(request);
    options.document = text_of(subject.document);
    options.camera = request.camera;
    auto writer = begin_picture(*format, path, options);
    if (!writer) return std::unexpected(writer.error().message);
    const Poster poster{.scene = finished_scene(request, {.cancel = &news.cancel}),
                        .camera = request.camera,
                        .settings = request.settings,
                        .size = options.size,
                        .document = subject.document,
                        .points = shown_points(request.formula.get(), subject.document,
                                               request.camera, wish.size_px.y),
                        .of_pi = periodic_axes(*request.formula->program),
                        .transparent = options.alpha,
                        .keeps_light = needs_light(options),
                        .keeps_normals = needs_normals(options)};
    const auto pixels =
        static_cast<std::uint64_t>(wish.size_px.x) * static_cast<std::uint64_t>(wish.size_px.y);
    news.enter(tr("drawing"), pixels);
    const auto take = [&](const PictureBand& band) {
        news.show(band.painted, band.row, options.size.height);
        return (*writer)->add(band);
    };
    const auto drawn = draw_poster(
        poster, take,
        {.cancel = &news.cancel, .on_pixels = [&](std::uint64_t count) { news.add(count); }});
    if (!drawn) return std::unexpected(drawn.error());
    news.enter(tr("writing"));
    if (const auto kept = (*writer)->finish(); !kept) return std::unexpected(kept.error().message);
    return filled(tr("saved {0} ({1})"),
                  {path.filename().string(),
                   std::to_string(options.size.width) + "x" + std::to_string(options.size.height)});
}

}  // namespace

ExportWork picture_work(ExportSubject subject, const ui::PictureExport& wish,
                        std::filesystem::path path) {
    return [subject = framed_for(smoothed(std::move(subject), wish.smooth), wish.size_px), wish,
            path = std::move(path)](ExportNews& news) { return save(subject, wish, path, news); };
}

}  // namespace zeroset
