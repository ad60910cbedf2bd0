#pragma once

#include "engine/export/pictures/picture_writer.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/tracer.hpp"
#include "pipeline/plans/film_plan.hpp"
#include "pipeline/plans/frame_ranges.hpp"
#include "pipeline/prepare.hpp"

#include <atomic>
#include <expected>
#include <functional>
#include <limits>
#include <string>

namespace zeroset {

/// A film, or some frames of it.
struct Film {
    PreparedDocument prepared;  ///< of the script's document
    FilmScript script;
    TraceSettings settings;
    ImageSize size{};
    int first = 0;  ///< the first frame to be drawn
    int last = 0;   ///< the last one
    FrameRangeChoice frame_range = {};
    bool legend = true;        ///< draw a legend, if the colours stand for something
    bool transparent = false;  ///< see FrameSubject
    bool keeps_light = false;  ///< frames have Framebuffer::light
    bool keeps_normals = false;
    /// Seconds after which what is not decided of a frame stays undecided.
    double frame_budget_s = std::numeric_limits<double>::infinity();
};

/// A frame of a film.
struct FilmFrame {
    int number = 0;
    const Document& document;  ///< as it is at the frame
    PictureBand picture;       ///< all of it
};

struct FilmWatch {
    const std::atomic<bool>* cancel = nullptr;
    /// Whether a frame is there already and need not be drawn.
    std::function<bool(int number, const Document& document)> has_frame = {};
    /// Called after each frame that was taken or is there, from the thread that took it or the one
    /// that draws.
    std::function<void(int number)> on_frame = {};
};

using TakeFrame = std::function<std::expected<void, FileError>(const FilmFrame&)>;

/// The work that a finished film took.
struct FilmWork {
    int drawn = 0;  ///< frames
    Counters counters;
    FrameRangeWork frame_ranges;
    double drawing_ms = 0.0;
    double waiting_ms = 0.0;  ///< time in which nothing was drawn, as frames were taken too slowly
};

/// Draws the frames one after the other; the colours have one range for all. Each is taken on
/// another thread while the next one is drawn. Ends with one line that says why where it was
/// cancelled, the marks cannot be drawn or a frame was not taken.
std::expected<FilmWork, std::string> draw_film(const Film& film, const TakeFrame& take,
                                               const FilmWatch& watch);

}  // namespace zeroset
