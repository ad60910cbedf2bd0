#include "engine/trace/tracer.hpp"

#include "engine/expr/kernel.hpp"
#include "engine/trace/k_bisection.hpp"

#include <algorithm>

namespace zeroset {

Precision frame_precision(const Scene& scene, const ViewFrame& view, const StopCriterion& stop) {
    const bool has_double = std::ranges::all_of(scene.surfaces, &Kernel::has_double);
    return has_double ? wanted_precision(scene.clip, view, stop) : Precision::Float;
}

TraceFrame trace_frame(const Scene& scene, const Kernel& kernel, const ViewFrame& view, int width,
                       int height, const StopCriterion& stop) {
    return {scene,
            kernel,
            view,
            width,
            height,
            stop,
            search_depth(scene.clip, view, stop),
            frame_precision(scene, view, stop)};
}

TileHits::TileHits() {
    constexpr std::size_t capacity = static_cast<std::size_t>(tile_size) * tile_size;
    static_assert(capacity % batch_multiple == 0);
    for (std::vector<double>& axis : position)
        axis.resize(capacity);
    depth.resize(capacity);
    pixel.resize(capacity);
    certificate.resize(capacity);
}

void TileHits::clear() {
    size = 0;
    unsettled.clear();
}

void TileHits::push(Pixel at, const std::array<double, 3>& where, float distance,
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
    };
    return table;
}

const Tracer* find_tracer(std::string_view name) {
    const auto all = tracers();
    const auto found = std::ranges::find(all, name, &Tracer::name);
    return found == all.end() ? nullptr : &*found;
}

}  // namespace zeroset
