#include "engine/render/known_frame.hpp"

#include "engine/base/parallel.hpp"
#include "engine/light/encode.hpp"
#include "engine/light/shade.hpp"
#include "engine/real/rounding.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace zeroset {

KnownFrame::KnownFrame(const Scene& scene, const Camera& camera, const TraceSettings& settings,
                       const Framebuffer& known)
    : threads_(settings.threads), grid_(known.width, known.height) {
    const ViewFrame view(camera);
    for (const Surface& surface : scene.surfaces) {
        surfaces_.push_back(trace_frame(
            scene, surface, view, {.width = known.width, .height = known.height}, settings.stop));
    }
    hits_.resize(grid_.size());
    for (std::size_t i = 0; i < grid_.size(); ++i) {
        hits_[i].resize(surfaces_.size());
        collect(grid_.tile(i), known, hits_[i]);
    }
}

void KnownFrame::collect(const Tile& tile, const Framebuffer& known,
                         std::vector<Hits>& hits) const {
    const ViewFrame& view = surfaces_.front().view;
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col) {
            const std::size_t at = known.index(tile.col + col, tile.row + row);
            if (known.surface[at] == no_surface) continue;
            Hits& of_surface = hits[known.surface[at]];
            const PixelPoint centre = pixel_centre(tile.col + col, tile.row + row);
            const double stretch =
                glm::length(view.direction(centre, {.width = known.width, .height = known.height}));
            const double s = static_cast<double>(known.depth[at]) / stretch - view.look_distance;
            of_surface.col.push_back(from_middle(col));
            of_surface.row.push_back(from_middle(row));
            of_surface.s.push_back(static_cast<float>(s));
            of_surface.pixel.push_back(static_cast<std::size_t>(row * tile_size + col));
            of_surface.depth.push_back(known.depth[at]);
            of_surface.certificate.push_back(known.certificate[at]);
        }
    }
    for (Hits& of_surface : hits) {
        while (of_surface.s.size() % batch_multiple != 0) {
            for (std::vector<float>* column : {&of_surface.col, &of_surface.row, &of_surface.s})
                column->push_back(column->front());
        }
    }
}

void KnownFrame::evaluate(std::size_t surface, const Tile& tile, const Hits& known,
                          TileHits& hits) const {
    constexpr std::size_t most = static_cast<std::size_t>(tile_size) * tile_size;
    thread_local std::array<std::vector<float>, 3> gradient;
    thread_local std::vector<float> s, per_slope;
    for (std::vector<float>& column : gradient)
        column.resize(most);
    s.resize(most);
    per_slope.resize(most);
    const TraceFrame& frame = surfaces_[surface];
    const std::size_t size = known.s.size();
    std::ranges::copy(known.s, s.begin());
    frame.kernel.newton(NewtonBatchOf<float>{
        .size = size,
        .col = known.col.data(),
        .row = known.row.data(),
        .from = known.s.data(),
        .to = known.s.data(),
        .rays = TileRays(frame, tile).kernel_rays<float>(),
        .uniforms = frame.scene.uniforms.points<float>(),
        .small_step = 0.0F,
        .more_steps = 0,
        .s = s.data(),
        .gradient = {gradient[0].data(), gradient[1].data(), gradient[2].data()},
        .per_slope = per_slope.data()});
    hits.any = true;
    for (std::size_t i = 0; i < known.pixel.size(); ++i) {
        const std::size_t pixel = known.pixel[i];
        hits.depth[pixel] = known.depth[i];
        hits.certificate[pixel] = known.certificate[i];
        for (std::size_t k = 0; k < 3; ++k)
            hits.gradient[k][pixel] = gradient[k][i];
    }
}

void KnownFrame::draw(Framebuffer& frame) const {
    const NearestRounding nearest;
    frame.blank_rows.clear();
    parallel_for(grid_.size(), threads_, [&](std::size_t index) {
        thread_local std::vector<TileHits> hits;
        thread_local LitTile lit;
        hits.resize(std::max(hits.size(), surfaces_.size()));
        const UpwardRegisters upward;
        const Tile tile = grid_.tile(index);
        for (std::size_t i = 0; i < surfaces_.size(); ++i) {
            hits[i].clear();
            const Hits& known = hits_[index][i];
            if (!known.pixel.empty()) evaluate(i, tile, known, hits[i]);
        }
        const auto of_tile = std::span(hits).first(surfaces_.size());
        lit.begin(of_tile);
        for (LitLayer& layer : lit.layers())
            shade(surfaces_[layer.surface], tile, layer);
        encode_tile(tile, of_tile, lit, {.pixels = frame, .height = frame.height});
    });
}

}  // namespace zeroset
