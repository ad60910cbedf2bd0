#include "app/cli/timing.hpp"

#include "engine/base/clock.hpp"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Returns the milliseconds that `work` takes.
double time_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return ms_since(start);
}

FrameTiming timing_of(std::vector<double> times) {
    FrameTiming timing;
    timing.repeats = static_cast<int>(times.size());
    std::ranges::sort(times);
    const std::size_t middle = times.size() / 2;
    timing.median_ms =
        times.size() % 2 == 1 ? times[middle] : 0.5 * (times[middle - 1] + times[middle]);
    timing.min_ms = times.front();
    timing.max_ms = times.back();
    return timing;
}

}  // namespace

FrameTiming time_repeats(int repeats, const std::function<void()>& work) {
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(repeats));
    for (int i = 0; i < repeats; ++i)
        times.push_back(time_of(work));
    return timing_of(std::move(times));
}

FrameTiming time_frames(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                        Framebuffer& frame, const Repeats& repeats,
                        const std::function<RenderWatch()>& next_watch) {
    Counters counters;
    const auto draw = [&] {
        return time_of(
            [&] { counters = render_frame(scene, camera, settings, frame, next_watch()); });
    };
    std::vector<double> times;
    if (repeats.warm_up) {
        const double warm_up_ms = draw();
        if (counters.is_cut()) times.push_back(warm_up_ms);
    }
    for (int i = 0; i < repeats.count && !counters.is_cut(); ++i)
        times.push_back(draw());
    FrameTiming timing = timing_of(std::move(times));
    timing.counters = counters;
    return timing;
}

}  // namespace zeroset
