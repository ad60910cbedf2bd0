#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/trace/scene.hpp"

#include <atomic>

namespace zeroset {

/// Traces and shades one frame into `frame` (its size is the image's size), on `settings.threads`
/// cores. Each pixel shows the surface that is hit nearest to the eye, of equal depths the first;
/// its hit is certified only if no surface has a cell before it that could not be settled.
/// Returns early, with the frame half done, when `*cancel` becomes true (looked at before each
/// surface of a tile). `settings.tracer` must be the name of a tracer (engine/trace/tracer.hpp).
Counters render_frame(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                      Framebuffer& frame, const std::atomic<bool>* cancel = nullptr);

}  // namespace zeroset
