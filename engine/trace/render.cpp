#include "engine/trace/render.hpp"

#include "engine/num/rounding.hpp"
#include "engine/trace/frame_kernels.hpp"
#include "engine/trace/nearest.hpp"
#include "engine/trace/parallel.hpp"
#include "engine/trace/shade.hpp"
#include "engine/trace/tracer.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace zeroset {
namespace {

/// What a thread keeps from tile to tile.
struct Workspace {
    std::vector<TileHits> hits;  ///< of each surface
    NearestSurfaces nearest;
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

/// A frame of a scene, tile by tile.
class FramePainter {
public:
    FramePainter(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                 Framebuffer& out, const std::atomic<bool>* cancel);
    /// What it did; the tile stays as it was when cancelled. In upward rounding.
    Counters paint(Tile tile, Workspace& workspace) const;

private:
    /// Fills workspace.hits with what each surface shows; false when cancelled.
    bool trace(Tile tile, Workspace& workspace, Counters& counters) const;
    [[nodiscard]] bool cancelled() const {
        return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed);
    }

    /// Surface i with the kernel for the tile.
    [[nodiscard]] TraceFrame frame_of(std::size_t i, const Tile& tile) const {
        const TraceFrame& whole = surfaces_[i];
        if (kernels_[i] == nullptr) return whole;
        return {whole.scene, kernels_[i]->of(tile), whole.view,     whole.width, whole.height,
                whole.stop,  whole.depth,           whole.precision};
    }

    const Tracer& tracer_;
    std::vector<TraceFrame> surfaces_;
    std::vector<std::unique_ptr<FrameKernels>> kernels_;  ///< nullptr: of all tiles the same
    Framebuffer& out_;
    const std::atomic<bool>* cancel_;
};

FramePainter::FramePainter(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                           Framebuffer& out, const std::atomic<bool>* cancel)
    : tracer_(*find_tracer(settings.tracer)), out_(out), cancel_(cancel) {
    const ViewFrame view(camera);
    for (const Kernel& kernel : scene.surfaces)
        surfaces_.push_back(trace_frame(scene, kernel, view, out.width, out.height, settings.stop));
    for (const TraceFrame& surface : surfaces_) {
        const bool pays = tracer_.shortens || surface.kernel.interpreted;
        kernels_.push_back(
            pays && surface.kernel.shortener ? std::make_unique<FrameKernels>(surface) : nullptr);
    }
}

bool FramePainter::trace(Tile tile, Workspace& workspace, Counters& counters) const {
    const bool several = surfaces_.size() > 1;
    workspace.hits.resize(std::max(workspace.hits.size(), surfaces_.size()));
    if (several) workspace.nearest.clear();
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        if (cancelled()) return false;
        TileHits& hits = workspace.hits[i];
        hits.clear();
        tracer_.trace_tile(frame_of(i, tile), tile, hits, counters);
        if (!several) return true;
        workspace.nearest.add(hits, static_cast<std::uint8_t>(i));
        tile.limits = workspace.nearest.limits();
    }
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
        workspace.nearest.keep_nearest(workspace.hits[i], static_cast<std::uint8_t>(i));
    return true;
}

Counters FramePainter::paint(Tile tile, Workspace& workspace) const {
    Counters counters;
    if (!trace(tile, workspace, counters)) return counters;
    clear_tile(tile, out_);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        find_gradients(frame_of(i, tile), workspace.hits[i], counters);
        shade_tile(surfaces_[i], static_cast<std::uint8_t>(i), tile, workspace.hits[i], out_);
    }
    return counters;
}

}  // namespace

Counters render_frame(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                      Framebuffer& frame, const std::atomic<bool>* cancel) {
    assert(find_tracer(settings.tracer) != nullptr && camera_defect(camera) == nullptr);
    assert(scene.surfaces.size() <= max_surfaces);
    const NearestRounding nearest;  // the view does not depend on the caller's mode
    const FramePainter painter(scene, camera, settings, frame, cancel);
    std::mutex mutex;
    Counters total;
    parallel_for(tile_count(frame.width, frame.height), settings.threads, [&](std::size_t index) {
        thread_local Workspace workspace;
        const UpwardRounding upward;
        const Tile tile = tile_at(index, frame.width, frame.height);
        const Counters counters = painter.paint(tile, workspace);
        const std::scoped_lock lock(mutex);
        total += counters;
    });
    return total;
}

}  // namespace zeroset
