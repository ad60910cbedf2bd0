#pragma once

#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <memory>

namespace zeroset {

// Tracer::trace_tile of the root finders of the papers; each is defined in the file of its name,
// whose head comment tells the source, the symbols and what differs.

void trace_tile_t_bisection(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                            Counters& counters);
void trace_tile_mitchell(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                         Counters& counters);
void trace_tile_newton(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                       Counters& counters);
void trace_tile_alefeld_hansen(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                               Counters& counters);
void trace_tile_mrf(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters);
void trace_tile_mrfro(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                      Counters& counters);
void trace_tile_mrfro_newton(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters);
void trace_tile_affine(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                       Counters& counters);
void trace_tile_sphere_tracing(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                               Counters& counters);
void trace_tile_lg(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters);
void trace_tile_csg_by_roots(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters);
/// For csg-by-roots, makes the code of the parts. nullptr when stopped.
std::shared_ptr<const PreparedSurface> prepare_csg_parts(const TraceFrame& surface, int threads);
void trace_tile_point_sampling(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                               Counters& counters);

}  // namespace zeroset
