// The first root on each ray by beams [Florez08, ch. 5; Knoll09; ComSto93].
//   u, v       a pixel's place on the image plane at distance 1 from the eye
//   s          depth along the view axis, from the plane through the point looked at
//   cell       a square tile of pixels times a slab [s0, s1] of depth
//   form       f over a cell: c + ku eu + kv ev + kt et + [-e, e], with (eu, ev, et) in [-1, 1]^3
//              (engine/num/beam.hpp); comes with an enclosure of df/ds
// A tile of 64x64 pixels begins with slabs between its entry into the clip box and its exit. Cells
// are looked at breadth first and front to back, many at a time. The linear part of a cell's form
// contracts the slab for each quarter of the tile to where f can vanish; a quarter for which
// nothing is left is gone (Florez's rejection test). A quarter all of whose rays surely have a root
// in the slab hides its later slabs (his inclusion test). Slabs that contract badly and are long
// for their tile are halved.
// Where f is continuous and df/ds excludes 0, the rays of a tile of 8x8 pixels are solved together,
// those of neighbouring slabs, too: the forms give each its bracket, Newton's method the root
// (beam_leaf-inl.hpp; what that leaves open, beam_roots-inl.hpp). A tile of 4x4 pixels that is not
// monotone yet goes on ray by ray (beam_rays-inl.hpp). Tiles of 4x4 pixels are made from the front,
// a few slabs of a tile of 8x8 at a time: those behind the roots found so far are not made.
// A union may be given by its parts (TraceFrame::union_members): then each cell is one of a part,
// and begins as small as the part is.
//
// Differs from the papers:
// - A root is certified by the interval Newton operator in double: f at the guess, with a bound of
//   its rounding that comes with the form, over the enclosure of df/ds. No evaluation of the ends.
// - Nothing is rejected by the sign of a value: by enclosures, and by that operator.
// - Cells are evaluated a margin longer than their slabs, so that the bracket of a root at the end
//   of a slab is inside one cell.
// - Rays go on in double where cells in float are not decided.
// - The search goes to 2^-12 of the clip box at least, however coarse a one is asked for: where
//   cells end before f is known to be monotone, their rays are searched one by one.

#include "engine/trace/beam/beam_tracer.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/beam/beam_tracer.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/beam/beam_leaf_certify-inl.hpp"
#include "engine/trace/beam/beam_leaf_cover-inl.hpp"
#include "engine/trace/beam/beam_tile-inl.hpp"
#include "engine/trace/beam/beam_tile_rays-inl.hpp"
#include "engine/trace/beam/beam_tree_first-inl.hpp"
#include "engine/trace/beam/beam_tree_judge-inl.hpp"
#include "engine/trace/in_precision.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <memory>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The frame, to be searched as fine as it takes least time.
inline TraceFrame with_fair_depth(const TraceFrame& frame) {
    const int fair_halvings = 12 + frame.depth.deeper;
    TraceFrame fair = frame;
    fair.depth.wanted = std::max(fair.depth.wanted, fair_halvings);
    if (fair.stop.rule == StopRule::Epsilon)
        fair.stop.value =
            std::min(fair.stop.value, std::ldexp(frame.scene.clip.size(), -fair_halvings));
    return fair;
}

void trace_beam_tile(const TraceFrame& asked, const Tile& tile, TileHits& hits,
                     Counters& counters) {
    const TraceFrame frame = with_fair_depth(asked);
    const double asked_width = TileRays(asked, tile).tolerance();
    in_precision(frame, [&](auto real) {
        using Real = decltype(real);
        thread_local const auto kept = std::make_unique<BeamMemory<Real>>();
        BeamMemory<Real>& memory = *kept;
        BeamTile<Real>(frame, asked_width, tile, memory, hits, counters).trace();
    });
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {

HWY_EXPORT(trace_beam_tile);

void trace_tile_beams(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                      Counters& counters) {
    HWY_DYNAMIC_DISPATCH(trace_beam_tile)(frame, tile, hits, counters);
}

}  // namespace zeroset

#endif
