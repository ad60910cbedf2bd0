#include "engine/render/render_job.hpp"

#include "engine/render/render.hpp"
#include "engine/trace/tile_grid.hpp"
#include "engine/trace/tracer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

/// The share of a first picture that may be left out.
constexpr double most_left_out = 0.25;

std::size_t pixels_of(const RenderRequest& request) {
    return static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height);
}

/// Copies the pixels of `rect` that are at the same places of a picture of another size.
void stretch(const Framebuffer& from, const PixelRect& rect, Framebuffer& to) {
    for (int row = rect.row; row < rect.row + rect.rows; ++row) {
        const int from_row = row * from.height / to.height;
        for (int col = rect.col; col < rect.col + rect.cols; ++col) {
            const std::size_t source = from.index(col * from.width / to.width, from_row);
            const std::size_t target = to.index(col, row);
            to.color[target] = from.color[source];
            to.depth[target] = from.depth[source];
            to.certificate[target] = from.certificate[source];
            to.surface[target] = from.surface[source];
        }
    }
}

void copy(const Framebuffer& from, const PixelRect& rect, Framebuffer& to) {
    const auto count = static_cast<std::size_t>(rect.cols);
    for (int row = rect.row; row < rect.row + rect.rows; ++row) {
        const std::size_t first = from.index(rect.col, row);
        std::copy_n(&from.color[first], count, &to.color[first]);
        std::copy_n(&from.depth[first], count, &to.depth[first]);
        std::copy_n(&from.certificate[first], count, &to.certificate[first]);
        std::copy_n(&from.surface[first], count, &to.surface[first]);
    }
}

}  // namespace

/// A full picture while it is drawn over a coarser one.
class RenderJob::Growing {
public:
    Growing(RenderJob& job, const Work& work, TraceSettings settings,
            std::shared_ptr<const Framebuffer> first, Clock::time_point until = TimeLimit::never)
        : job_(job),
          work_(work),
          settings_(std::move(settings)),
          first_(std::move(first)),
          until_(until),
          frame_(job.pool_.take(work.request.width, work.request.height)),
          grid_(work.request.width, work.request.height),
          done_(grid_.size()) {}

    /// Whether it was not cancelled.
    bool draw();
    /// Whether it came to its end before its time ran out.
    [[nodiscard]] bool complete() const { return complete_; }
    /// The share of its pixels that were left out when its time ran out.
    [[nodiscard]] double cut_share() const { return cut_share_; }
    [[nodiscard]] const std::shared_ptr<Framebuffer>& frame() const { return frame_; }
    [[nodiscard]] double elapsed_ms() const { return Milliseconds(Clock::now() - start_).count(); }
    /// Tells what the picture costs; from a good part of it, where it did not come to its end.
    void tell(ResolutionGovernor& governor, const RenderRequest& request) const;

private:
    void finish_tile(const PixelRect& rect);
    /// The tiles that are done, and the coarser picture elsewhere.
    [[nodiscard]] std::shared_ptr<const Framebuffer> snapshot() const;

    RenderJob& job_;
    const Work& work_;
    TraceSettings settings_;
    std::shared_ptr<const Framebuffer> first_;
    Clock::time_point until_;
    bool complete_ = false;
    double cut_share_ = 0.0;
    std::shared_ptr<Framebuffer> frame_;
    TileGrid grid_;
    std::vector<std::atomic<bool>> done_;  ///< a tile's pixels are written before
    std::mutex showing_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_ = start_;  ///< guarded by showing_
};

void RenderJob::Growing::tell(ResolutionGovernor& governor, const RenderRequest& request) const {
    const auto tiles = static_cast<double>(
        std::ranges::count_if(done_, [](const std::atomic<bool>& tile) { return tile.load(); }));
    const double part = tiles / static_cast<double>(done_.size());
    if (part >= 0.25) governor.measured(pixels_of(request), elapsed_ms() / part);
}

bool RenderJob::Growing::draw() {
    const RenderRequest& request = work_.request;
    const Counters counters =
        render_frame(request.scene, request.camera, settings_, *frame_,
                     {.limit = {.cancel = &job_.cancel_, .until = until_},
                      .first_turn = job_.pace_.first_turn,
                      .on_tile = [this](const PixelRect& rect) { finish_tile(rect); }});
    complete_ = !counters.is_cut();
    cut_share_ = static_cast<double>(counters.cut_pixels) / static_cast<double>(pixels_of(request));
    return !job_.cancel_;
}

