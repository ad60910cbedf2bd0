#include "engine/render/render.hpp"

#include "engine/base/parallel.hpp"
#include "engine/image/blend.hpp"
#include "engine/real/rounding.hpp"
#include "engine/render/tile_painter.hpp"
#include "engine/render/tracers.hpp"
#include "engine/trace/tile_grid.hpp"
#include "engine/trace/tile_turns.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <optional>
#include <vector>

namespace zeroset {
namespace {

std::uint64_t pixels_in(const Tile& tile) {
    return static_cast<std::uint64_t>(tile.cols) * static_cast<std::uint64_t>(tile.rows);
}

std::uint64_t undecided_in(const Framebuffer& frame, const Tile& tile) {
    std::uint64_t count = 0;
    for (int row = tile.row; row < tile.row + tile.rows; ++row) {
        const auto first =
            frame.certificate.begin() + static_cast<std::ptrdiff_t>(frame.index(tile.col, row));
        count += static_cast<std::uint64_t>(
            std::count(first, first + tile.cols, Certificate::Undecided));
    }
    return count;
}

/// A frame, at twice its resolution besides where it is antialiased.
class FramePainter {
public:
    FramePainter(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                 const ImageBand& band, Framebuffer& out, const RenderWatch& watch)
        : view_(camera),
          painter_(scene, view_, settings, {.width = out.width, .height = band.height}, 1,
                   watch.limit),
          across_(rays_across(antialias_of(scene, settings))),
          band_(band),
          out_(out),
          watch_(watch) {
        if (across_ > 1)
            fine_painter_.emplace(
                scene, view_, settings,
                ImageSize{.width = across_ * out.width, .height = across_ * band.height}, across_,
                watch.limit);
    }
    /// `tile`: of the image. `blank_rows`: the tile's of the band. In upward rounding.
    TileState paint(const Tile& tile, const TimeLimit& limit, Workspace& workspace,
                    std::uint64_t& blank_rows, Counters& counters) const;

private:
    /// A tile's fine picture, into `fine`; whether all of it came to its end.
    bool paint_fine(const Tile& tile, const TimeLimit& limit, Workspace& workspace,
                    Framebuffer& fine, Counters& counters) const;

    ViewFrame view_;
    TilePainter painter_;
    int across_;  ///< rays of a pixel, in its fine picture
    ImageBand band_;
    std::optional<TilePainter> fine_painter_;
    Framebuffer& out_;
    const RenderWatch& watch_;
};

bool FramePainter::paint_fine(const Tile& tile, const TimeLimit& limit, Workspace& workspace,
                              Framebuffer& fine, Counters& counters) const {
    const int cols = across_ * tile.cols;
    const int rows = across_ * tile.rows;
    const Canvas canvas{.pixels = fine,
                        .col = across_ * tile.col,
                        .row = across_ * tile.row,
                        .height = across_ * band_.height};
    for (int row = 0; row < rows; row += tile_size) {
        for (int col = 0; col < cols; col += tile_size) {
            const Tile part{.col = canvas.col + col,
                            .row = canvas.row + row,
                            .cols = std::min(tile_size, cols - col),
                            .rows = std::min(tile_size, rows - row)};
            const TileState state = fine_painter_->paint(part, limit, workspace, canvas, counters);
            if (state != TileState::Finished) return false;
        }
    }
    return true;
}

TileState FramePainter::paint(const Tile& tile, const TimeLimit& limit, Workspace& workspace,
                              std::uint64_t& blank_rows, Counters& counters) const {
    const Canvas canvas{.pixels = out_,
                        .col = 0,
                        .row = band_.row,
                        .height = band_.height,
                        .blank_rows = &blank_rows};
    const TileState state = painter_.paint(tile, limit, workspace, canvas, counters);
    if (state != TileState::Finished) return state;
    const PixelRect pixels{
        .col = tile.col, .row = tile.row - band_.row, .cols = tile.cols, .rows = tile.rows};
    if (fine_painter_) {
        thread_local Framebuffer fine;
        const int side = across_ * tile_size;
        if (fine.width != side) fine = Framebuffer(side, side);
        fine.background = out_.background;
        if (out_.light.empty()) {
            fine.light.clear();
        } else {
            fine.keep_planes(false);
        }
        if (!paint_fine(tile, limit, workspace, fine, counters)) return TileState::Rough;
        blank_rows = 0;
        blend_finer(fine, across_, pixels, out_);
    }
    if (watch_.on_tile) watch_.on_tile(pixels);
    return TileState::Finished;
}

}  // namespace

Counters render_frame(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                      Framebuffer& frame, const RenderWatch& watch) {
    return render_band(scene, camera, settings, {.row = 0, .height = frame.height}, frame, watch);
}

Counters render_band(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                     const ImageBand& band, Framebuffer& frame, const RenderWatch& watch) {
    assert(band.row >= 0 && band.row + frame.height <= band.height);
    assert(find_tracer(settings.tracer) != nullptr && camera_defect(camera) == nullptr);
    assert(scene.surfaces.size() <= max_surfaces);
    const NearestRounding nearest;  // the view does not depend on the caller's mode
    const FramePainter painter(scene, camera, settings, band, frame, watch);
    const TileGrid grid(frame.width, frame.height);
    const bool same_rows = frame.background == scene.background && band.height == frame.height;
    if (!same_rows) frame.blank_rows.clear();
    frame.background = scene.background;
    frame.blank_rows.resize(grid.size());
    frame.cost.resize(settings.costs ? frame.color.size() : 0);
    const int threads = settings.threads > 0 ? settings.threads : core_count();
    TileTurns turns(grid.size(), threads, watch.limit, watch.first_turn);
    std::vector<TileState> states(grid.size(), TileState::Waiting);
    std::vector<std::size_t> open(grid.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    std::mutex mutex;
    Counters total;
    std::atomic<bool> again = true;
    while (again.exchange(false) && !open.empty() && !watch.limit.cancelled()) {
        turns.begin(open.size());
        parallel_for(open.size(), settings.threads, [&](std::size_t i) {
            thread_local Workspace workspace;
            const std::size_t tile = open[i];
            const auto turn = turns.take(tile);
            if (!turn) return;
            const UpwardRegisters upward;
            Counters counters;
            std::uint64_t blank_rows = frame.blank_rows[tile];  // others write beside it
            Tile of_image = grid.tile(tile);
            of_image.row += band.row;
            states[tile] = painter.paint(of_image, *turn, workspace, blank_rows, counters);
            frame.blank_rows[tile] = blank_rows;
            if (states[tile] != TileState::Finished) again = true;
            const std::scoped_lock lock(mutex);
            total += counters;
        });
        std::erase_if(open, [&](std::size_t i) { return states[i] == TileState::Finished; });
    }
    for (const std::size_t i : open) {
        const Tile tile = grid.tile(i);
        if (states[i] == TileState::Cut) total.cut_pixels += undecided_in(frame, tile);
        if (states[i] == TileState::Rough) total.rough_pixels += pixels_in(tile);
    }
    return total;
}

}  // namespace zeroset
