#include "engine/trace/render.hpp"

#include "engine/image/blend.hpp"
#include "engine/num/rounding.hpp"
#include "engine/trace/caps.hpp"
#include "engine/trace/frame_kernels.hpp"
#include "engine/trace/frame_parts.hpp"
#include "engine/trace/nearest.hpp"
#include "engine/trace/parallel.hpp"
#include "engine/trace/shade.hpp"
#include "engine/trace/shadow.hpp"
#include "engine/trace/tile_colors.hpp"
#include "engine/trace/tile_grid.hpp"
#include "engine/trace/tracer.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace zeroset {
namespace {

/// What a thread keeps from tile to tile.
struct Workspace {
    std::vector<TileHits> hits;  ///< of each surface
    NearestSurfaces nearest;
    CapFinder caps;
    std::vector<PartInView> parts;
    Framebuffer fine{2 * tile_size, 2 * tile_size};  ///< a tile at twice the resolution
};

/// nullptr where the surface is not known as a union.
std::unique_ptr<FrameParts> parts_of(const TraceFrame& surface) {
    const Shortener* const shortener = surface.kernel.shortener.get();
    const LeastOf* const least_of = shortener == nullptr ? nullptr : shortener->least_of();
    if (least_of == nullptr || !surface.scene.region.is_whole()) return nullptr;
    return std::make_unique<FrameParts>(surface, *least_of);
}

/// A scene at one resolution, tile by tile.
class TilePainter {
public:
    TilePainter(const Scene& scene, const ViewFrame& view, const TraceSettings& settings, int width,
                int height, const std::atomic<bool>* cancel);
    /// False when cancelled; nothing is drawn then. In upward rounding.
    bool paint(Tile tile, Workspace& workspace, const Canvas& out, Counters& counters) const;

private:
    /// Fills workspace.hits with what each surface shows; false when cancelled.
    bool trace(Tile tile, Workspace& workspace, Counters& counters) const;
    /// Surface i by its parts, with what is left to find of gradients; false where that cannot be.
    bool trace_parts(std::size_t i, const Tile& tile, Workspace& workspace,
                     Counters& counters) const;
    /// Surface i.
    void trace_surface(std::size_t i, const Tile& tile, Workspace& workspace,
                       Counters& counters) const;
    [[nodiscard]] bool cancelled() const {
        return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed);
    }

    /// Surface i with the kernel for the tile.
    [[nodiscard]] TraceFrame frame_of(std::size_t i, const Tile& tile) const {
        const TraceFrame& whole = surfaces_[i];
        if (kernels_[i] == nullptr) return whole;
        return {whole.scene, kernels_[i]->of(tile), whole.view,      whole.width, whole.height,
                whole.stop,  whole.depth,           whole.precision, whole.cancel};
    }

    const Tracer& tracer_;
    bool shadows_;
    const std::atomic<bool>* cancel_;
    std::vector<TraceFrame> surfaces_;
    std::vector<std::unique_ptr<FrameKernels>> kernels_;  ///< nullptr: of all tiles the same
    std::vector<std::unique_ptr<FrameParts>> parts_;      ///< nullptr: not by parts
    std::vector<int> solid_signs_;  ///< of the surfaces; empty: nothing is capped
};

TilePainter::TilePainter(const Scene& scene, const ViewFrame& view, const TraceSettings& settings,
                         int width, int height, const std::atomic<bool>* cancel)
    : tracer_(*find_tracer(settings.tracer)), shadows_(settings.shadows), cancel_(cancel) {
    for (const Kernel& kernel : scene.surfaces) {
        surfaces_.push_back(trace_frame(scene, kernel, view, width, height, settings.stop));
        surfaces_.back().cancel = cancel;
        if (has_caps(scene)) solid_signs_.push_back(solid_sign(scene, kernel));
    }
    for (const TraceFrame& surface : surfaces_) {
        const bool pays = tracer_.shortens || surface.kernel.interpreted;
        kernels_.push_back(
            pays && surface.kernel.shortener ? std::make_unique<FrameKernels>(surface) : nullptr);
        parts_.push_back(tracer_.takes_parts ? parts_of(surface) : nullptr);
    }
}

bool TilePainter::trace_parts(std::size_t i, const Tile& tile, Workspace& workspace,
                              Counters& counters) const {
    if (parts_[i] == nullptr || !parts_[i]->list(tile, workspace.parts)) return false;
    if (workspace.parts.empty()) return true;
    TraceFrame frame = surfaces_[i];
    frame.parts = workspace.parts;
    tracer_.trace_tile(frame, tile, workspace.hits[i], counters);
    find_gradients(frame, tile, workspace.hits[i], counters);
    return true;
}

void TilePainter::trace_surface(std::size_t i, const Tile& tile, Workspace& workspace,
                                Counters& counters) const {
    TileHits& hits = workspace.hits[i];
    hits.clear();
    if (trace_parts(i, tile, workspace, counters)) return;
    const TraceFrame frame = frame_of(i, tile);
    if (solid_signs_.empty()) return tracer_.trace_tile(frame, tile, hits, counters);
    CapFinder& caps = workspace.caps;
    caps.fill(frame, solid_signs_[i], counters);
    Tile before_caps = tile;
    before_caps.limits = caps.limits(tile.limits);
    tracer_.trace_tile(frame, before_caps, hits, counters);
    caps.put(hits);
}