void RenderJob::Growing::finish_tile(const PixelRect& rect) {
    done_[grid_.index_of(rect.col, rect.row)] = true;
    if (first_ == nullptr) return;
    const std::unique_lock lock(showing_, std::try_to_lock);
    if (!lock || Clock::now() - shown_ < job_.pace_.growth_shown_after) return;
    RenderResult result;
    result.frame = snapshot();
    result.frame_ms = elapsed_ms();
    job_.publish(work_, std::move(result));
    shown_ = Clock::now();
}

std::shared_ptr<const Framebuffer> RenderJob::Growing::snapshot() const {
    auto picture = job_.pool_.take(frame_->width, frame_->height);
    picture->blank_rows.clear();
    for (std::size_t i = 0; i < grid_.size(); ++i) {
        const Tile tile = grid_.tile(i);
        const PixelRect rect{
            .col = tile.col, .row = tile.row, .cols = tile.cols, .rows = tile.rows};
        if (done_[i]) {
            copy(*frame_, rect, *picture);
        } else {
            stretch(*first_, rect, *picture);
        }
    }
    return picture;
}

RenderJob::RenderJob(std::function<void()> on_frame, const RenderPace& pace)
    : on_frame_(std::move(on_frame)),
      pace_(pace),
      governor_(pace.budget_ms),
      thread_([this] { run(); }) {}

