#include "pipeline/plans/film.hpp"

#include "engine/base/clock.hpp"
#include "engine/image/gamma.hpp"
#include "engine/render/color_range.hpp"
#include "engine/render/render.hpp"
#include "pipeline/finish_picture.hpp"
#include "pipeline/picture_request.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace zeroset {
namespace {

/// Frames from which the range of a film's colours is found.
constexpr int range_frames = 8;

TimeLimit limit_for(const Film& film, const FilmWatch& watch) {
    TimeLimit limit{.cancel = watch.cancel};
    if (std::isfinite(film.frame_budget_s))
        limit.until = until_after(TimeLimit::Clock::now(), film.frame_budget_s);
    return limit;
}

PictureRequest request_at(const Film& film, const Document& document) {
    PictureRequest request = picture_request(film.prepared.formula, film.prepared.colors, document,
                                             film.settings, {film.size.width, film.size.height});
    add_needed_code(request);
    return request;
}

/// The range of the colours that all frames share; nothing where they need none, or have one.
std::optional<ValueRange> range_of(const Film& film, const FilmWatch& watch) {
    std::optional<ValueRange> whole;
    const int frames = film.script.plan().frames;
    for (int i = 0; i < range_frames; ++i) {
        const double frame = static_cast<double>(frames) * i / range_frames;
        const PictureRequest request = request_at(film, film.script.document_at(frame));
        const Scene scene = scene_of(request);
        if (!has_range(scene.coloring.by) || scene.coloring.range) return std::nullopt;
        const auto range = find_range(scene, request.camera, request.settings, film.size.width,
                                      film.size.height, limit_for(film, watch));
        if (!range) continue;
        if (!whole) whole = range;
        whole->lo = std::min(whole->lo, range->lo);
        whole->hi = std::max(whole->hi, range->hi);
    }
    return whole;
}

/// Adds up the light of pictures.
class LightSum {
public:
    void add(const Framebuffer& frame) {
        light_.resize(frame.light.size());
        for (std::size_t i = 0; i < light_.size(); ++i) {
            for (std::size_t channel = 0; channel < 4; ++channel)
                light_[i][channel] += std::clamp(frame.light[i][channel], 0.0F, 1.0F);
        }
        ++count_;
    }
    /// Makes `frame`, the last picture that was added, their mean.
    void put_mean(Framebuffer& frame) const {
        for (std::size_t i = 0; i < light_.size(); ++i) {
            std::array<float, 4> mean = light_[i];
            for (float& channel : mean)
                channel /= static_cast<float>(count_);
            frame.light[i] = mean;
            const auto alpha = static_cast<std::uint32_t>(mean[3] * 255.0F + 0.5F);
            std::uint32_t color = (alpha == 0 ? 255U : alpha) << 24U;
            for (unsigned channel = 0; channel < 3; ++channel)
                color |= channel_of_light(mean[channel]) << 8 * channel;
            frame.color[i] = color;
        }
        frame.blank_rows.clear();
    }

private:
    std::vector<std::array<float, 4>> light_;
    int count_ = 0;
};

/// Draws frames into one picture.
class FrameDrawer {
public:
    FrameDrawer(const Film& film, const FilmWatch& watch)
        : film_(film),
          watch_(watch),
          range_(range_of(film, watch)),
          frame_ranges_(film.script.plan(), film.frame_range, film.settings, film.size.height,
                        [this](double moment) {
                            return request_at(film_, film_.script.document_at(moment)).uniforms;
                        }),
          frame_(std::make_shared<Framebuffer>(film.size.width, film.size.height)) {
        if (film.keeps_light || blurs()) frame_->keep_planes(film.keeps_normals);
    }

    /// Draws a frame with what lies over it; `document`: as it is there.
    std::expected<std::shared_ptr<const Framebuffer>, std::string> draw(int number,
                                                                        const Document& document,
                                                                        FilmWork& work);
    [[nodiscard]] const Framebuffer& frame() const { return *frame_; }

private:
    [[nodiscard]] bool blurs() const { return film_.script.plan().blur > 1; }
    /// Draws the moments over which a frame is mixed, the last one at its middle.
    void draw_moments(int number, FilmWork& work);
    void draw_moment(int number, const Document& document, FilmWork& work);

    const Film& film_;
    const FilmWatch& watch_;
    std::optional<ValueRange> range_;
    FrameRanges frame_ranges_;
    std::shared_ptr<Framebuffer> frame_;
    Coloring coloring_;  ///< of the last picture
};

void FrameDrawer::draw_moment(int number, const Document& document, FilmWork& work) {
    const PictureRequest request = request_at(film_, document);
    Scene scene = scene_of(request);
    if (range_) scene.coloring.range = range_;
    coloring_ = scene.coloring;
    frame_ranges_.add_to(scene, number);
    work.counters += render_frame(scene, request.camera, request.settings, *frame_,
                                  {.limit = limit_for(film_, watch_)});
}

void FrameDrawer::draw_moments(int number, FilmWork& work) {
    LightSum sum;
    for (const double moment : moments_of(film_.script.plan(), number)) {
        draw_moment(number, film_.script.document_at(moment), work);
        sum.add(*frame_);
    }
    sum.put_mean(*frame_);
}

std::expected<std::shared_ptr<const Framebuffer>, std::string> FrameDrawer::draw(
    int number, const Document& document, FilmWork& work) {
    const auto start = TimeLimit::Clock::now();
    const Counters before = work.counters;
    if (blurs()) {
        draw_moments(number, work);
    } else {
        draw_moment(number, document, work);
    }
    frame_ranges_.learn(work.counters.form + work.counters.range - before.form - before.range);
    work.frame_ranges = frame_ranges_.work();
    work.drawing_ms += ms_since(start);
    const Camera camera = *document.camera;
    return finish_picture(
        frame_,
        {.document = document, .camera = camera, .coloring = coloring_, .legend = film_.legend});
}

}  // namespace

std::expected<FilmWork, std::string> draw_film(const Film& film, const TakeFrame& take,
                                               const FilmWatch& watch) {
    const auto cancelled = [&] { return watch.cancel != nullptr && *watch.cancel; };
    FilmWork work;
    FrameDrawer drawer(film, watch);
    for (int number = film.first; number <= film.last; ++number) {
        const Document document = film.script.document_at(number);
        if (!watch.has_frame || !watch.has_frame(number, document)) {
            const auto painted = drawer.draw(number, document, work);
            if (cancelled()) return std::unexpected("it was cancelled");
            if (!painted) return std::unexpected(painted.error());
            const PictureBand picture{.frame = drawer.frame(), .painted = **painted, .row = 0};
            const auto taken = take({.number = number, .document = document, .picture = picture});
            if (!taken) return std::unexpected(taken.error().message);
            ++work.drawn;
        }
        if (watch.on_frame) watch.on_frame(number);
    }
    return work;
}

}  // namespace zeroset
