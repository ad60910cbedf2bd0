#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/scene/precision.hpp"
#include "engine/scene/scene.hpp"
#include "engine/trace/time_limit.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace zeroset {

inline constexpr int tile_size = 64;

/// A part of a union (engine/trace/frame_parts.hpp), and where in the image and at which depths
/// along the view axis, from the plane through the point looked at, it may be.
struct PartInView {
    const Kernel* kernel;
    double from, to;
    double first_col, last_col, first_row, last_row;  ///< in pixels of the image
};

/// A surface of a frame being traced: what all tiles share. Lives while the frame is drawn;
/// read-only.
struct TraceFrame {
    const Scene& scene;
    const Kernel& kernel;  ///< of the surface: one of scene.surfaces
    ViewFrame view;
    int width;
    int height;
    StopCriterion stop;
    SearchDepth depth;    ///< what `stop` comes to in this view
    Precision precision;  ///< of the kernel's code to use; it has it
    TimeLimit limit = {};
    /// Of a union in a tile, all parts that may be seen there, front to back: the first root is the
    /// first one of any of them, and where one is below 0 there is a root before. Empty: there is
    /// only `kernel`.
    std::span<const PartInView> parts = {};

    /// Whether the search is to end. Tracers look at it before each call of a kernel or so, not for
    /// each cell.
    [[nodiscard]] bool stopped() const { return limit.over(); }
};

/// What the view wants, if all of the scene's kernels have code for it; else float.
Precision frame_precision(const Scene& scene, const ViewFrame& view, const StopCriterion& stop);

/// The frame of one of the scene's surfaces, in the scene's precision.
TraceFrame trace_frame(const Scene& scene, const Kernel& kernel, const ViewFrame& view, int width,
                       int height, const StopCriterion& stop);

/// Above the rounding errors of a few operations in double on places in the view, and on distances
/// between them: 2^-46 of the eye's, the clip box's and the view's sizes together.
double place_error(const TraceFrame& frame);

/// A rectangle of the image, at most tile_size wide and high.
struct Tile {
    int col, row;  ///< its first pixel
    int cols, rows;
    /// For each pixel, in rows of tile_size, the distance from the eye beyond which nothing is
    /// wanted: a tracer may leave out what is farther. nullptr: all is wanted.
    const float* limits = nullptr;
};

/// How f goes along a ray at its root.
enum class Trend : std::int8_t { Falling = -1, Unknown = 0, Rising = 1 };

/// A gradient of whatever size in floats: its direction counts.
std::array<float, 3> float_gradient(const std::array<double, 3>& gradient);

/// What a tracer found of one surface in a tile. Arrays hold one item a pixel, in rows of
/// tile_size. A pixel's ray is the one that ViewFrame::direction gives for its centre, up to shifts
/// by 2^-48 of the distances of eye and box from the origin and from each other. With the
/// rule d_stop the depth of a certified hit differs from that of the first root by at most four
/// cells along the ray's dominant axis, and 2^-21 of (depth + distance of the eye from the origin)
/// for rounding; a cell is the clip box's longest edge times 2^-d_stop, but not less than 2^-20 of
/// its largest coordinate (in double, of as many ulp).
struct TileHits {
    struct Pixel {
        std::int16_t col, row;  ///< within the tile

        [[nodiscard]] std::size_t index() const {
            return static_cast<std::size_t>(row * tile_size + col);
        }
    };
    /// A hit whose gradient is not known yet.
    struct Point {
        std::size_t pixel;
        std::array<double, 3> position;  ///< on the surface, world units
        Trend trend = Trend::Unknown;
    };

    bool any = false;                      ///< whether there is a hit
    std::vector<float> depth;              ///< distance from the eye along the ray; +inf: no hit
    std::vector<Certificate> certificate;  ///< of hits
    std::array<std::vector<float>, 3> gradient;  ///< of f at hits, but for those among `points`
    std::vector<Point> points;
    /// Of `points`, along rays, where the tracer knows them.
    struct PointErrors {
        double bracket;  ///< how far a root may be from its point
        double depth;    ///< what rounding may make of a depth
    };
    std::optional<PointErrors> point_errors;
    /// Of rays that passed a cell that could be neither rejected nor drawn (a pole, a jump, the
    /// edge of a domain): the first such cell is no nearer to the eye; +inf: there is none. Whether
    /// the ray hit something afterwards or not; such a hit is not certified.
    std::vector<float> unsettled;
    bool any_unsettled = false;
    std::vector<float> lit;  ///< of the key light, what reaches a hit: 0 or 1
    bool any_dark = false;   ///< else `lit` is 1 everywhere
    /// Whether a hit is on a section that caps the surface's solid: its gradient is the section's
    /// normal.
    std::vector<std::uint8_t> cap;
    bool any_cap = false;  ///< else `cap` is 0 everywhere
    /// Where the scene is coloured by more than its surfaces: the reflectances of hits, red, green
    /// and blue; else empty.
    std::array<std::vector<float>, 3> reflectance;

    TileHits();
    void clear();
    /// No shadows.
    void light_all();
    /// A hit whose gradient is to be found.
    void push(Pixel at, const std::array<double, 3>& where, float distance, Certificate known);
    void pass(Pixel at, float distance);
    /// All rays of the tile are unsettled from the eye on.
    void leave_undecided(const Tile& tile);
    /// A cap instead of what was found behind it.
    void put_cap(Pixel at, float distance, Certificate known, const glm::dvec3& normal);
};

/// Fills in the gradients of those of `points` that are still hits: in double, of the branch of f
/// that vanishes there, against the ray where f falls along it. Where the gradient vanishes or is
/// none, it is that of a point nearby, or of differences; against the ray where the search was
/// stopped.
void find_gradients(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters);

/// A way to find the first root on each ray. A new tracer is a new row of `tracers()`
/// (engine/render/tracers.hpp): camera, kernels, shading and framebuffer are shared.
struct Tracer {
    std::string_view name;
    std::string_view about;  ///< one line
    /// One surface, one tile. Called in upward rounding, from many threads at once. `hits` is
    /// clear. When stopped it ends soon; rays that were not searched to their end are unsettled.
    void (*trace_tile)(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                       Counters& counters);
    /// Whether it is quicker with shortened kernels than with machine code of many choices.
    bool shortens = false;
    bool takes_parts = false;  ///< knows of TraceFrame::parts
};

}  // namespace zeroset
