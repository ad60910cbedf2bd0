#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/tile_grid.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"
#include "engine/view/camera.hpp"

#include <cstddef>
#include <vector>

namespace zeroset {

/// A frame whose depths are known already, in float. To draw it takes f and its gradient once for
/// each pixel that is hit, and the shading: no tracer can be quicker by much, and tracers are
/// measured against it. The scene outlives it.
class KnownFrame {
public:
    /// `known`: a frame of that scene and camera, without caps.
    KnownFrame(const Scene& scene, const Camera& camera, const TraceSettings& settings,
               const Framebuffer& known);
    /// Draws the known frame again.
    void draw(Framebuffer& frame) const;

private:
    /// The hits of one surface in one tile: columns, rows and depths as NewtonBatchOf has them,
    /// padded to whole batches, and what is known of each.
    struct Hits {
        std::vector<float> col, row, s;
        std::vector<std::size_t> pixel;  ///< in the tile, in rows of tile_size
        std::vector<float> depth;
        std::vector<Certificate> certificate;
    };
    void collect(const Tile& tile, const Framebuffer& known, std::vector<Hits>& hits) const;
    void evaluate(std::size_t surface, const Tile& tile, const Hits& known, TileHits& hits) const;

    std::vector<TraceFrame> surfaces_;
    int threads_;
    TileGrid grid_;
    std::vector<std::vector<Hits>> hits_;  ///< of each tile, of each surface
};

}  // namespace zeroset
