#include "app/timing.hpp"

#include "engine/trace/render.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace zeroset {

FrameTiming time_repeats(int repeats, const std::function<void()>& work) {
    FrameTiming timing;
    timing.repeats = repeats;
    std::vector<double> times;
    for (int i = 0; i < repeats; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double, std::milli> elapsed =
            std::chrono::steady_clock::now() - start;
        times.push_back(elapsed.count());
    }
    std::ranges::sort(times);
    const std::size_t middle = times.size() / 2;
    timing.median_ms =
        times.size() % 2 == 1 ? times[middle] : 0.5 * (times[middle - 1] + times[middle]);
    timing.min_ms = times.front();
    timing.max_ms = times.back();
    return timing;
}

FrameTiming time_frames(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                        Framebuffer& frame, int repeats, bool warm_up) {
    if (warm_up) render_frame(scene, camera, settings, frame);
    Counters counters;
    FrameTiming timing =
        time_repeats(repeats, [&] { counters = render_frame(scene, camera, settings, frame); });
    timing.counters = counters;
    return timing;
}

}  // namespace zeroset
