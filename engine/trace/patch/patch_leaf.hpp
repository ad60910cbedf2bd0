#pragma once

#include "engine/trace/patch/patch_sight.hpp"

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
    SightTerms terms;
    double value_error;  ///< of each of the three
    UvBox box;           ///< that p and q in [-1, 1] run over
};

SightTerms turned_terms(const PatchModel& model, const SightAxes& axes);

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
    std::array<double, 3> normal;  ///< dS/du x dS/dv in the world, of whatever size
};

/// Why nothing was found out about a ray.
enum class LeafLeft : std::uint8_t {
    Coarse,   ///< a hit is not narrow enough: a smaller part's model is better
    Tangent,  ///< the ray is as good as tangent, or there was no room for more parts
};

/// Takes what is found. Hits come from front to back as far as that is known.
class LeafTaker {
public:
    virtual void take(const LeafHit& hit) = 0;
    /// Nothing was found out about this ray, on which the part is not nearer than `near`.
    virtual void leave(std::size_t pixel, double near, LeafLeft why) = 0;

protected:
    ~LeafTaker() = default;
};

/// The rays of a tile, in rows of so many; what is behind `reach` is not wanted. The reach may be
/// changed by the taker.
struct LeafRays {
    const double* u;
    const double* v;
    const double* reach;
    std::size_t row_size;
};

/// The rays that may meet a leaf, and smaller lists of those that may meet parts of it.
struct LeafLists {
    std::vector<double> u, v, p, q;
    std::vector<std::int64_t> pixel;

    /// Room for so many more than the first ones.
    void reserve(std::size_t first, std::size_t more);
};

/// Pixels of a tile: those in rectangles, and others.
struct LeafPixels {
    std::span<const TileRect> rects;
    std::span<const std::size_t> others;
};

/// Finds where rays through some pixels meet a leaf. In upward rounding; returns how many times
/// its polynomials were evaluated, about.
std::size_t trace_leaf(const LeafSight& leaf, const SightAxes& axes, const LeafRays& rays,
                       const LeafPixels& pixels, double tolerance, LeafLists& lists,
                       LeafTaker& taker);

}  // namespace zeroset
