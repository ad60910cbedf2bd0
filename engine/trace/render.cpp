#include "engine/trace/render.hpp"

#include "engine/num/rounding.hpp"
#include "engine/trace/parallel.hpp"
#include "engine/trace/shade.hpp"
#include "engine/trace/tracer.hpp"

#include <algorithm>
#include <cassert>
#include <mutex>

namespace zeroset {
namespace {

/// What a thread keeps from tile to tile.
struct Workspace {
    TileHits hits;
    ShadeBuffers shade;
};

Tile tile_at(std::size_t index, int width, int height) {
    const int columns = (width + tile_size - 1) / tile_size;
    const int col = static_cast<int>(index) % columns * tile_size;
    const int row = static_cast<int>(index) / columns * tile_size;
    return {col, row, std::min(tile_size, width - col), std::min(tile_size, height - row)};
}

std::size_t tile_count(int width, int height) {
    const auto along = [](int pixels) {
        return static_cast<std::size_t>((pixels + tile_size - 1) / tile_size);
    };
    return along(width) * along(height);
}

}  // namespace

Counters render_frame(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                      Framebuffer& frame, const std::atomic<bool>* cancel) {
    const Tracer* const tracer = find_tracer(settings.tracer);
    assert(tracer != nullptr && camera_defect(camera) == nullptr);
    const TraceFrame shared{scene, ViewFrame(camera), frame.width, frame.height, settings.stop};
    std::mutex mutex;
    Counters total;
    parallel_for(tile_count(frame.width, frame.height), settings.threads, [&](std::size_t index) {
        if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return;
        thread_local Workspace workspace;
        const UpwardRounding upward;
        Counters counters;
        const Tile tile = tile_at(index, frame.width, frame.height);
        workspace.hits.clear();
        tracer->trace_tile(shared, tile, workspace.hits, counters);
        shade_tile(shared, tile, workspace.hits, workspace.shade, frame, counters);
        const std::scoped_lock lock(mutex);
        total += counters;
    });
    return total;
}

}  // namespace zeroset
