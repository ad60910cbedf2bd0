#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/trace/camera.hpp"
#include "engine/trace/scene.hpp"

#include <functional>

namespace zeroset {

/// Times of a frame drawn again and again, tracing and shading, without writing files.
struct FrameTiming {
    double median_ms = 0.0, min_ms = 0.0, max_ms = 0.0;
    int repeats = 0;
    Counters counters;  ///< of one frame
};

/// Does `work` again and again.
FrameTiming time_repeats(int repeats, const std::function<void()>& work);

/// Draws `repeats` frames into `frame`, after one that is not counted if `warm_up`.
FrameTiming time_frames(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                        Framebuffer& frame, int repeats, bool warm_up);

}  // namespace zeroset
