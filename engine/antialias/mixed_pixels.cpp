#include "engine/antialias/mixed_pixels.hpp"

#include "engine/antialias/seen_sheet.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
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
    float last = -none;
    for (const TileHits& of : hits) {
        const PixelCover& cover = of.cover;
        hit = std::min(hit, of.depth[at]);
        if (!cover.known) other = -none;
        if (!cover.known) last = none;
        if (!cover.known || !cover.is_marked()) continue;
        last = std::max(last, cover.last[at]);
        const bool nearer = cover.to[at] < to;
        other = std::min({other, cover.other_from[at], nearer ? from : cover.from[at]});
        if (nearer) from = cover.from[at];
        if (nearer) to = cover.to[at];
    }
    const float first = std::min(from, other);
    if (!(first < none) || to < other) return std::nullopt;
    return MixedPixel{
        .pixel = static_cast<std::uint16_t>(at), .from = first, .hit = hit, .to = last};
}

/// Adds the mixed pixels of a row of one surface's hits, of those in `wanted`; returns which.
std::uint64_t add_mixed_of(const TileHits& hits, int row, std::uint64_t wanted,
                           std::vector<MixedPixel>& out) {
    const PixelCover& cover = hits.cover;
    const std::uint64_t mixed = cover.mixed_in_row(row) & wanted;
    for (std::uint64_t bits = mixed; bits != 0; bits &= bits - 1) {
        const auto at = static_cast<std::size_t>(row * tile_size + std::countr_zero(bits));
        out.push_back({.pixel = static_cast<std::uint16_t>(at),
                       .from = std::min(cover.from[at], cover.other_from[at]),
                       .hit = hits.depth[at],
                       .to = cover.last[at]});
    }
    return mixed;
}

/// Adds the mixed pixels of a row, of those in `wanted`, by the hits of all surfaces; returns
/// which.
std::uint64_t add_mixed(std::span<const TileHits> hits, int row, std::uint64_t wanted,
                        std::vector<MixedPixel>& out) {
    std::uint64_t mixed = 0;
    for (; wanted != 0; wanted &= wanted - 1) {
        const auto pixel =
            mixed_pixel(hits, static_cast<std::size_t>(row * tile_size + std::countr_zero(wanted)));
        if (!pixel) continue;
        out.push_back(*pixel);
        mixed |= wanted & (~wanted + 1);
    }
    return mixed;
}

/// Whether the lights of two hits look different: by more than this part of the brightest.
bool look_different(const LitLayer& layer, std::size_t a, std::size_t b, float least) {
    const auto shown = [&](std::size_t at, int channel) {
        const float* const row = layer.light_row(static_cast<int>(at / tile_size), channel);
        return std::sqrt(std::clamp(row[at % tile_size], 0.0F, 1.0F));
    };
    for (int channel = 0; channel < 3; ++channel) {
        if (std::abs(shown(a, channel) - shown(b, channel)) > least) return true;
    }
    return false;
}

/// The sheet of a pixel's hit.
SeenSheet sheet_at(const TileRays& rays, const TileHits& hits, std::size_t at) {
    return {rays, static_cast<double>(at % tile_size), static_cast<double>(at / tile_size),
            static_cast<double>(hits.depth[at]), hits.gradient_at(at)};
}

/// Whether two hits side by side may be on one sheet, as their distances and normals are.
bool are_of_one_sheet(const TileRays& rays, const TileHits& hits, std::size_t a, std::size_t b) {
    constexpr double least_cosine = 0.5;
    const auto apart = static_cast<double>(std::abs(hits.depth[a] - hits.depth[b]));
    if (!sheet_at(rays, hits, a).may_be_apart(apart) &&
        !sheet_at(rays, hits, b).may_be_apart(apart))
        return false;
    const glm::dvec3 first = hits.gradient_at(a);
    const glm::dvec3 second = hits.gradient_at(b);
    const double product = glm::dot(first, second);
    return product > 0.0 && product * product >= least_cosine * least_cosine *
                                                     glm::dot(first, first) *
                                                     glm::dot(second, second);
}

