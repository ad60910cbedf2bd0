#include "engine/render/render.hpp"

#include "engine/antialias/cover_light.hpp"
#include "engine/antialias/cover_limits.hpp"
#include "engine/antialias/cover_search.hpp"
#include "engine/antialias/mixed_pixels.hpp"
#include "engine/appearance/frame_light.hpp"
#include "engine/base/parallel.hpp"
#include "engine/image/blend.hpp"
#include "engine/light/encode.hpp"
#include "engine/light/keep_planes.hpp"
#include "engine/real/rounding.hpp"
#include "engine/render/tracers.hpp"
#include "engine/trace/caps.hpp"
#include "engine/trace/frame_kernels.hpp"
#include "engine/trace/frame_union.hpp"
#include "engine/trace/hit_gradients.hpp"
#include "engine/trace/nearest.hpp"
#include "engine/trace/open_view.hpp"
#include "engine/trace/patch/patch_tracer.hpp"
#include "engine/trace/patch/patch_tree.hpp"
#include "engine/trace/tile_costs.hpp"
#include "engine/trace/tile_grid.hpp"
#include "engine/trace/turns.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

namespace zeroset {
namespace {

/// Room that a thread keeps from tile to tile.
struct Workspace {
    std::vector<TileHits> hits;  ///< of each surface
    NearestSurfaces nearest;
    LitTile lit;
    CapFinder caps;
    std::vector<float> cover_limits;  ///< Tile::limits of whole pixels
    std::vector<UnionMember> union_members;
    std::vector<MixedPixel> mixed;
    std::vector<CoverSample> samples;
    CoverLight cover_light;
    TileCosts costs;
};

/// The state of a tile.
enum class TileState : std::uint8_t {
    Waiting,  ///< nothing is drawn
    Cut,      ///< some of its rays were not searched to their end
    Rough,    ///< shadows or smooth edges are missing
    Finished,
};

/// The surface as a union; nullptr where it is not known as one.
std::unique_ptr<FrameUnion> union_of(const TraceFrame& surface) {
    const Specializer* const specializer = surface.kernel.specializer.get();
    const UnionParts* const union_parts =
        specializer == nullptr ? nullptr : specializer->union_parts();
    if (union_parts == nullptr || !surface.scene.region.is_whole()) return nullptr;
    return std::make_unique<FrameUnion>(surface, *union_parts);
}

/// Where in its view surface i may be; nullptr where that is not known.
std::unique_ptr<OpenView> open_view_of(const TraceFrame& surface, std::size_t i) {
    const auto& spaces = surface.scene.open_space;
    if (i >= spaces.size() || spaces[i] == nullptr) return nullptr;
    return std::make_unique<OpenView>(surface, *spaces[i]);
}

/// How the scene is antialiased. Beams know neither of caps, nor of jumps, nor of parametric
/// surfaces: there 16 rays do it.
Antialias antialias_of(const Scene& scene, const TraceSettings& settings) {
    const bool by_rays =
        scene.jumps || has_caps(scene) ||
        std::ranges::any_of(scene.surfaces, [](const Kernel& kernel) { return is_patch(kernel); });
    return settings.antialias == Antialias::Beams && by_rays ? Antialias::Rays16
                                                             : settings.antialias;
}

void keep_costs(const Tile& tile, const TileCosts& costs, const Canvas& out) {
    for (int row = 0; row < tile.rows; ++row) {
        float* const to = &out.pixels.cost[out.index(tile.col, tile.row + row)];
        std::ranges::transform(costs.row(row, tile.cols), to,
                               [](double cost) { return static_cast<float>(cost); });
    }
}

/// A scene at one resolution, tile by tile.
class TilePainter {
public:
    /// `fineness`: pixels of `image` across one of the picture.
    TilePainter(const Scene& scene, const ViewFrame& view, const TraceSettings& settings,
                const ImageSize& image, int fineness, const TimeLimit& limit);
    /// In upward rounding.
    TileState paint(Tile tile, const TimeLimit& limit, Workspace& workspace, const Canvas& out,
                    Counters& counters) const;

private:
    /// Fills workspace.hits with what each surface shows.
    void trace(Tile tile, const TimeLimit& limit, Workspace& workspace, Counters& counters) const;
    /// Traces surface i part by part and finds its gradients; false where that cannot be.
    bool trace_union(std::size_t i, const Tile& tile, const TimeLimit& limit, Workspace& workspace,
                     Counters& counters) const;
    /// Draws again, by their parts, pixels that may show more than one smooth sheet.
    void smooth(const Tile& tile, const TimeLimit& limit, Workspace& workspace, const Canvas& out,
                Counters& counters) const;
    /// Traces surface i.
    void trace_surface(std::size_t i, const Tile& tile, const TimeLimit& limit,
                       Workspace& workspace, Counters& counters) const;

