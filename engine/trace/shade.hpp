#pragma once

#include "engine/trace/tracer.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace zeroset {

/// Working arrays of the shading of one tile; kept between tiles to save allocations.
struct ShadeBuffers {
    std::vector<float> f;
    std::array<std::vector<float>, 3> gradient;
    std::vector<std::uint32_t> color;

    ShadeBuffers();
};

/// Two-sided shading by the gradient: blue where the viewer stands on the side f > 0, amber on
/// the other. Writes colour, depth and certificate of the tile's hits, background elsewhere.
void shade_tile(const TraceFrame& frame, const Tile& tile, TileHits& hits, ShadeBuffers& buffers,
                Framebuffer& out, Counters& counters);

/// The background of an image row, RGBA.
std::uint32_t background_color(int row, int height);

}  // namespace zeroset
