#pragma once

#include "document/document.hpp"
#include "document/shown_point.hpp"
#include "engine/export/pictures/picture_writer.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/tracer.hpp"
#include "engine/view/camera.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <expected>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace zeroset {

/// A picture of any size.
struct Poster {
    Scene scene;  ///< with the range of its colours
    Camera camera;
    TraceSettings settings;
    ImageSize size{};
    Document document;                    ///< whose axes, markers and so on are drawn over it
    std::vector<ShownPoint> points = {};  ///< whose names are, too
    bool legend = true;                   ///< draw a legend, if the colours stand for something
    std::array<bool, 3> of_pi{};          ///< see FrameSubject, as the next one
    bool transparent = false;
    bool keeps_light = false;    ///< bands have Framebuffer::light
    bool keeps_normals = false;  ///< and Framebuffer::normal
    /// Seconds after which what is not decided of a band stays undecided.
    double band_budget_s = std::numeric_limits<double>::infinity();
};

/// Who looks on while a poster is drawn.
struct PosterWatch {
    const std::atomic<bool>* cancel = nullptr;
    /// Called on the tracing threads with the number of pixels that are finished beside those told
    /// before.
    std::function<void(std::uint64_t)> on_pixels = {};
};

/// Takes the bands, from the top to the bottom.
using TakeBand = std::function<std::expected<void, FileError>(const PictureBand&)>;

/// The work that a finished poster took.
struct PosterWork {
    Counters counters;
    double drawing_ms = 0.0;  ///< without that of taking the bands
};

/// Draws the poster. Ends with one line that says why where it was cancelled, the marks cannot be
/// drawn or a band was not taken.
std::expected<PosterWork, std::string> draw_poster(const Poster& poster, const TakeBand& take,
                                                   const PosterWatch& watch);

}  // namespace zeroset
