// The method MRFro along rays [SanjuanEstrada03; Florez08, sec. 4.3.3]: interval bisection that
// evaluates F over T only where the signs at its ends are the same.
//   T       a stretch [t1, t2] of the ray      F   the enclosure of f over T
//
// Differs from the source:
// - Signs are those of enclosures: opposite ones prove that F contains 0, rounding or not. (The
//   thesis says that rounding breaks this; it does not where a point is enclosed, too.)
// - As F is not known where the signs differ, a pole is not told from a root before the end: behind
//   a stretch with opposite signs the ray is searched on, if no root is found.

#include "papers/along_rays/mrfro.hpp"

#include "papers/along_rays/ray_search.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"

namespace zeroset {

void trace_tile_mrfro(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                      Counters& counters) {
    trace_along_rays<MrfRo>(frame, tile, hits, counters);
}

}  // namespace zeroset
