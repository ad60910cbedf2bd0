#include "engine/render/tile_painter.hpp"

#include "engine/antialias/cover_search.hpp"
#include "engine/antialias/mixed_pixels.hpp"
#include "engine/light/tile_light.hpp"
#include "engine/trace/hit_gradients.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/ways/surface_ways.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <span>

namespace zeroset {
namespace {

bool is_level_set(const Kernel& surface) { return way_of(surface).is_level_set(); }

/// The surface as a union; nullptr where it is not known as one.
std::unique_ptr<FrameUnion> union_of(const TraceFrame& surface) {
    const Specializer* const specializer = surface.kernel.specializer.get();
    const UnionParts* const union_parts =
        specializer == nullptr ? nullptr : specializer->union_parts();
    if (union_parts == nullptr || !surface.scene.region.is_whole()) return nullptr;
    return std::make_unique<FrameUnion>(surface, *union_parts);
}

/// Where in its view a surface may be; nullptr where that is not known.
std::unique_ptr<OpenView> open_view_of(const TraceFrame& surface, const OpenSpace* space) {
    const bool is_known = space != nullptr && is_level_set(surface.kernel);
    return is_known ? std::make_unique<OpenView>(surface, *space) : nullptr;
}

void keep_costs(const Tile& tile, const TileCosts& costs, const Canvas& out) {
    for (int row = 0; row < tile.rows; ++row) {
        float* const to = &out.pixels.cost[out.index(tile.col, tile.row + row)];
        std::ranges::transform(costs.row(row, tile.cols), to,
                               [](double cost) { return static_cast<float>(cost); });
    }
}

}  // namespace

Antialias antialias_of(const Scene& scene, const TraceSettings& settings) {
    const bool by_rays = scene.jumps || has_caps(scene) ||
                         !std::ranges::all_of(scene.surfaces, is_level_set, &Surface::kernel);
    return settings.antialias == Antialias::Beams && by_rays ? Antialias::Rays16
                                                             : settings.antialias;
}

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
        prepared_.push_back(prepare(surface, settings, limit));
        surface.prepared = prepared_.back().get();
        const bool pays = tracer_.specializes || surface.kernel.interpreted;
        kernels_.push_back(
            pays && surface.kernel.specializer ? std::make_unique<FrameKernels>(surface) : nullptr);
        unions_.push_back(tracer_.takes_unions ? union_of(surface) : nullptr);
        open_views_.push_back(
            open_view_of(surface, scene.surfaces[open_views_.size()].open_space.get()));
    }
}

std::shared_ptr<const PreparedSurface> TilePainter::prepare(const TraceFrame& surface,
                                                            const TraceSettings& settings,
                                                            const TimeLimit& limit) const {
    const Kernel& kernel = surface.kernel;
    const auto prepare_by_tracer = is_level_set(kernel) ? tracer_.needs.prepare : nullptr;
    return prepare_by_tracer != nullptr
               ? prepare_by_tracer(surface.with(kernel, limit), settings.threads)
               : way_of(kernel).prepare(kernel, surface.scene.uniforms);
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
    if (!is_level_set(surfaces_[i].kernel)) {
        [[maybe_unused]] const bool is_traced =
            way_of(surfaces_[i].kernel).trace_tile(frame_of(i, tile, limit), tile, hits, counters);
        assert(is_traced);
        return;
    }
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
    find_mixed(tile, workspace.lit.layers(), hits, workspace.mixed);
    const bool any_dark = std::ranges::any_of(workspace.lit.layers(), &LitLayer::any_dark);
    if (any_dark || light_.shows_contrasts())
        add_light_edges(tile, TileRays(surfaces_.front(), tile), workspace.lit.layers(), hits,
                        light_.shows_contrasts(), workspace.mixed);
    if (workspace.mixed.empty()) return;
    std::vector<TraceFrame> frames;
    frames.reserve(surfaces_.size());
    // Use what is near each pixel where the only surface's kind knows that.
    const TraceFrame& first = surfaces_.front();
    const std::optional<Kernel> by_way =
        surfaces_.size() == 1 ? way_of(first.kernel).kernel_for(first, tile) : std::nullopt;
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
        frames.push_back(by_way ? surfaces_[i].with(*by_way, limit) : frame_of(i, tile, limit));
    find_cover(frames, tile, workspace.mixed, workspace.samples, counters);
    const auto light = workspace.cover_light.light(
        light_, surfaces_, limit, tile, workspace.lit.layers(), workspace.samples, counters);
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
    if (beams_ && !surfaces_.empty() && !limit.over())
        smooth(tile, limit, workspace, out, counters);
    if (limit.cancelled()) return TileState::Waiting;
    return cut ? TileState::Cut : limit.over() ? TileState::Rough : TileState::Finished;
}

}  // namespace zeroset
