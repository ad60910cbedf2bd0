#pragma once

#include "engine/trace/patch/patch_sight.hpp"
#include "engine/view/box.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// Many rays of a tile on one part of the patch that is known by its model, a vector of rays at a
// time.

namespace zeroset {

/// The polynomials of a model in the axes of a view: (a, b, s), and a number that is not used.
using SightTerms = std::array<std::array<double, 4>, patch_terms>;

/// A part of the patch as a tile's rays see it, by its model.
struct LeafSight {
    const PatchModel& model;
    double near;         ///< it is not nearer than this
    ModelSizes sizes;    ///< of the model
    UvBox box;           ///< that p and q in [-1, 1] run over
    double value_error;  ///< of each of (a, b, s), as long as no term is left out
};

/// Where rays through pixels are: that of a pixel at (u + col pixel, v - row pixel).
struct PixelGrid {
    double u, v, pixel;
};

/// Some pixels of a tile: up to, but not including, the last ones.
struct TileRect {
    int col, row, end_col, end_row;

    [[nodiscard]] bool empty() const { return col >= end_col || row >= end_row; }
};

/// A place of the patch on a ray.
struct LeafHit {
    std::size_t pixel;
    bool is_inside;  ///< surely within the ends of the ranges; else it may be
    double s, s_radius;
};

/// Why nothing was found out about a ray.
enum class LeafLeft : std::uint8_t {
    Coarse,   ///< a hit is not narrow enough: a smaller part's model is better
    Tangent,  ///< the ray is as good as tangent, or there was no room for more parts
};

/// The state of the search on a ray.
enum class RayState : std::uint32_t {
    Open,    ///< there is no hit
    Drawn,   ///< there is a hit that is not proved
    Proved,  ///< there is one that is
    Kept,    ///< what is known is kept elsewhere
};

/// The hit that a leaf found on a ray; its depth is the ray's reach.
struct LeafFound {
    std::array<float, 3> normal;  ///< dS/du x dS/dv in the world, of length 1, or NaN
    RayState state;
};

/// How hits are tested against what is shown; those behind a ray's reach never count.
enum class LeafWindow : std::uint8_t {
    All,     ///< no place of the leaf is outside of what is shown
    Box,     ///< those in a box
    Judged,  ///< LeafTaker::judge says it
};

/// The callbacks of trace_leaf about single rays.
class LeafTaker {
public:
    virtual ~LeafTaker() = default;
    /// The state that a hit gives to its ray: Open where it does not count.
    virtual RayState judge(const LeafHit& hit) = 0;
    /// Nothing was found out about this ray, on which the part is not nearer than `near`.
    virtual void leave(std::size_t pixel, double near, LeafLeft why) = 0;
};

/// The rays of a tile, in rows of so many; what is behind `reach` is not wanted, and is changed by
/// hits.
struct LeafRays {
    const double* u;  ///< of each ray, or, with a grid, of each column
    const double* v;  ///< of each ray, or row
    double* reach;
    LeafFound* found;
    double* to;  ///< where any hit will do: set to -inf, as the reach, where one is proved; else
                 ///< nullptr
    std::size_t row_size;
    double tolerance;       ///< the width of a bracket that is narrow enough
    const PixelGrid* grid;  ///< on which the rays are; nullptr: they are anywhere
};

/// The limits within which hits of a leaf count.
struct LeafClip {
    LeafWindow window;
    Box box;       ///< of LeafWindow::Box
    double first;  ///< and the depth from which on something is seen
};

/// The rays that may meet a leaf, and smaller lists of those that may meet parts of it.
struct LeafLists {
    std::vector<double> u, v;
    std::vector<float> p, q;    ///< where the linear form has the zeros
    std::vector<float> spread;  ///< from where they are within this
    std::vector<std::int32_t> pixel;

    std::array<std::vector<float>*, 3> floats() { return {&p, &q, &spread}; }
    /// Room for so many more than the first ones.
    void reserve(std::size_t first, std::size_t more);
};

class PatchOutline;

/// Pixels of a tile: those in rectangles, and others.
struct LeafPixels {
    std::span<const TileRect> rects;
    const PatchOutline* outline;  ///< of LeafRays::grid: beside it they are not asked about
    std::span<const std::size_t> others;
};

/// The work that was done on a leaf.
struct LeafCount {
    std::size_t evaluations = 0;  ///< of its polynomials, about
    std::size_t hits = 0;
};

/// Finds where rays through some pixels meet a leaf, from front to back as far as that is known. In
/// upward rounding.
LeafCount trace_leaf(const LeafSight& leaf, const SightAxes& axes, const LeafRays& rays,
                     const LeafPixels& pixels, const LeafClip& clip, LeafLists& lists,
                     LeafTaker& taker);

}  // namespace zeroset
