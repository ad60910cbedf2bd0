#pragma once

#include "engine/trace/tile_hits.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

static_assert(tile_size <= 64);
/// A bit for each pixel of a tile: a word for each row, the first pixel lowest.
using TileBits = std::array<std::uint64_t, tile_size>;

/// Whether the bit of a pixel is set; `pixel` is an index into a tile.
inline bool is_set(const TileBits& bits, std::size_t pixel) {
    return (bits[pixel / tile_size] >> pixel % tile_size & 1U) != 0;
}

/// Hits in the shadow.
struct ShadowBits {
    TileBits dark{};
    /// Hits of which it is not proved whether the light reaches them: at a shadow's edge, mostly.
    TileBits unproved{};

    /// Takes in hits of a row that are proved to lie in the shadow.
    void prove_dark(std::size_t row, std::uint64_t hits) {
        dark[row] |= hits;
        unproved[row] &= ~hits;
    }
    /// Takes in hits of a row of which it is not proved whether the light reaches them; a proof by
    /// another search stands.
    void doubt(std::size_t row, std::uint64_t hits) { unproved[row] |= hits & ~dark[row]; }
};

/// The light of one surface's hits in a tile. Arrays hold one item a pixel, in rows of tile_size;
/// items of pixels without a hit are undefined.
struct LitLayer {
    std::uint8_t surface = 0;        ///< index in the scene
    const TileHits* hits = nullptr;  ///< of the surface; there is one at least
    TileBits dark_rows{};            ///< hits that the key light does not reach
    /// The reflectances of hits, red, green and blue, where the scene is coloured by more than its
    /// surfaces; else empty.
    std::array<std::vector<float>, 3> reflectance;
    /// How much of what is seen at hits is not the background, 0 to 1; empty: all.
    std::vector<float> cover;
    TileBits hit_rows{};  ///< of hits
    /// Linear light from hits towards the eye; 1 is the brightest that a picture shows. For each
    /// row of pixels tile_size reds, then as many greens, then blues.
    std::vector<float> light;

    LitLayer();
    [[nodiscard]] bool any_dark() const {
        return std::ranges::any_of(dark_rows, [](std::uint64_t row) { return row != 0; });
    }
    [[nodiscard]] float* light_row(int row, int channel) { return &light[light_at(row, channel)]; }
    [[nodiscard]] const float* light_row(int row, int channel) const {
        return &light[light_at(row, channel)];
    }

private:
    static std::size_t light_at(int row, int channel) {
        return static_cast<std::size_t>(3 * row + channel) * tile_size;
    }
};

/// The light of a tile: a layer for each surface that is hit. One for each
/// thread; it keeps its memory from tile to tile.
class LitTile {
public:
    /// Begins a tile with these hits, item i of surface i, which outlive its layers: all lit by the
    /// key light, without colours.
    void begin(std::span<const TileHits> hits);
    [[nodiscard]] std::span<LitLayer> layers() { return std::span(kept_).first(count_); }
    [[nodiscard]] std::span<const LitLayer> layers() const {
        return std::span(kept_).first(count_);
    }

private:
    std::vector<LitLayer> kept_;
    std::size_t count_ = 0;  ///< of layers in use
};

}  // namespace zeroset
