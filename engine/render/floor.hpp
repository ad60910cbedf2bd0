#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/scene/scene.hpp"
#include "engine/trace/tile_grid.hpp"

#include <cstddef>
#include <vector>

namespace zeroset {

/// A frame whose depths are known already, in float: f and its gradient once for each pixel that is
/// hit, and the shading. No tracer can be quicker by much; what it takes is the floor that tracers
/// are measured against. The scene outlives it.
class KnownFrame {
public:
    /// `known`: a frame of that scene and camera, without caps.
    KnownFrame(const Scene& scene, const Camera& camera, const TraceSettings& settings,
               const Framebuffer& known);
    /// The same frame again.
    void draw(Framebuffer& frame) const;

private:
    /// What is known of one surface in one tile: RaysOf's columns, and where the hits are.
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
