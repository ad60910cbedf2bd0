#pragma once

#include "engine/kernel/kernel.hpp"

#include <algorithm>

namespace zeroset {

/// A smooth cell of 8x8 or 4x4 pixels.
template <class Real>
struct Leaf {
    int col, row;  ///< first pixel in the tile
    bool inside;   ///< all rays are inside the clip box in the slab
    // f is c + ku x - kv y + kt t + [-e, e] at x pixels right and y below the first pixel, at the
    // depth s + s_radius t.
    Real c, ku, kv, kt, e;
    Real s, s_radius;
    Real from, to;            ///< the slab
    Real slope_lo, slope_hi;  ///< of df/ds, of one sign
    Real r;                   ///< see FormBatchOf
    const Kernel* kernel;     ///< of f in the cell
    bool kinked;              ///< f may have a kink in it
    bool turns;               ///< normal . view may change much within a pixel
};

/// Smooth cells of one small tile that touch and slope the same way: together they hold at most
/// one root a ray.
template <class Real>
struct LeafRun {
    int col, row;
    bool inside;
    Real from, to;            ///< where the first slab begins, and the last one ends
    Real lo, hi;              ///< where the slopes hold
    Real slope_lo, slope_hi;  ///< of df/ds, of one sign
    Real r;
    const Kernel* kernel;  ///< of f in all of them
    bool kinked;           ///< f may have a kink in one
    bool turns;            ///< normal . view may change much within a pixel in one

    explicit LeafRun(const Leaf<Real>& leaf)
        : col(leaf.col),
          row(leaf.row),
          inside(leaf.inside),
          from(leaf.from),
          to(leaf.to),
          lo(leaf.s - leaf.s_radius),
          hi(end_of(leaf)),
          slope_lo(leaf.slope_lo),
          slope_hi(leaf.slope_hi),
          r(leaf.r),
          kernel(leaf.kernel),
          kinked(leaf.kinked),
          turns(leaf.turns) {}

    /// Where the cell ends; rounded downward, so that it is in the cell.
    static Real end_of(const Leaf<Real>& leaf) { return -(-leaf.s - leaf.s_radius); }
    [[nodiscard]] bool falls() const { return slope_hi < 0; }
    [[nodiscard]] bool continues_with(const Leaf<Real>& next) const {
        return next.col == col && next.row == row && next.from == to && next.inside == inside &&
               next.kernel == kernel && (next.slope_hi < 0) == falls();
    }
    void add(const Leaf<Real>& next) {
        to = next.to;
        hi = end_of(next);
        slope_lo = std::min(slope_lo, next.slope_lo);
        slope_hi = std::max(slope_hi, next.slope_hi);
        r = std::max(r, next.r);
        kinked = kinked || next.kinked;
        turns = turns || next.turns;
    }
};

}  // namespace zeroset
