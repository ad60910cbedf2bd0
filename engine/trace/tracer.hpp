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

/// A surface of a frame being traced: what all tiles share. Lives while the frame is drawn;
/// read-only.
struct TraceFrame {
    const Scene& scene;
    const Kernel& kernel;  ///< of the surface: one of scene.surfaces
    ViewFrame view;
    int width;
    int height;
    StopCriterion stop;
};

/// A rectangle of the image, at most tile_size wide and high.
struct Tile {
    int col, row;  ///< its first pixel
    int cols, rows;
    /// For each pixel, in rows of tile_size, the distance from the eye beyond which nothing is
    /// wanted: a tracer may leave out what is farther. nullptr: all is wanted.
    const float* limits = nullptr;
};

/// What a tracer found of one surface in a tile: one item a hit, in no order, at most one a pixel.
/// A pixel's ray is the one that ViewFrame::direction gives for its centre. With the rule d_stop
/// the depth of a certified hit differs from that of the first root by at most four cells along
/// the ray's dominant axis, and 2^-21 of (depth + distance of the eye from the origin) for
/// rounding; a cell is the clip box's longest edge times 2^-d_stop, but not less than 2^-20 of its
/// largest coordinate.
/// Position i of every array belongs together. Arrays are padded so that kernels may read and write
/// up to a multiple of batch_multiple.
struct TileHits {
    struct Pixel {
        std::int16_t col, row;  ///< within the tile

        /// In arrays over the tile's pixels, in rows of tile_size.
        [[nodiscard]] std::size_t index() const {
            return static_cast<std::size_t>(row * tile_size + col);
        }
    };
    /// A ray that passed a cell that could be neither rejected nor drawn: a pole, a jump, the edge
    /// of a domain.
    struct Unsettled {
        Pixel at;
        float depth;  ///< the first such cell is no nearer to the eye along the ray
    };

    std::size_t size = 0;
    std::array<std::vector<float>, 3> position;  ///< on the surface, world units
    std::vector<float> depth;                    ///< distance from the eye along the ray
    std::vector<Pixel> pixel;
    std::vector<Certificate> certificate;
    std::array<std::vector<float>, 3> gradient;  ///< of f, if has_gradient
    bool has_gradient = false;  ///< whether the tracer knows it
    /// One item a ray, whether it hit something afterwards or not; such a hit is not certified.
    std::vector<Unsettled> unsettled;

    TileHits();
    void clear();
    void push(Pixel at, const std::array<float, 3>& where, float distance, Certificate known);
    /// Moves item `from` to `to`, which is not behind it.
    void move(std::size_t from, std::size_t to);
};

/// A way to find the first root on each ray. A new tracer is a new row of `tracers()`: camera,
/// kernels, shading and framebuffer are shared.
struct Tracer {
    std::string_view name;
    std::string_view about;  ///< one line
    /// One surface, one tile. Called in upward rounding, from many threads at once. `hits` is
    /// empty.
    void (*trace_tile)(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                       Counters& counters);
};

std::span<const Tracer> tracers();
/// nullptr when there is no such tracer.
const Tracer* find_tracer(std::string_view name);

}  // namespace zeroset
