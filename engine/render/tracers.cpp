#include "engine/render/tracers.hpp"

#include "engine/trace/beam/beam_tracer.hpp"
#include "engine/trace/k_bisection/k_bisection.hpp"

#include <algorithm>
#include <array>

namespace zeroset {

std::span<const Tracer> tracers() {
    static constexpr std::array table{
        Tracer{
            .name = "beams",
            .about = "beam forms over tiles of pixels, certified roots (Florez 2008, Knoll 2009)",
            .trace_tile = trace_tile_beams,
            .specializes = true,
            .takes_open_space = true,
            .takes_unions = true},
        Tracer{.name = "k-bisection",
               .about = "bisection along the dominant axis of a packet of rays (Knoll 2007)",
               .trace_tile = trace_tile_k_bisection},
    };
    return table;
}

const Tracer* find_tracer(std::string_view name) {
    const auto found = std::ranges::find(tracers(), name, &Tracer::name);
    return found == tracers().end() ? nullptr : &*found;
}

}  // namespace zeroset