    /// Surface i with the kernel for the tile.
    [[nodiscard]] TraceFrame frame_of(std::size_t i, const Tile& tile,
                                      const TimeLimit& limit) const {
        const TraceFrame& whole = surfaces_[i];
        const Kernel& kernel = kernels_[i] == nullptr ? whole.kernel : kernels_[i]->of(tile);
        return whole.with(kernel, limit);
    }

    const Tracer& tracer_;
    FrameLight light_;
    bool beams_;  ///< pixels that show more than one smooth sheet are drawn part by part
    std::vector<TraceFrame> surfaces_;
    std::vector<std::unique_ptr<FrameKernels>> kernels_;  ///< nullptr: of all tiles the same
    std::vector<std::unique_ptr<FrameUnion>> unions_;     ///< nullptr: no union is known
    std::vector<std::unique_ptr<OpenView>> open_views_;   ///< nullptr: not known
    std::vector<std::shared_ptr<const PreparedSurface>> prepared_;  ///< by the tracer; or none
    std::vector<int> solid_signs_;  ///< of the surfaces; empty: nothing is capped
};

TilePainter::TilePainter(const Scene& scene, const ViewFrame& view, const TraceSettings& settings,
                         const ImageSize& image, int fineness, const TimeLimit& limit)
    : tracer_(*find_tracer(settings.tracer)),
      light_(scene, view, settings, fineness),
      beams_(antialias_of(scene, settings) == Antialias::Beams) {
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        surfaces_.push_back(trace_frame(scene, scene.surfaces[i], view, image, settings.stop));
        surfaces_.back().whole_pixels = beams_;
        if (has_caps(scene)) solid_signs_.push_back(solid_sign(scene, i));
    }
    for (TraceFrame& surface : surfaces_) {
        if (is_patch(surface.kernel)) {
            prepared_.push_back(patch_tree(surface.kernel, scene.uniforms));
            surface.prepared = prepared_.back().get();
            kernels_.push_back(nullptr);
            unions_.push_back(nullptr);
            open_views_.push_back(nullptr);
            continue;
        }
        if (tracer_.prepare != nullptr) {
            prepared_.push_back(
                tracer_.prepare(surface.with(surface.kernel, limit), settings.threads));
            surface.prepared = prepared_.back().get();
        }
        const bool pays = tracer_.specializes || surface.kernel.interpreted;
        kernels_.push_back(
            pays && surface.kernel.specializer ? std::make_unique<FrameKernels>(surface) : nullptr);
        unions_.push_back(tracer_.takes_unions ? union_of(surface) : nullptr);
        open_views_.push_back(open_view_of(surface, open_views_.size()));
    }
}

bool TilePainter::trace_union(std::size_t i, const Tile& tile, const TimeLimit& limit,
                              Workspace& workspace, Counters& counters) const {
    if (unions_[i] == nullptr || !unions_[i]->list(tile, workspace.union_members)) return false;
    if (workspace.union_members.empty()) {
        workspace.hits[i].cover.clear();
        return true;
    }
    TraceFrame frame = surfaces_[i];
    frame.union_members = workspace.union_members;
    frame.open = open_views_[i].get();
    frame.limit = limit;
    tracer_.trace_tile(frame, tile, workspace.hits[i], counters);
    find_gradients(frame, tile, workspace.hits[i], counters);
    return true;
}

void TilePainter::trace_surface(std::size_t i, const Tile& tile, const TimeLimit& limit,
                                Workspace& workspace, Counters& counters) const {
    TileHits& hits = workspace.hits[i];
    hits.clear();
    if (limit.over()) return hits.leave_undecided(tile);
    if (is_patch(surfaces_[i].kernel))
        return trace_tile_patch(frame_of(i, tile, limit), tile, hits, counters);
    if (trace_union(i, tile, limit, workspace, counters)) return;
    TraceFrame frame = frame_of(i, tile, limit);
    frame.open = open_views_[i].get();
    const bool is_capped = !solid_signs_.empty() && solid_signs_[i] != 0;
    if (!is_capped) return tracer_.trace_tile(frame, tile, hits, counters);
    CapFinder& caps = workspace.caps;
    caps.fill(frame, solid_signs_[i], counters);
    Tile before_caps = tile;
    before_caps.limits = caps.limits(tile.limits);
    tracer_.trace_tile(frame, before_caps, hits, counters);
    caps.put(hits);
}

void TilePainter::trace(Tile tile, const TimeLimit& limit, Workspace& workspace,
                        Counters& counters) const {
    const bool several = surfaces_.size() > 1;
    workspace.hits.resize(std::max(workspace.hits.size(), surfaces_.size()));
    if (several) workspace.nearest.clear();
    if (several && beams_)
        workspace.cover_limits.assign(std::size_t{tile_size} * tile_size,
                                      std::numeric_limits<float>::infinity());
    if (!solid_signs_.empty()) workspace.caps.enter(surfaces_.front(), tile);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        trace_surface(i, tile, limit, workspace, counters);
        if (!several || limit.cancelled()) return;
        workspace.nearest.add(workspace.hits[i], static_cast<std::uint8_t>(i));
        tile.limits = workspace.nearest.limits();
        if (!beams_) continue;
        narrow_limits(surfaces_[i], tile, workspace.hits[i], workspace.cover_limits);
        tile.limits = workspace.cover_limits.data();
    }
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
        workspace.nearest.keep_nearest(workspace.hits[i], static_cast<std::uint8_t>(i));
}

