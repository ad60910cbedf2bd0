#include "engine/trace/tracer.hpp"

#include "engine/expr/kernel.hpp"
#include "engine/trace/beam_tracer.hpp"
#include "engine/trace/k_bisection.hpp"

#include <algorithm>

namespace zeroset {

TileHits::TileHits() {
    constexpr std::size_t capacity = static_cast<std::size_t>(tile_size) * tile_size;
    static_assert(capacity % batch_multiple == 0);
    // A vector of spare room: tracers store whole vectors of packed items.
    for (std::vector<float>& axis : position)
        axis.resize(capacity + batch_multiple);
    for (std::vector<float>& axis : gradient)
        axis.resize(capacity + batch_multiple);
    depth.resize(capacity + batch_multiple);
    pixel.resize(capacity);
    certificate.resize(capacity);
}

void TileHits::clear() {
    size = 0;
    has_gradient = false;
    unsettled.clear();
}

void TileHits::move(std::size_t from, std::size_t to) {
    for (std::size_t i = 0; i < 3; ++i) {
        position[i][to] = position[i][from];
        gradient[i][to] = gradient[i][from];
    }
    depth[to] = depth[from];
    pixel[to] = pixel[from];
    certificate[to] = certificate[from];
}

void TileHits::push(Pixel at, const std::array<float, 3>& where, float distance,
                    Certificate known) {
    for (std::size_t i = 0; i < 3; ++i)
        position[i][size] = where[i];
    depth[size] = distance;
    pixel[size] = at;
    certificate[size] = known;
    ++size;
}

std::span<const Tracer> tracers() {
    static constexpr std::array table{
        Tracer{"k-bisection", "bisection along the dominant axis of a packet of rays (Knoll 2007)",
               trace_tile_k_bisection},
        Tracer{"beams",
               "beam forms over tiles of pixels, certified roots (Florez 2008, Knoll 2009)",
               trace_tile_beams},
    };
    return table;
}

const Tracer* find_tracer(std::string_view name) {
    const auto all = tracers();
    const auto found = std::ranges::find(all, name, &Tracer::name);
    return found == all.end() ? nullptr : &*found;
}

}  // namespace zeroset
