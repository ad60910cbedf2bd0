#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/render/render.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/view/camera.hpp"

#include <functional>

namespace zeroset {

/// Times of a frame drawn again and again, tracing and shading, without writing files.
struct FrameTiming {
    double median_ms = 0.0, min_ms = 0.0, max_ms = 0.0;
    int repeats = 0;
    Counters counters;  ///< of one frame
};

/// How often a frame is drawn.
struct Repeats {
    int count = 1;
    bool warm_up = false;  ///< after one that is not counted
};

/// Does `work` again and again.
FrameTiming time_repeats(int repeats, const std::function<void()>& work);

/// Draws into `frame` again and again, each time with another watch; one whose time runs out is the
/// last, and counts.
FrameTiming time_frames(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                        Framebuffer& frame, const Repeats& repeats,
                        const std::function<RenderWatch()>& next_watch);

}  // namespace zeroset
