#pragma once

#include "engine/trace/tracer.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace zeroset {

/// Working arrays of the shading of one tile; kept between tiles to save allocations.
struct ShadeBuffers {
    std::array<std::vector<float>, 3> point;  ///< the hits, or where they are from the eye
    std::vector<float> f;
    std::array<std::vector<float>, 3> gradient;
    // What kernels in double write; made when there is one.
    std::vector<double> f_double;
    std::array<std::vector<double>, 3> gradient_double;
    std::vector<std::uint32_t> color;

    ShadeBuffers();
};

/// Background and misses in the whole tile.
void clear_tile(const Tile& tile, Framebuffer& out);

/// Two-sided shading by the gradient, in the colours of surface number `surface`: front where the
/// viewer stands on the side f > 0, back on the other. Writes the hits of the surface, and
/// Undecided where a ray is unsettled on pixels that are still misses; the rest of the tile stays.
void shade_tile(const TraceFrame& frame, std::uint8_t surface, const Tile& tile, TileHits& hits,
                ShadeBuffers& buffers, Framebuffer& out, Counters& counters);

/// The background of an image row, RGBA.
std::uint32_t background_color(int row, int height);

}  // namespace zeroset
