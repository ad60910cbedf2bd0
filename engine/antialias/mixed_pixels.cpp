#include "engine/antialias/mixed_pixels.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace zeroset {
namespace {

/// A pixel that may show more than one smooth sheet, or less, by the hits of the surfaces.
std::optional<MixedPixel> mixed_pixel(std::span<const TileHits> hits, std::size_t at) {
    constexpr float none = std::numeric_limits<float>::infinity();
    // The nearest sheet, and what else there may be.
    float from = none;
    float to = none;
    float other = none;
    float hit = none;
    for (const TileHits& of : hits) {
        const PixelCover& cover = of.cover;
        hit = std::min(hit, of.depth[at]);
        if (!cover.known) other = -none;
        if (!cover.known || !cover.marked) continue;
        const bool nearer = cover.to[at] < to;
        other = std::min({other, cover.other_from[at], nearer ? from : cover.from[at]});
        if (nearer) from = cover.from[at];
        if (nearer) to = cover.to[at];
    }
    const float first = std::min(from, other);
    if (!(first < none) || to < other) return std::nullopt;
    return MixedPixel{.pixel = static_cast<std::uint16_t>(at), .from = first, .hit = hit};
}

/// Pixels of a row beside which the shadow on the same surface begins or ends.
std::uint64_t shadow_edges(const LitLayer& layer, const Tile& tile, int row) {
    const auto lit_in = [&](int of, std::uint64_t& hits) {
        hits = 0;
        std::uint64_t lit = 0;
        if (of < 0 || of >= tile.rows) return lit;
        hits = layer.hit_rows[static_cast<std::size_t>(of)];
        for (std::uint64_t bits = hits; bits != 0; bits &= bits - 1) {
            const auto col = static_cast<unsigned>(std::countr_zero(bits));
            const auto at = static_cast<std::size_t>(of) * tile_size + col;
            if (layer.key_light[at] > 0.0F) lit |= std::uint64_t{1} << col;
        }
        return lit;
    };
    std::uint64_t hits = 0;
    const std::uint64_t lit = lit_in(row, hits);
    const auto differ = [&](std::uint64_t other, std::uint64_t other_hits) {
        return (lit ^ other) & hits & other_hits;
    };
    std::uint64_t edges = differ(lit << 1U, hits << 1U) | differ(lit >> 1U, hits >> 1U);
    for (const int beside : {row - 1, row + 1}) {
        std::uint64_t other_hits = 0;
        const std::uint64_t other = lit_in(beside, other_hits);
        edges |= differ(other, other_hits);
    }
    return edges;
}

}  // namespace

void find_mixed(const Tile& tile, std::span<const TileHits> hits, std::vector<MixedPixel>& out) {
    const bool alone = hits.size() == 1 && hits.front().cover.known;
    for (int row = 0; row < tile.rows; ++row) {
        const std::uint64_t all = ~std::uint64_t{0} >> (tile_size - tile.cols);
        std::uint64_t bits = alone ? hits.front().cover.mixed_in_row(row) & all : all;
        for (; bits != 0; bits &= bits - 1) {
            const auto mixed = mixed_pixel(
                hits, static_cast<std::size_t>(row * tile_size + std::countr_zero(bits)));
            if (mixed) out.push_back(*mixed);
        }
    }
}

void add_shadow_edges(const Tile& tile, std::span<const LitLayer> layers,
                      std::span<const TileHits> hits, std::vector<MixedPixel>& mixed) {
    constexpr std::uint8_t level = 2;
    const std::size_t before = mixed.size();
    std::array<std::uint64_t, tile_size> edges{};
    for (const LitLayer& layer : layers) {
        for (int row = 0; row < tile.rows && layer.any_dark; ++row)
            edges[static_cast<std::size_t>(row)] |= shadow_edges(layer, tile, row);
    }
    for (std::size_t i = 0; i < before; ++i) {
        const std::uint16_t at = mixed[i].pixel;
        std::uint64_t& row = edges[at / tile_size];
        const std::uint64_t bit = std::uint64_t{1} << at % tile_size;
        if ((row & bit) != 0) mixed[i].least_level = level;
        row &= ~bit;
    }
    for (std::size_t row = 0; row < tile_size; ++row) {
        for (std::uint64_t bits = edges[row]; bits != 0; bits &= bits - 1) {
            const std::size_t at =
                row * tile_size + static_cast<std::size_t>(std::countr_zero(bits));
            MixedPixel pixel{.pixel = static_cast<std::uint16_t>(at),
                             .from = -std::numeric_limits<float>::infinity(),
                             .hit = std::numeric_limits<float>::infinity(),
                             .least_level = level};
            // One sheet covers the pixel, with nothing before it.
            for (const TileHits& of : hits) {
                if (!(of.depth[at] < pixel.hit)) continue;
                pixel.hit = of.depth[at];
                if (of.cover.known) pixel.from = of.cover.from[at];
            }
            mixed.push_back(pixel);
        }
    }
}

}  // namespace zeroset
