#include "app/exports/exports.hpp"
#include "engine/base/clock.hpp"
#include "engine/base/translation.hpp"
#include "engine/draw/files/formats.hpp"
#include "engine/export/file.hpp"
#include "pipeline/drawing_scene.hpp"
#include "pipeline/plans/export_formats.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace zeroset {
namespace {

/// Seconds after which no more lines are looked for.
constexpr double drawing_budget_s = 30.0;
constexpr double least_width_pt = 0.01;
constexpr double points_per_mm = 72.0 / 25.4;

ExportOutcome write(const LineDrawing& drawing, const ui::DrawingExport& wish,
                    const std::filesystem::path& path) {
    const DrawingFormat* const format = find_drawing_format(path.string());
    if (format == nullptr)
        return std::unexpected(
            filled(tr("the drawing was not saved: {0}"), {other_name(ExportKind::Drawing, path)}));
    if (auto writable = check_writable(path); !writable)
        return std::unexpected(writable.error().message);
    const auto text = format->encode(drawing, style_of(wish));
    if (!text) return std::unexpected(filled(tr("the drawing was not saved: {0}"), {text.error()}));
    if (const auto written = write_file(path, std::as_bytes(std::span(*text))); !written)
        return std::unexpected(written.error().message);
    return filled(tr("saved {0} ({1} curves)"),
                  {path.filename().string(), std::to_string(drawing.paths.size())});
}

}  // namespace

DrawingStyle style_of(const ui::DrawingExport& wish) {
    using Hidden = ui::DrawingExport::Hidden;
    const HiddenLines hidden = wish.hidden == Hidden::Remove ? HiddenLines::Remove
                               : wish.hidden == Hidden::Dash ? HiddenLines::Dash
                                                             : HiddenLines::Show;
    DrawingStyle style{
        .hidden = hidden, .width_pt = wish.width_pt, .tolerance_pt = wish.tolerance_pt};
    for (std::size_t i = 0; i < wish.widths_pt.size(); ++i) {
        if (wish.widths_pt.at(i) > 0.0)
            style.widths_pt.at(i) = std::max(wish.widths_pt.at(i), least_width_pt);
    }
    return style;
}

std::expected<std::shared_ptr<const LineDrawing>, std::string> make_drawing(
    const ExportSubject& subject, const ui::DrawingExport& wish, ExportNews& news) {
    news.enter(tr("finding lines"));
    const DrawingChoice choice{
        .page = {.width = wish.size_mm.x * points_per_mm, .height = wish.size_mm.y * points_per_mm},
        .kinds = wish.kinds,
        .hidden = wish.hidden != ui::DrawingExport::Hidden::Remove,
        .tolerance_pt = wish.tolerance_pt};
    const TimeLimit limit{.cancel = &news.cancel,
                          .until = until_after(TimeLimit::Clock::now(), drawing_budget_s)};
    const auto scene =
        drawing_scene(framed_for(subject, wish.size_mm).document, subject.rows(), choice, limit);
    if (!scene) return std::unexpected(scene.error().reason);
    LineDrawing drawing = line_drawing(*scene, limit);
    if (news.cancel) return std::unexpected(tr("it was cancelled"));
    return std::make_shared<const LineDrawing>(std::move(drawing));
}

ExportWork drawing_work(ExportSubject subject, const ui::DrawingExport& wish,
                        std::filesystem::path path, std::shared_ptr<const LineDrawing> made) {
    return [subject = std::move(subject), wish, path = std::move(path),
            made = std::move(made)](ExportNews& news) -> ExportOutcome {
        if (made != nullptr) return write(*made, wish, path);
        const auto drawing = make_drawing(subject, wish, news);
        if (!drawing) return std::unexpected(drawing.error());
        return write(**drawing, wish, path);
    };
}

}  // namespace zeroset
