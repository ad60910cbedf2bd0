#include "engine/render/tracers.hpp"

#include "engine/trace/beam/beam_tracer.hpp"
#include "engine/trace/k_bisection/k_bisection.hpp"
#include "engine/trace/ways/surface_ways.hpp"

#include <algorithm>
#include <vector>

namespace zeroset {

namespace {

/// The way of the surface's kind, and beams where it has none.
void trace_tile_usual(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                      Counters& counters) {
    if (way_of(frame.kernel).trace_tile(frame, tile, hits, counters)) return;
    trace_tile_beams(frame, tile, hits, counters);
}

std::vector<Tracer>& table() {
    static std::vector<Tracer> all{
        Tracer{
            .name = "beams",
            .about = "beam forms over tiles of pixels, certified roots (Florez 2008, Knoll 2009)",
            .trace_tile = trace_tile_usual,
            .specializes = true,
            .takes_open_space = true,
            .takes_unions = true,
            .takes_ways = true,
            .finds_jumps = true},
        Tracer{.name = "k-bisection",
               .about = "bisection along the dominant axis of a packet of rays (Knoll 2007)",
               .trace_tile = trace_tile_k_bisection},
    };
    return all;
}

}  // namespace

std::span<const Tracer> tracers() { return table(); }

const Tracer* find_tracer(std::string_view name) {
    const auto found = std::ranges::find(tracers(), name, &Tracer::name);
    return found == tracers().end() ? nullptr : &*found;
}

const Tracer& usual_tracer() { return table().front(); }

void add_tracers(std::span<const Tracer> more) {
    table().insert(table().end(), more.begin(), more.end());
}

}  // namespace zeroset
