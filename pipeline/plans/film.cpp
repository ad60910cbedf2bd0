#include "pipeline/plans/film.hpp"

#include "engine/base/clock.hpp"
#include "engine/base/translation.hpp"
#include "engine/image/gamma.hpp"
#include "engine/render/color_range.hpp"
#include "engine/render/render.hpp"
#include "pipeline/finish_picture.hpp"
#include "pipeline/periodic_axes.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/shown_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <utility>

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

/// The range of the values that sections show in the first frame; nothing where they show none.
std::optional<ValueRange> section_range_of(const Film& film) {
    const Scene scene = scene_of(request_at(film, film.script.document_at(0.0)));
    const auto& values = scene.section_values;
    return values ? std::optional(values->range) : std::nullopt;
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

/// A frame and its picture, which are taken while the next one is drawn.
struct NumberedFrame {
    int number = 0;
    Document document;
    std::shared_ptr<Framebuffer> frame;
    std::shared_ptr<const Framebuffer> painted;

    [[nodiscard]] FilmFrame shown() const {
        return {.number = number,
                .document = document,
                .picture = {.frame = *frame, .painted = *painted, .row = 0}};
    }
};

/// Draws the frames of a film.
class FrameDrawer {
public:
    FrameDrawer(const Film& film, const FilmWatch& watch)
        : film_(film),
          watch_(watch),
          range_(range_of(film, watch)),
          section_range_(section_range_of(film)),
          frame_ranges_(
              film.script.plan(), film.frame_range, film.settings, film.size.height,
              [this](double moment) {
                  return uniform_values(request_at(film_, film_.script.document_at(moment)));
              }) {}

    /// A frame with room for its picture.
    [[nodiscard]] NumberedFrame empty_frame() const;
    /// Draws the picture, with what lies over it, of the number and the document that `drawn` has;
    /// or says why it cannot.
    std::optional<std::string> draw(NumberedFrame& drawn, FilmWork& work);

private:
    [[nodiscard]] bool blurs() const { return film_.script.plan().blur > 1; }
    /// Draws the moments over which a frame is mixed, the last one at its end.
    void draw_moments(int number, Framebuffer& frame, FilmWork& work);
    void draw_moment(int number, const Document& document, Framebuffer& frame, FilmWork& work);

    const Film& film_;
    const FilmWatch& watch_;
    std::optional<ValueRange> range_, section_range_;
    FrameRanges frame_ranges_;
    Coloring coloring_;  ///< of the last picture
    std::optional<SectionValues> section_values_;
    Uniforms uniforms_;
    std::vector<ShownPoint> points_;
    std::array<bool, 3> of_pi_ = periodic_axes(*film_.prepared.formula->program);
};

NumberedFrame FrameDrawer::empty_frame() const {
    NumberedFrame drawn;
    drawn.frame = std::make_shared<Framebuffer>(film_.size.width, film_.size.height);
    if (film_.keeps_light || blurs()) drawn.frame->keep_planes(film_.keeps_normals);
    return drawn;
}

void FrameDrawer::draw_moment(int number, const Document& document, Framebuffer& frame,
                              FilmWork& work) {
    const PictureRequest request = request_at(film_, document);
    Scene scene = scene_of(request);
    if (range_) scene.coloring.range = range_;
    if (section_range_ && scene.section_values) scene.section_values->range = *section_range_;
    coloring_ = scene.coloring;
    section_values_ = scene.section_values;
    uniforms_ = scene.uniforms;
    points_ = shown_points(request.formula.get(), document, request.camera, request.size_px.y);
    frame_ranges_.add_to(scene, number);
    work.counters += render_frame(scene, request.camera, request.settings, frame,
                                  {.limit = limit_for(film_, watch_)});
}

void FrameDrawer::draw_moments(int number, Framebuffer& frame, FilmWork& work) {
    LightSum sum;
    for (const double moment : moments_of(film_.script.plan(), number)) {
        draw_moment(number, film_.script.document_at(moment), frame, work);
        sum.add(frame);
    }
    sum.put_mean(frame);
}

std::optional<std::string> FrameDrawer::draw(NumberedFrame& drawn, FilmWork& work) {
    const auto start = TimeLimit::Clock::now();
    drawn.painted.reset();
    const Counters before = work.counters;
    if (blurs()) {
        draw_moments(drawn.number, *drawn.frame, work);
    } else {
        draw_moment(drawn.number, drawn.document, *drawn.frame, work);
    }
    frame_ranges_.learn(work.counters.form + work.counters.range - before.form - before.range);
    work.frame_ranges = frame_ranges_.work();
    auto painted = finish_picture(drawn.frame, {.document = drawn.document,
                                                .camera = *drawn.document.camera,
                                                .coloring = coloring_,
                                                .uniforms = uniforms_,
                                                .section_values = section_values_,
                                                .legend = film_.legend,
                                                .points = points_,
                                                .of_pi = of_pi_,
                                                .transparent = film_.transparent});
    if (!painted) return painted.error();
    drawn.painted = std::move(*painted);
    work.drawing_ms += ms_since(start);
    ++work.drawn;
    return std::nullopt;
}

/// Hands frames on, one after the other, on a thread of its own.
class FrameTaker {
public:
    FrameTaker(const TakeFrame& take, const FilmWatch& watch) : take_(take), watch_(watch) {}

    /// Begins to hand on a frame, which must stay as it is until the next wait().
    void begin(const NumberedFrame& drawn) {
        taking_ = std::async(std::launch::async, in_this_style([this, &drawn] {
                                 auto taken = take_(drawn.shown());
                                 if (taken && watch_.on_frame) watch_.on_frame(drawn.number);
                                 return taken;
                             }));
    }
    /// Waits for the frame that was begun last, if there is one; says why it was not taken.
    std::optional<std::string> wait(FilmWork& work) {
        if (!taking_.valid()) return std::nullopt;
        const auto start = TimeLimit::Clock::now();
        const auto taken = taking_.get();
        work.waiting_ms += ms_since(start);
        if (!taken) return taken.error().message;
        return std::nullopt;
    }

private:
    const TakeFrame& take_;
    const FilmWatch& watch_;
    std::future<std::expected<void, FileError>> taking_;
};

}  // namespace

std::expected<FilmWork, std::string> draw_film(const Film& film, const TakeFrame& take,
                                               const FilmWatch& watch) {
    const auto cancelled = [&] { return watch.cancel != nullptr && *watch.cancel; };
    FilmWork work;
    FrameDrawer drawer(film, watch);
    NumberedFrame next = drawer.empty_frame();
    NumberedFrame last = drawer.empty_frame();  // is being taken
    FrameTaker taker(take, watch);
    for (int number = film.first; number <= film.last; ++number) {
        next.number = number;
        next.document = film.script.document_at(number);
        if (watch.has_frame && watch.has_frame(number, next.document)) {
            if (watch.on_frame) watch.on_frame(number);
            continue;
        }
        const auto not_drawn = drawer.draw(next, work);
        if (cancelled()) return std::unexpected(tr("it was cancelled"));
        if (not_drawn) return std::unexpected(*not_drawn);
        if (const auto not_taken = taker.wait(work)) return std::unexpected(*not_taken);
        std::swap(next, last);
        taker.begin(last);
    }
    if (const auto not_taken = taker.wait(work)) return std::unexpected(*not_taken);
    return work;
}

}  // namespace zeroset
