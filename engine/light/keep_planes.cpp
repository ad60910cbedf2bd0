#include "engine/image/background.hpp"
#include "engine/light/tile_light.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {
namespace {

void clear_row(const Tile& tile, int row, const Canvas& out) {
    const int image_row = tile.row + row;
    const auto [red, green, blue] = background_light(out.pixels.background, image_row, out.height);
    const std::size_t first = out.index(tile.col, image_row);
    std::fill_n(&out.pixels.light[first], tile.cols, std::array{red, green, blue, 0.0F});
    if (!out.pixels.normal.empty())
        std::fill_n(&out.pixels.normal[first], tile.cols, std::array<float, 3>{});
}

std::array<float, 3> normal_along(const glm::dvec3& gradient) {
    const double length = glm::length(gradient);
    if (!(length > 0)) return {};
    const glm::vec3 normal(gradient / length);
    return {normal.x, normal.y, normal.z};
}

void keep_row(const LitLayer& layer, const TileHits& hits, const Tile& tile, int row,
              const Canvas& out) {
    const std::uint64_t bits = layer.hit_rows[static_cast<std::size_t>(row)];
    for (int col = 0; col < tile.cols; ++col) {
        if ((bits >> col & 1U) == 0) continue;
        const auto pixel = static_cast<std::size_t>(row * tile_size + col);
        const std::size_t to = out.index(tile.col + col, tile.row + row);
        std::array<float, 4>& light = out.pixels.light[to];
        for (int channel = 0; channel < 3; ++channel)
            light[static_cast<std::size_t>(channel)] = layer.light_row(row, channel)[col];
        light[3] = layer.cover.empty() ? 1.0F : layer.cover[pixel];
        if (!out.pixels.normal.empty())
            out.pixels.normal[to] = normal_along(hits.gradient_at(pixel));
    }
}

}  // namespace

void keep_planes(const Tile& tile, std::span<const TileHits> hits, const LitTile& lit,
                 const Canvas& out) {
    if (out.pixels.light.empty()) return;
    for (int row = 0; row < tile.rows; ++row) {
        clear_row(tile, row, out);
        for (const LitLayer& layer : lit.layers())
            keep_row(layer, hits[layer.surface], tile, row, out);
    }
}

}  // namespace zeroset
