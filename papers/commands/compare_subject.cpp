#include "papers/commands/compare_subject.hpp"

#include "engine/base/clock.hpp"
#include "engine/measure/wrong_pixels.hpp"
#include "engine/render/tracers.hpp"
#include "engine/scene/tolerance.hpp"
#include "engine/trace/trace_frame.hpp"
#include "papers/commands/compare_scene.hpp"
#include "papers/florez/box_tally.hpp"
#include "pipeline/picture_request.hpp"

#include <chrono>
#include <cmath>
#include <utility>

namespace zeroset {
namespace {

/// The light of scenes with mirrored rays: metal under two lights [Stolte05, fig. 5].
Lighting mirror_lighting() {
    Lighting lighting;
    lighting.look = Look::Metal;
    lighting.lights = {Light(), Light{.towards = {0.8, 0.2, 0.6}, .power = 0.4}};
    return lighting;
}

TraceSettings finest() {
    TraceSettings settings;
    settings.threads = 0;
    return settings;
}

}  // namespace

OrInputError<CompareFrames> read_frames(const CompareCommand& command,
                                        const std::string& usual_size) {
    CompareFrames frames;
    const auto size = read_size("--size", command.size.value_or(usual_size));
    if (!size) return std::unexpected(size.error());
    frames.size = *size;
    const auto repeats = read_repeats(command.repeat, frames.repeats);
    if (!repeats) return std::unexpected(repeats.error());
    frames.repeats = *repeats;
    const auto budget = read_budget(command.budget);
    if (!budget) return std::unexpected(budget.error());
    frames.budget_s = *budget;
    return frames;
}

CompareSubject::CompareSubject(std::string name, PictureRequest request)
    : name_(std::move(name)),
      request_(std::move(request)),
      scene_(scene_of(request_)),
      proved_(request_.size_px.x, request_.size_px.y) {}

OrInputError<CompareSubject> CompareSubject::make(const BenchItem& item,
                                                  const CompareFrames& frames) {
    auto request = compiled(item, {}, frames.size);
    if (!request) return std::unexpected(request.error());
    CompareSubject subject(item.name, std::move(*request));
    const FrameTiming timing = subject.draw(subject.scene_, finest(), {}, 100.0, subject.proved_);
    if (timing.counters.is_cut())
        return wrong_input("--surface " + item.name +
                           ": it takes too long to prove; leave it "
                           "out, or choose a smaller --size");
    return subject;
}

std::optional<std::string> CompareSubject::refusal(const TraceSettings& settings) const {
    return tracer_refusal(settings.tracer, name_ + ", --tracer " + settings.tracer, request_);
}

ComparedRow CompareSubject::measured(int wanted_d_stop, const TraceSettings& settings,
                                     const CompareFrames& frames) const {
    ComparedRow row;
    row.surface = name_;
    row.tracer = settings.tracer;
    row.wanted_d_stop = wanted_d_stop;
    row.d_stop = static_cast<int>(settings.stop.value);
    row.reflections = settings.reflections;
    Framebuffer frame(frames.size.width, frames.size.height);
    Scene scene = scene_;
    if (settings.reflections > 0) scene.lighting = mirror_lighting();
    row.prepared_ms = prepared_ms(scene, settings, frame);
    const FrameTiming timing =
        draw(scene, settings, {.count = frames.repeats, .warm_up = true}, frames.budget_s, frame);
    row.repeats = frames.repeats;
    row.median_ms = timing.median_ms;
    row.min_ms = timing.min_ms;
    row.max_ms = timing.max_ms;
    row.counters = timing.counters;
    row.boxes = boxes(scene, settings, frames.budget_s, frame);
    const auto rays = static_cast<double>(frame.color.size());
    row.cells_per_ray = static_cast<double>(row.counters.range + row.counters.form) / rays;
    row.values_per_ray = static_cast<double>(row.counters.value) / rays;
    row.counts = count_certificates(frame);
    const double cell = std::ldexp(scene_.clip.size(), -row.d_stop);
    const auto precision = wanted_precision(scene_, ViewFrame(camera()), settings.stop);
    const auto width = certified_width(scene_.clip, settings.stop, precision);
    row.wrong = wrong_pixels(frame, proved_, camera(), width.value_or(4.0 * cell));
    row.certified_there = count_certificates(proved_).certified;
    if (frames.table != nullptr) {
        row.printed_ms =
            frames.table->printed_ms(row.surface, row.tracer, row.wanted_d_stop, row.reflections);
        row.of_table = frames.table->names(row.surface, row.tracer);
    }
    return row;
}

/// Makes what the tracer keeps of the surfaces from frame to frame; the time that it took.
double CompareSubject::prepared_ms(const Scene& scene, const TraceSettings& settings,
                                   const Framebuffer& frame) const {
    const Tracer& tracer = *find_tracer(settings.tracer);
    if (tracer.needs.prepare == nullptr) return 0.0;
    const auto start = std::chrono::steady_clock::now();
    const ViewFrame view(camera());
    for (const Surface& surface : scene.surfaces) {
        const ImageSize image{.width = frame.width, .height = frame.height};
        tracer.needs.prepare(trace_frame(scene, surface, view, image, settings.stop),
                             settings.threads);
    }
    return ms_since(start);
}

/// The counts of one frame of a tracer with boxes.
ImageBoxCounters CompareSubject::boxes(const Scene& scene, const TraceSettings& settings,
                                       double budget_s, Framebuffer& frame) const {
    ImageBoxCounters sum;
    const auto take = [&] {
        sum = {};
        for (const Surface& surface : scene.surfaces)
            sum += surface.kernel.memory->of<BoxTally>()->take();
    };
    take();
    if (sum.rejected.boxes + sum.included.boxes + sum.undefined.boxes == 0) return sum;
    draw(scene, settings, {.count = 1, .warm_up = false}, budget_s, frame);
    take();
    return sum;
}

FrameTiming CompareSubject::draw(const Scene& scene, const TraceSettings& settings,
                                 const Repeats& repeats, double budget_s,
                                 Framebuffer& frame) const {
    return time_frames(scene, camera(), settings, frame, repeats, [&] {
        const auto now = std::chrono::steady_clock::now();
        return RenderWatch{.limit = {.until = until_after(now, budget_s)}, .on_tile = {}};
    });
}

}  // namespace zeroset
