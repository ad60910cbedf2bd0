#pragma once

#include "engine/scene/precision.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/time_limit.hpp"
#include "engine/view/camera.hpp"

#include <span>

namespace zeroset {

class OpenView;

/// Data that a tracer prepares of a surface before it is asked for tiles (TracerNeeds::prepare).
/// Read-only.
struct PreparedSurface {
    virtual ~PreparedSurface() = default;
};

/// A part of a union (engine/trace/frame_union.hpp), and where it may be: at which depths along the
/// view axis, from the plane through the point looked at, and where in the image.
struct UnionMember {
    const Kernel* kernel;
    double from, to;
    double first_col, last_col, first_row, last_row;  ///< in pixels of the image
};

/// A surface of a frame being traced: what all tiles share. Lives while the frame is drawn;
/// read-only.
struct TraceFrame {
    const Scene& scene;
    const Kernel& kernel;  ///< of the surface: that of one of scene.surfaces
    ViewFrame view;
    ImageSize image;
    StopCriterion stop;
    SearchDepth depth;    ///< what `stop` comes to in this view
    Precision precision;  ///< of the kernel's code to use; it has it
    TimeLimit limit = {};
    bool whole_pixels = false;  ///< TileHits::cover is wanted
    /// All parts of a union that may be seen in a tile, front to back: the first root is the first
    /// one of any of them, and where one is below 0 there is a root before. Empty: there is only
    /// `kernel`.
    std::span<const UnionMember> union_members = {};
    /// Where in this view the surface may be, of rays through the pixels of the image; nullptr: not
    /// known. Tracers may leave out what is elsewhere.
    const OpenView* open = nullptr;
    /// The tracer's data of the whole surface; nullptr: nothing was prepared.
    const PreparedSurface* prepared = nullptr;

    /// Whether the search is to end. Tracers look at it before each call of a kernel or so, not for
    /// each cell.
    [[nodiscard]] bool stopped() const { return limit.over(); }
    /// The frame of this surface by another kernel of it, or of a part of it; without union_members
    /// and `open`.
    [[nodiscard]] TraceFrame with(const Kernel& other, const TimeLimit& new_limit) const {
        return {.scene = scene,
                .kernel = other,
                .view = view,
                .image = image,
                .stop = stop,
                .depth = depth,
                .precision = precision,
                .limit = new_limit,
                .whole_pixels = whole_pixels,
                .prepared = prepared};
    }
};

/// The precision that the view wants, if all of the scene's kernels have code for it; else float.
Precision frame_precision(const Scene& scene, const ViewFrame& view, const StopCriterion& stop);

/// The frame of one of the scene's surfaces, in the scene's precision.
TraceFrame trace_frame(const Scene& scene, const Surface& surface, const ViewFrame& view,
                       const ImageSize& image, const StopCriterion& stop);

/// A bound of the rounding errors of a few operations in double on places in the view, and on
/// distances between them: 2^-46 of the eye's, the clip box's and the view's sizes together.
double place_error(const TraceFrame& frame);

}  // namespace zeroset
