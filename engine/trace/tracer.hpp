#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/trace/scene.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace zeroset {

inline constexpr int tile_size = 64;

/// A frame being traced: what all its tiles share. Lives while the frame is drawn; read-only.
struct TraceFrame {
    const Scene& scene;
    ViewFrame view;
    int width;
    int height;
    StopCriterion stop;
};

/// A rectangle of the image, at most tile_size wide and high.
struct Tile {
    int col, row;  ///< its first pixel
    int cols, rows;
};

/// What a tracer found in a tile: one item a hit, in no order. Position i of every array belongs
/// together. Arrays are padded so that kernels may read and write up to a multiple of
/// batch_multiple.
struct TileHits {
    struct Pixel {
        std::int16_t col, row;  ///< within the tile
    };

    std::size_t size = 0;
    std::array<std::vector<float>, 3> position;  ///< on the surface, world units
    std::vector<float> depth;                    ///< distance from the eye along the ray
    std::vector<Pixel> pixel;
    std::vector<Certificate> certificate;
    /// Pixels whose ray passed a cell that could be neither rejected nor drawn (a pole, a jump)
    /// and hit nothing afterwards.
    std::vector<Pixel> unsettled;

    TileHits();
    void clear();
    void push(Pixel at, const std::array<float, 3>& where, float distance, Certificate known);
};

/// A way to find the first root on each ray. A new tracer is a new row of `tracers()`: camera,
/// kernels, shading and framebuffer are shared.
struct Tracer {
    std::string_view name;
    std::string_view about;  ///< one line
    /// Called in upward rounding, from many threads at once. `hits` is empty.
    void (*trace_tile)(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                       Counters& counters);
};

std::span<const Tracer> tracers();
/// nullptr when there is no such tracer.
const Tracer* find_tracer(std::string_view name);

}  // namespace zeroset