RenderJob::~RenderJob() {
    {
        const std::scoped_lock lock(mutex_);
        stop_ = true;
        cancel_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

std::uint64_t RenderJob::submit(RenderRequest request) {
    std::uint64_t number = 0;
    {
        const std::scoped_lock lock(mutex_);
        const auto now = Clock::now();
        if (!request.again) {
            pending_in_motion_ = newest_ > 0 && now - submitted_ < pace_.rest_after;
            submitted_ = now;
        }
        if (!starving(request, now)) cancel_ = true;
        pending_ = std::move(request);
        number = ++newest_;
    }
    wake_.notify_one();
    return number;
}

bool RenderJob::starving(const RenderRequest& next, Clock::time_point now) const {
    return drawing_ && first_ && have_same_code(next.scene.surfaces, surfaces_) &&
           now - published_ > pace_.starving_after;
}

std::optional<RenderResult> RenderJob::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(finished_, std::nullopt);
}

bool RenderJob::busy() const {
    const std::scoped_lock lock(mutex_);
    return drawing_ || pending_.has_value();
}

std::optional<RenderJob::Work> RenderJob::wait_for_work() {
    std::unique_lock lock(mutex_);
    drawing_ = false;
    wake_.wait(lock, [this] { return stop_ || pending_.has_value(); });
    if (stop_) return std::nullopt;
    Work work{.request = std::move(*std::exchange(pending_, std::nullopt)),
              .number = newest_,
              .in_motion = pending_in_motion_};
    const Coloring& coloring = work.request.scene.coloring;
    work.finds_range = has_range(coloring.by) && !coloring.range;
    if (!have_same_code(surfaces_, work.request.scene.surfaces)) {
        work.is_new = !work.request.again;
        governor_.forget(std::ranges::any_of(work.request.scene.surfaces, &Kernel::interpreted));
    }
    surfaces_ = work.request.scene.surfaces;
    drawing_ = true;
    first_ = true;
    cancel_ = false;
    return work;
}

void RenderJob::run() {
    while (auto work = wait_for_work()) {
        const RenderRequest& request = work->request;
        work->precision =
            frame_precision(request.scene, ViewFrame(request.camera), request.settings.stop);
        draw(std::move(*work));
    }
}

void RenderJob::find_colors(Work& work, bool anew) {
    if (!work.finds_range) return;
    RenderRequest& request = work.request;
    std::optional<ValueRange>& range = request.scene.coloring.range;
    range = range_.last(request.scene);
    if (range && !anew) return;
    const auto found = find_range(request.scene, request.camera, request.settings, request.width,
                                  request.height, {.cancel = &cancel_});
    if (found) range = range_.after(request.scene, *found);
}

std::shared_ptr<const Framebuffer> RenderJob::draw_firsts(Work& work) {
    const std::size_t pixels = pixels_of(work.request);
    std::shared_ptr<const Framebuffer> last;
    double scale = governor_.choose(pixels);
    auto within = pace_.first_within;
    constexpr int most_tries = 3;
    for (int tries = 1; tries <= most_tries; ++tries) {
        const First next = draw_first(work, scale, within);
        if (next.frame == nullptr || !rests(work)) return nullptr;
        work.in_motion = false;
        last = next.frame;
        const double finer = governor_.choose(pixels);
        if (next.complete && (!work.request.preview || finer <= scale || finer == 1.0)) break;
        if (next.complete) {
            scale = finer;
        } else {
            within *= 4;
        }
    }
    return last;
}

void RenderJob::draw(Work work) {
    find_colors(work, false);
    const std::size_t pixels = pixels_of(work.request);
    const auto is_quick = [&] {
        const double expected = governor_.expected_ms(pixels);
        return expected > 0 && expected < pace_.at_once_ms;
    };
    const bool at_once = !work.in_motion && is_quick();
    std::shared_ptr<const Framebuffer> first;
    if (!at_once && governor_.choose(pixels) < 1.0) {
        first = draw_firsts(work);
        if (first == nullptr || (work.request.preview && !is_quick())) return;
    }
    if (!work.in_motion) find_colors(work, true);
    draw_full(work, first);
}

RenderJob::First RenderJob::draw_first(const Work& work, double scale,
                                       std::chrono::milliseconds within) {
    Work smaller = work;
    for (Kernel& surface : smaller.request.scene.surfaces)
        surface = surface.without_waiting();
    const auto scaled = [scale](int side) {
        return std::max(1, static_cast<int>(std::lround(scale * side)));
    };
    smaller.request.width = scaled(work.request.width);
    smaller.request.height = scaled(work.request.height);
    Growing growing(*this, smaller, stages_of(work.request.settings).front(), nullptr,
                    Clock::now() + within);
    const bool drawn = growing.draw();
    growing.tell(governor_, smaller.request);
    if (!drawn) return {.frame = nullptr, .complete = false};
    // A picture with most of it left out would only hide the one that is there.
    if (work.is_new && growing.cut_share() > most_left_out)
        return {.frame = growing.frame(), .complete = false};
    RenderResult result;
    result.frame = growing.frame();
    result.frame_ms = growing.elapsed_ms();
    publish(work, std::move(result));
    return {.frame = growing.frame(), .complete = growing.complete()};
}

/// The settings of full pictures, which are drawn one after the other.
std::vector<TraceSettings> RenderJob::stages_of(const TraceSettings& settings) {
    std::vector<TraceSettings> stages;
    TraceSettings stage = settings;
    stage.shadows = false;
    stage.antialias = false;
    stages.push_back(stage);
    stage.shadows = settings.shadows;
    if (settings.shadows) stages.push_back(stage);
    stage.antialias = settings.antialias;
    if (settings.antialias) stages.push_back(stage);
    return stages;
}

void RenderJob::draw_full(const Work& work, std::shared_ptr<const Framebuffer> picture) {
    const std::vector<TraceSettings> stages = stages_of(work.request.settings);
    for (std::size_t i = 0; i < stages.size(); ++i) {
        if (i > 0 && !rests(work)) return;
        Growing growing(*this, work, stages[i], picture);
        const bool drawn = growing.draw();
        if (i == 0) growing.tell(governor_, work.request);
        if (!drawn) return;
        RenderResult result;
        result.frame = growing.frame();
        result.frame_ms = growing.elapsed_ms();
        result.counts = count_certificates(*growing.frame());
        result.complete = i + 1 == stages.size();
        picture = growing.frame();
        publish(work, std::move(result));
    }
}

bool RenderJob::rests(const Work& work) {
    std::unique_lock lock(mutex_);
    const auto until = work.in_motion ? submitted_ + pace_.rest_after : submitted_;
    return !wake_.wait_until(lock, until, [this] { return stop_ || pending_.has_value(); });
}

void RenderJob::publish(const Work& work, RenderResult result) {
    result.request = work.number;
    result.camera = work.request.camera;
    result.precision = work.precision;
    result.coloring = work.request.scene.coloring;
    {
        const std::scoped_lock lock(mutex_);
        if (cancel_) return;
        if (result.complete) drawing_ = false;
        first_ = false;
        published_ = Clock::now();
        finished_ = std::move(result);
    }
    on_frame_();
}

}  // namespace zeroset
