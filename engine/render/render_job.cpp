#include "engine/render/render_job.hpp"

#include "engine/render/growing_picture.hpp"
#include "engine/trace/tracer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// The share of a first picture that may be left out.
constexpr double most_left_out = 0.25;

/// The side of a trial for each of a first picture; of long formulas, too.
constexpr double trial_side = 0.25;
constexpr double trial_side_of_long = 0.125;
/// Above these steps of the interpreter a formula is long.
constexpr std::size_t long_steps = 90;

/// The pixels of a trial are so large that finer cells along rays do not show.
constexpr double trial_d_stop = 12.0;

bool are_interpreted(const std::vector<Surface>& surfaces) {
    return std::ranges::any_of(surfaces,
                               [](const Surface& surface) { return surface.kernel.interpreted; });
}

}  // namespace

RenderJob::RenderJob(std::function<void()> on_frame, const RenderPace& pace)
    : on_frame_(std::move(on_frame)),
      pace_(pace),
      governor_(pace.budget_ms),
      shadowed_(pace.budget_ms),
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
            submissions_.in_motion =
                submissions_.newest > 0 && now - submissions_.at < pace_.rest_after;
            submissions_.at = now;
        }
        if (!starving(request, now)) cancel_ = true;
        submissions_.pending = std::move(request);
        number = ++submissions_.newest;
    }
    wake_.notify_one();
    return number;
}

bool RenderJob::starving(const RenderRequest& next, Clock::time_point now) const {
    return drawing_.phase == Phase::Blank &&
           have_same_code(next.scene.surfaces, drawing_.surfaces) &&
           now - drawing_.published > pace_.starving_after;
}

std::optional<RenderResult> RenderJob::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(drawing_.finished, std::nullopt);
}

bool RenderJob::busy() const {
    const std::scoped_lock lock(mutex_);
    return drawing_.phase != Phase::Idle || submissions_.pending.has_value();
}

std::optional<RenderJob::Work> RenderJob::wait_for_work() {
    std::unique_lock lock(mutex_);
    drawing_.phase = Phase::Idle;
    wake_.wait(lock, [this] { return stop_ || submissions_.pending.has_value(); });
    if (stop_) return std::nullopt;
    return begin(std::move(*std::exchange(submissions_.pending, std::nullopt)));
}