void TilePainter::smooth(const Tile& tile, const TimeLimit& limit, Workspace& workspace,
                         const Canvas& out, Counters& counters) const {
    workspace.mixed.clear();
    workspace.samples.clear();
    const auto hits = std::span(workspace.hits).first(surfaces_.size());
    find_mixed(tile, hits, workspace.mixed);
    add_light_edges(tile, workspace.lit.layers(), hits, light_.shows_contrasts(), workspace.mixed);
    if (workspace.mixed.empty()) return;
    std::vector<TraceFrame> frames;
    frames.reserve(surfaces_.size());
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
        frames.push_back(frame_of(i, tile, limit));
    find_cover(frames, tile, workspace.mixed, workspace.samples, counters);
    const auto light =
        workspace.cover_light.light(light_, surfaces_, limit, tile, workspace.samples, counters);
    if (limit.over()) return;
    draw_cover(tile, workspace.mixed, workspace.samples, light, out);
}

TileState TilePainter::paint(Tile tile, const TimeLimit& limit, Workspace& workspace,
                             const Canvas& out, Counters& counters) const {
    const bool tells_costs = !out.pixels.cost.empty();
    if (tells_costs) {
        workspace.costs.begin(tile);
        counters.costs = &workspace.costs;
    }
    trace(tile, limit, workspace, counters);
    if (limit.cancelled()) return TileState::Waiting;
    const bool cut = limit.over();  // a tile that was finished just before counts as cut, too
    const auto hits = std::span(workspace.hits).first(surfaces_.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (!hits[i].points.empty())
            find_gradients(frame_of(i, tile, limit), tile, hits[i], counters);
    }
    counters.costs = nullptr;
    if (tells_costs) keep_costs(tile, workspace.costs, out);
    light_.light(surfaces_, limit, tile, hits, workspace.lit, counters);
    if (limit.cancelled()) return TileState::Waiting;
    encode_tile(tile, hits, workspace.lit, out);
    keep_planes(tile, hits, workspace.lit, out);
    if (beams_ && !limit.over()) smooth(tile, limit, workspace, out, counters);
    if (limit.cancelled()) return TileState::Waiting;
    return cut ? TileState::Cut : limit.over() ? TileState::Rough : TileState::Finished;
}

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
    Turns turns(grid.size(), threads, watch.limit, watch.first_turn);
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