bool TilePainter::trace(Tile tile, Workspace& workspace, Counters& counters) const {
    const bool several = surfaces_.size() > 1;
    workspace.hits.resize(std::max(workspace.hits.size(), surfaces_.size()));
    if (several) workspace.nearest.clear();
    if (!solid_signs_.empty()) workspace.caps.enter(surfaces_.front(), tile);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        if (cancelled()) return false;
        trace_surface(i, tile, workspace, counters);
        if (cancelled()) return false;
        if (!several) return true;
        workspace.nearest.add(workspace.hits[i], static_cast<std::uint8_t>(i));
        tile.limits = workspace.nearest.limits();
    }
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
        workspace.nearest.keep_nearest(workspace.hits[i], static_cast<std::uint8_t>(i));
    return true;
}

bool TilePainter::paint(Tile tile, Workspace& workspace, const Canvas& out,
                        Counters& counters) const {
    if (!trace(tile, workspace, counters)) return false;
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        if (!workspace.hits[i].points.empty())
            find_gradients(frame_of(i, tile), tile, workspace.hits[i], counters);
    }
    if (shadows_) find_shadows(surfaces_, tile, workspace.hits, counters);
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
        find_colors(surfaces_[i], i, tile, workspace.hits[i], counters);
    if (cancelled()) return false;
    draw_tile(surfaces_, workspace.hits, tile, out);
    return true;
}

/// A frame, at twice its resolution besides where it is antialiased.
class FramePainter {
public:
    FramePainter(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                 Framebuffer& out, const RenderWatch& watch)
        : view_(camera),
          painter_(scene, view_, settings, out.width, out.height, watch.cancel),
          out_(out),
          watch_(watch) {
        if (settings.antialias) {
            fine_painter_.emplace(scene, view_, settings, 2 * out.width, 2 * out.height,
                                  watch.cancel);
        }
    }
    /// What it did. `blank_rows`: the tile's of the picture. In upward rounding.
    Counters paint(const Tile& tile, Workspace& workspace, std::uint64_t& blank_rows) const;

private:
    /// Into workspace.fine; false when cancelled.
    bool paint_fine(const Tile& tile, Workspace& workspace, Counters& counters) const;

    ViewFrame view_;
    TilePainter painter_;
    std::optional<TilePainter> fine_painter_;
    Framebuffer& out_;
    const RenderWatch& watch_;
};

bool FramePainter::paint_fine(const Tile& tile, Workspace& workspace, Counters& counters) const {
    const Canvas canvas{workspace.fine, 2 * tile.col, 2 * tile.row, 2 * out_.height};
    for (int row = 0; row < 2 * tile.rows; row += tile_size) {
        for (int col = 0; col < 2 * tile.cols; col += tile_size) {
            const Tile part{canvas.col + col, canvas.row + row,
                            std::min(tile_size, 2 * tile.cols - col),
                            std::min(tile_size, 2 * tile.rows - row)};
            if (!fine_painter_->paint(part, workspace, canvas, counters)) return false;
        }
    }
    return true;
}

Counters FramePainter::paint(const Tile& tile, Workspace& workspace,
                             std::uint64_t& blank_rows) const {
    Counters counters;
    if (fine_painter_ && !paint_fine(tile, workspace, counters)) return counters;
    const Canvas canvas{out_, 0, 0, out_.height, &blank_rows};
    if (!painter_.paint(tile, workspace, canvas, counters)) return counters;
    const PixelRect pixels{tile.col, tile.row, tile.cols, tile.rows};
    if (fine_painter_) {
        blank_rows = 0;
        blend_finer(workspace.fine, pixels, out_);
    }
    if (watch_.on_tile) watch_.on_tile(pixels);
    return counters;
}

}  // namespace

Counters render_frame(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                      Framebuffer& frame, const RenderWatch& watch) {
    assert(find_tracer(settings.tracer) != nullptr && camera_defect(camera) == nullptr);
    assert(scene.surfaces.size() <= max_surfaces);
    const NearestRounding nearest;  // the view does not depend on the caller's mode
    const FramePainter painter(scene, camera, settings, frame, watch);
    std::mutex mutex;
    Counters total;
    const TileGrid grid(frame.width, frame.height);
    frame.blank_rows.resize(grid.size());
    parallel_for(grid.size(), settings.threads, [&](std::size_t index) {
        thread_local Workspace workspace;
        const UpwardRegisters upward;
        std::uint64_t blank_rows = frame.blank_rows[index];  // others write beside it
        const Counters counters = painter.paint(grid.tile(index), workspace, blank_rows);
        frame.blank_rows[index] = blank_rows;
        const std::scoped_lock lock(mutex);
        total += counters;
    });
    return total;
}

}  // namespace zeroset