RenderJob::Work RenderJob::begin(RenderRequest request) {
    Work work{.request = std::move(request),
              .number = submissions_.newest,
              .in_motion = submissions_.in_motion};
    const std::vector<Surface>& surfaces = work.request.scene.surfaces;
    const Coloring& coloring = work.request.scene.coloring;
    work.finds_range = has_range(coloring.by) && !coloring.range;
    if (!have_same_code(drawing_.surfaces, surfaces)) {
        work.is_new = !work.request.again;
        governor_.forget(are_interpreted(surfaces));
        shadowed_.forget();
    }
    drawing_.surfaces = surfaces;
    drawing_.phase = Phase::Blank;
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
    const std::size_t pixels = work.request.pixels();
    std::shared_ptr<const Framebuffer> last;
    double scale = governor_.choose(pixels);
    if (work.is_new && !governor_.is_known() && !draw_trial(work, scale)) return nullptr;
    auto within = pace_.first_within;
    constexpr int most_tries = 3;
    for (int tries = 1; tries <= most_tries; ++tries) {
        const First next = draw_first(work, scale, within, [] { return true; });
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
    const std::size_t pixels = work.request.pixels();
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

bool RenderJob::draw_trial(const Work& work, double scale) {
    const double pixels = scale * scale * static_cast<double>(work.request.pixels());
    const auto is_long = [&] {
        const double expected = governor_.expected_ms(static_cast<std::size_t>(pixels));
        return expected > pace_.trial_shown_from_ms;
    };
    const std::vector<Surface>& surfaces = work.request.scene.surfaces;
    std::size_t steps = 0;
    for (const Surface& surface : surfaces)
        steps += surface.kernel.steps;
    const double side = steps > long_steps ? trial_side_of_long : trial_side;
    Work coarse = work;
    StopCriterion& stop = coarse.request.settings.stop;
    if (stop.rule == StopRule::DStop) stop.value = std::min(stop.value, trial_d_stop);
    const First trial = draw_first(coarse, side * scale, pace_.first_within, is_long);
    // Few pixels tell little of what many cost.
    governor_.forget(are_interpreted(surfaces));
    return trial.frame != nullptr && rests(work);
}

RenderJob::First RenderJob::draw_first(const Work& work, double scale,
                                       std::chrono::milliseconds within,
                                       const std::function<bool()>& shown_if) {
    Work smaller = work;
    for (Surface& surface : smaller.request.scene.surfaces)
        surface.kernel = surface.kernel.without_waiting();
    const auto scaled = [scale](int side) {
        return std::max(1, static_cast<int>(std::lround(scale * side)));
    };
    smaller.request.width = scaled(work.request.width);
    smaller.request.height = scaled(work.request.height);
    GrowingPicture growing(smaller.request, pool_,
                           {.settings = stages_of(work.request, false).front(),
                            .limit = {.cancel = &cancel_, .until = Clock::now() + within},
                            .first_turn = pace_.first_turn});
    const bool drawn = growing.draw();
    growing.tell(governor_);
    if (!drawn) return {.frame = nullptr, .complete = false};
    // A picture with most of it left out would only hide the one that is there.
    if (work.is_new && growing.cut_share() > most_left_out)
        return {.frame = growing.frame(), .complete = false};
    if (!shown_if()) return {.frame = growing.frame(), .complete = growing.complete()};
    RenderResult result;
    result.frame = growing.frame();
    result.frame_ms = growing.elapsed_ms();
    publish(work, std::move(result));
    return {.frame = growing.frame(), .complete = growing.complete()};
}

bool RenderJob::shadows_fit(const RenderRequest& request) {
    return request.settings.shadows && shadowed_.choose(request.pixels()) == 1.0;
}

ResolutionGovernor* RenderJob::governor_of(const TraceSettings& stage) {
    if (stage.antialias != Antialias::None || stage.reflections > 0 || stage.soft_light)
        return nullptr;
    return stage.shadows ? &shadowed_ : &governor_;
}

std::vector<TraceSettings> RenderJob::stages_of(const RenderRequest& request, bool at_once) {
    const TraceSettings& settings = request.settings;
    std::vector<TraceSettings> stages;
    TraceSettings stage = settings;
    stage.shadows = false;
    stage.antialias = Antialias::None;
    stage.reflections = 0;
    stage.soft_light = false;
    if (!at_once) stages.push_back(stage);
    stage.shadows = settings.shadows;
    if (settings.shadows) stages.push_back(stage);
    stage.antialias = settings.antialias;
    if (settings.antialias != Antialias::None) stages.push_back(stage);
    stage.reflections = settings.reflections;
    if (settings.reflections > 0) stages.push_back(stage);
    stage.soft_light = settings.soft_light;
    if (settings.soft_light && has_soft_light(request.scene)) stages.push_back(stage);
    return stages;
}

void RenderJob::draw_full(const Work& work, std::shared_ptr<const Framebuffer> picture) {
    const auto show = [this, &work](std::shared_ptr<const Framebuffer> frame, double elapsed_ms) {
        RenderResult result;
        result.frame = std::move(frame);
        result.frame_ms = elapsed_ms;
        publish(work, std::move(result));
    };
    const std::vector<TraceSettings> stages = stages_of(work.request, shadows_fit(work.request));
    for (std::size_t i = 0; i < stages.size(); ++i) {
        if (i > 0 && !rests(work)) return;
        GrowingPicture growing(work.request, pool_,
                               {.settings = stages[i],
                                .limit = {.cancel = &cancel_},
                                .first_turn = pace_.first_turn,
                                .coarser = picture,
                                .shown_after = pace_.growth_shown_after,
                                .show = show});
        const bool drawn = growing.draw();
        if (ResolutionGovernor* const governor = governor_of(stages[i])) growing.tell(*governor);
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
    const auto until = work.in_motion ? submissions_.at + pace_.rest_after : submissions_.at;
    return !wake_.wait_until(lock, until,
                             [this] { return stop_ || submissions_.pending.has_value(); });
}

void RenderJob::publish(const Work& work, RenderResult result) {
    result.request = work.number;
    result.camera = work.request.camera;
    result.precision = work.precision;
    result.coloring = work.request.scene.coloring;
    result.section_values = work.request.scene.section_values;
    result.uniforms = work.request.scene.uniforms;
    {
        const std::scoped_lock lock(mutex_);
        if (cancel_) return;
        drawing_.phase = result.complete ? Phase::Idle : Phase::Refining;
        drawing_.published = Clock::now();
        drawing_.finished = std::move(result);
    }
    on_frame_();
}

}  // namespace zeroset
