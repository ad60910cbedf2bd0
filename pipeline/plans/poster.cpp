#include "pipeline/plans/poster.hpp"

#include "engine/base/clock.hpp"
#include "engine/base/translation.hpp"
#include "engine/render/render.hpp"
#include "engine/trace/tile.hpp"
#include "pipeline/finish_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace zeroset {
namespace {

// Pixels of a band, about: plain ones take some 25 bytes each until they are in a file, those that
// keep their light 110.
constexpr int plain_pixels = 2 << 20;
constexpr int light_pixels = 1 << 20;

/// Pixels along the longer side of the picture that tells what surfaces hide of the marks.
constexpr int overview_side = 2048;

TimeLimit limit_for(const Poster& poster, const PosterWatch& watch) {
    TimeLimit limit{.cancel = watch.cancel};
    if (std::isfinite(poster.band_budget_s))
        limit.until = until_after(TimeLimit::Clock::now(), poster.band_budget_s);
    return limit;
}

FrameSubject subject_of(const Poster& poster) {
    return {.document = poster.document,
            .camera = poster.camera,
            .coloring = poster.scene.coloring,
            .uniforms = poster.scene.uniforms,
            .section_values = poster.scene.section_values,
            .legend = poster.legend,
            .points = poster.points,
            .of_pi = poster.of_pi,
            .transparent = poster.transparent};
}

/// The poster in small, with nothing but what its surfaces hide.
Framebuffer overview_of(const Poster& poster, const PosterWatch& watch) {
    const double longest = std::max(poster.size.width, poster.size.height);
    const double scale = std::min(1.0, overview_side / longest);
    const auto side = [scale](int pixels) { return std::max(1, static_cast<int>(pixels * scale)); };
    Framebuffer frame(side(poster.size.width), side(poster.size.height));
    TraceSettings plain = poster.settings;
    plain.shadows = false;
    plain.antialias = Antialias::None;
    render_frame(poster.scene, poster.camera, plain, frame, {.limit = limit_for(poster, watch)});
    return frame;
}

/// The marks over the poster; nothing where there are none.
std::expected<std::optional<PictureMarks>, std::string> marks_of(const Poster& poster,
                                                                 const PosterWatch& watch) {
    const FrameSubject subject = subject_of(poster);
    if (!has_marks(subject)) return std::nullopt;
    auto marks = PictureMarks::make(overview_of(poster, watch), poster.size, subject);
    if (!marks) return std::unexpected(marks.error());
    return std::optional(std::move(*marks));
}

Counters draw_band(const Poster& poster, int row, Framebuffer& frame, const PosterWatch& watch) {
    const auto on_tile = [&watch](const PixelRect& rect) {
        if (watch.on_pixels)
            watch.on_pixels(static_cast<std::uint64_t>(rect.cols) *
                            static_cast<std::uint64_t>(rect.rows));
    };
    return render_band(poster.scene, poster.camera, poster.settings,
                       {.row = row, .height = poster.size.height}, frame,
                       {.limit = limit_for(poster, watch), .on_tile = on_tile});
}

/// Rows of a band, so that its memory stays below some hundred megabytes.
int band_rows(const ImageSize& size, bool keeps_light) {
    const int pixels = keeps_light ? light_pixels : plain_pixels;
    return std::max(pixels / size.width / tile_size, 1) * tile_size;
}

}  // namespace

std::expected<PosterWork, std::string> draw_poster(const Poster& poster, const TakeBand& take,
                                                   const PosterWatch& watch) {
    const auto marks = marks_of(poster, watch);
    if (!marks) return std::unexpected(marks.error());
    const int rows = band_rows(poster.size, poster.keeps_light);
    PosterWork work;
    Framebuffer frame;
    for (int row = 0; row < poster.size.height; row += rows) {
        const int count = std::min(rows, poster.size.height - row);
        if (frame.height != count) frame = Framebuffer(poster.size.width, count);
        if (poster.keeps_light) frame.keep_planes(poster.keeps_normals);
        const auto start = TimeLimit::Clock::now();
        work.counters += draw_band(poster, row, frame, watch);
        work.drawing_ms += ms_since(start);
        if (watch.cancel != nullptr && *watch.cancel)
            return std::unexpected(tr("it was cancelled"));
        std::optional<Framebuffer> painted;
        if (*marks) (*marks)->paint(painted.emplace(frame), row);
        const auto taken =
            take({.frame = frame, .painted = painted ? *painted : frame, .row = row});
        if (!taken) return std::unexpected(taken.error().message);
    }
    return work;
}

}  // namespace zeroset
