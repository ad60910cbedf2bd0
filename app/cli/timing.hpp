#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/render/render.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/view/camera.hpp"

#include <functional>

namespace zeroset {

/// Times of repeated frames: tracing and shading, without writing files.
struct FrameTiming {
    double median_ms = 0.0, min_ms = 0.0, max_ms = 0.0;
    int repeats = 0;
    Counters counters;  ///< counters of one frame
};

/// How often a frame is drawn.
struct Repeats {
    int count = 1;
    bool warm_up = false;  ///< draws one frame first that is not counted
};

/// Runs `work` `repeats` times and times each run.
FrameTiming time_repeats(int repeats, const std::function<void()>& work);

/// Draws into `frame` repeatedly, each time with a watch of its own. A frame whose time runs out is
/// the last one, and counts.
FrameTiming time_frames(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                        Framebuffer& frame, const Repeats& repeats,
                        const std::function<RenderWatch()>& next_watch);

}  // namespace zeroset
