#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/time_limit.hpp"
#include "engine/view/camera.hpp"

#include <functional>

namespace zeroset {

/// Who looks on while a frame is drawn.
struct RenderWatch {
    /// When it is over, render_frame returns within milliseconds. Where it was cancelled, tiles
    /// that are not finished stay as they were. Where time has run out, what was not searched to
    /// its end is undecided (Counters::cut_pixels), and shadows or smooth edges may be missing.
    TimeLimit limit = {};
    /// If it is not 0, and there is no time limit: a tile that takes longer waits until all others
    /// had as much, so that what is quick comes first.
    TimeLimit::Clock::duration first_turn = {};
    /// Called on the tracing threads, several at once, for each tile that is finished: its pixels
    /// are not touched again.
    std::function<void(const PixelRect&)> on_tile = {};
};

/// Traces and shades one frame into `frame` (its size is the image's size), on `settings.threads`
/// cores. Each pixel shows the surface that is hit nearest to the eye, of equal depths the first;
/// its hit is certified only if no surface has a cell before it that could not be settled.
/// `settings.tracer` must be the name of a tracer (engine/trace/tracer.hpp).
Counters render_frame(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                      Framebuffer& frame, const RenderWatch& watch = {});

/// Rows of an image, with all their columns.
struct ImageBand {
    int row = 0;     ///< the first one
    int height = 0;  ///< rows of the whole image
};

/// Renders a part of an image: `frame` has the image's width and as many rows as the band is high.
/// Pixels are the same as in the whole image if the band's row is a multiple of tile_size.
Counters render_band(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                     const ImageBand& band, Framebuffer& frame, const RenderWatch& watch = {});

}  // namespace zeroset
