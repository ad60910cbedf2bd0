#include "app/exports/exports.hpp"
#include "engine/base/translation.hpp"
#include "pipeline/plans/export_formats.hpp"
#include "pipeline/plans/film_files.hpp"

#include <utility>

namespace zeroset {
namespace {

/// Where the frames go; or why they cannot.
std::expected<FilmTarget, std::string> target_of(const ui::FilmExport& wish, const FilmPlan& plan,
                                                 const std::filesystem::path& path) {
    FilmTarget target{.path = path,
                      .film = film_format_of(path),
                      .settings = {},
                      .names = FrameNames::from(path),
                      .picture_options = {}};
    const ImageSize size{.width = wish.size_px.x, .height = wish.size_px.y};
    if (target.names) {
        target.picture = picture_format_of(path);
        if (target.picture == nullptr)
            return std::unexpected(
                filled(tr("the film was not saved: {0}"), {other_name(ExportKind::Picture, path)}));
        target.picture_options = {.size = size,
                                  .bits = target.picture->bits[0],
                                  .alpha = wish.alpha && target.picture->alpha};
        if (const auto refused = refusal(*target.picture, target.picture_options))
            return std::unexpected(*refused);
        return target;
    }
    if (target.film == nullptr)
        return std::unexpected(
            filled(tr("the film was not saved: {0}"), {other_name(ExportKind::Film, path)}));
    target.settings = {.width = size.width,
                       .height = size.height,
                       .rate = plan.rate,
                       .alpha = wish.alpha && target.film->alpha,
                       .quality = wish.quality};
    if (const auto refused = refusal(*target.film, target.settings))
        return std::unexpected(*refused);
    return target;
}

ExportOutcome save(const ExportSubject& subject, const ui::FilmExport& wish,
                   const std::filesystem::path& path, ExportNews& news) {
    const FilmPlan plan = plan_of(wish, subject.document);
    const auto target = target_of(wish, plan, path);
    if (!target) return std::unexpected(target.error());
    FrameFiles files(*target);
    if (const auto begun = files.begin(); !begun) return std::unexpected(begun.error().message);
    news.enter(tr("making code"));
    auto prepared = prepare(subject.document, subject.rows(), Preparation::Compiled);
    if (!prepared) return std::unexpected(prepared.error().reason);
    const double aspect = static_cast<double>(wish.size_px.x) / wish.size_px.y;
    const Film film{.prepared = std::move(*prepared),
                    .script = FilmScript(plan, subject.document, aspect),
                    .settings = subject.settings,
                    .size = {.width = wish.size_px.x, .height = wish.size_px.y},
                    .first = 0,
                    .last = plan.frames - 1,
                    .transparent = target->transparent(),
                    .keeps_light = target->names && needs_light(target->picture_options),
                    .keeps_normals = target->names && needs_normals(target->picture_options)};
    news.enter(tr("drawing"), static_cast<std::uint64_t>(plan.frames), marked("frame"));
    const auto take = [&](const FilmFrame& frame) {
        news.show(frame.picture.painted, 0, frame.picture.painted.height);
        return files.take(frame);
    };
    const auto drawn =
        draw_film(film, take, {.cancel = &news.cancel, .on_frame = [&](int) { news.add(1); }});
    if (!drawn) return std::unexpected(drawn.error());
    news.enter(tr("writing"));
    if (const auto kept = files.finish(); !kept) return std::unexpected(kept.error().message);
    return filled(tr("saved {0} ({1} frames)"),
                  {path.filename().string(), std::to_string(plan.frames)});
}

}  // namespace

FilmPlan plan_of(const ui::FilmExport& wish, const Document& document) {
    FilmPlan plan = wish.plan;
    plan.frames = wish.frames();
    if (wish.turns) {
        CameraTurn turn{.axis = document.up, .degrees = wish.degrees};
        if (wish.axis > 0) {
            turn.axis = glm::dvec3(0.0);
            turn.axis[wish.axis - 1] = 1.0;
        }
        plan.turn = turn;
    }
    if (wish.through_views) {
        plan.path.clear();
        for (const SavedView& view : document.views)
            plan.path.push_back(view.camera);
    }
    if (plan.path.size() < 2) plan.path.clear();
    return plan;
}

ExportWork film_work(ExportSubject subject, const ui::FilmExport& wish,
                     std::filesystem::path path) {
    return [subject = framed_for(smoothed(std::move(subject), wish.smooth), wish.size_px), wish,
            path = std::move(path)](ExportNews& news) { return save(subject, wish, path, news); };
}

}  // namespace zeroset