/// Adds the hits beside which a shadow that is seen begins or ends on the same sheet.
void add_shadow_edges(const LitLayer& layer, const Tile& tile, const TileRays& rays,
                      TileBits& edges) {
    constexpr float least = 0.02F;
    const TileBits& hits = layer.hit_rows;
    const TileBits& dark = layer.dark_rows;
    const auto add_pairs = [&](std::uint64_t differ, std::size_t row, std::size_t by_row,
                               std::size_t by_col) {
        for (; differ != 0; differ &= differ - 1) {
            const auto col = static_cast<std::size_t>(std::countr_zero(differ));
            const std::size_t a = row * tile_size + col;
            const std::size_t b = a + by_row * tile_size + by_col;
            if (!look_different(layer, a, b, least) || !are_of_one_sheet(rays, *layer.hits, a, b))
                continue;
            edges[row] |= std::uint64_t{1} << col;
            edges[row + by_row] |= std::uint64_t{1} << (col + by_col);
        }
    };
    for (std::size_t row = 0; row < static_cast<std::size_t>(tile.rows); ++row) {
        add_pairs((dark[row] ^ dark[row] >> 1U) & hits[row] & hits[row] >> 1U, row, 0, 1);
        if (row + 1 < static_cast<std::size_t>(tile.rows))
            add_pairs((dark[row] ^ dark[row + 1]) & hits[row] & hits[row + 1], row, 1, 0);
    }
}

/// Adds the hits beside which the same surface looks different.
void add_contrasts(const LitLayer& layer, const Tile& tile, TileBits& edges) {
    constexpr float least = 0.09F;
    const auto rows = static_cast<std::size_t>(tile.rows);
    const auto compare = [&](std::size_t row, std::size_t col, std::size_t by_row,
                             std::size_t by_col) {
        const std::uint64_t bit = std::uint64_t{1} << col;
        const std::uint64_t other = std::uint64_t{1} << (col + by_col);
        if ((layer.hit_rows[row + by_row] & other) == 0) return;
        const std::size_t at = row * tile_size + col;
        if (!look_different(layer, at, at + by_row * tile_size + by_col, least)) return;
        edges[row] |= bit;
        edges[row + by_row] |= other;
    };
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::uint64_t bits = layer.hit_rows[row]; bits != 0; bits &= bits - 1) {
            const auto col = static_cast<std::size_t>(std::countr_zero(bits));
            if (col + 1 < tile_size) compare(row, col, 0, 1);
            if (row + 1 < rows) compare(row, col, 1, 0);
        }
    }
}

}  // namespace

void find_mixed(const Tile& tile, std::span<const LitLayer> layers, std::span<const TileHits> hits,
                std::vector<MixedPixel>& out) {
    const bool alone = hits.size() == 1 && hits.front().cover.known;
    TileBits found{};
    for (int row = 0; row < tile.rows; ++row) {
        const std::uint64_t all = ~std::uint64_t{0} >> (tile_size - tile.cols);
        found[static_cast<std::size_t>(row)] =
            alone ? add_mixed_of(hits.front(), row, all, out) : add_mixed(hits, row, all, out);
    }
    if (out.empty()) return;
    const TileBits calm = calm_pixels(tile, layers, found);
    for (MixedPixel& mixed : out)
        mixed.is_calm = (calm[mixed.pixel / tile_size] >> mixed.pixel % tile_size & 1U) != 0;
}

void add_light_edges(const Tile& tile, const TileRays& rays, std::span<const LitLayer> layers,
                     std::span<const TileHits> hits, bool contrasts,
                     std::vector<MixedPixel>& mixed) {
    constexpr std::uint8_t level = 2;
    const std::size_t before = mixed.size();
    TileBits edges{};
    for (const LitLayer& layer : layers) {
        if (layer.any_dark()) add_shadow_edges(layer, tile, rays, edges);
        if (contrasts) add_contrasts(layer, tile, edges);
    }
    // Set the level of edge pixels that are mixed already, and take them from the edges.
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
            for (std::size_t i = 0; i < hits.size(); ++i) {
                const PixelCover& cover = hits[i].cover;
                pixel.hit = std::min(pixel.hit, hits[i].depth[at]);
                if (!cover.known || !cover.is_marked() || !(cover.to[at] < pixel.sheet_to))
                    continue;
                pixel.from = cover.from[at];
                pixel.sheet_to = cover.to[at];
                pixel.surface = static_cast<std::uint8_t>(i);
            }
            mixed.push_back(pixel);
        }
    }
}

}  // namespace zeroset
