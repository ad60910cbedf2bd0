#include "engine/antialias/calm_pixels.hpp"

#include "engine/trace/flag_bits.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {
namespace {

/// How much channels of pixels that look the same may differ; 1 is the brightest that is shown.
constexpr float most_difference = 4.0F / 255.0F;

/// Which of the first `count` pixels of two stretches look the same, pixel by pixel.
std::uint64_t alike(const LitLayer& layer, std::size_t a, std::size_t b, std::size_t count) {
    std::array<std::uint8_t, tile_size> same;
    same.fill(1);
    for (int channel = 0; channel < 3; ++channel) {
        const float* const p =
            layer.light_row(static_cast<int>(a / tile_size), channel) + a % tile_size;
        const float* const q =
            layer.light_row(static_cast<int>(b / tile_size), channel) + b % tile_size;
        for (std::size_t i = 0; i < count; ++i) {
            // By gamma 2, as pixels are shown: (p - q) / (sqrt p + sqrt q) is the difference.
            const float change = p[i] - q[i];
            const bool near =
                change * change <= 2.0F * most_difference * most_difference * (p[i] + q[i]);
            same[i] = static_cast<std::uint8_t>(same[i] & static_cast<std::uint8_t>(near));
        }
    }
    return bits_of_flags(same);
}

/// Pixels of a row that look like their right neighbours.
std::uint64_t like_right(const LitLayer& layer, std::size_t row) {
    const std::uint64_t hits = layer.hit_rows[row];
    const std::size_t first = row * tile_size;
    return hits & hits >> 1U & alike(layer, first, first + 1, tile_size - 1);
}

/// Pixels of a row that look like those below.
std::uint64_t like_below(const LitLayer& layer, std::size_t row) {
    const std::uint64_t hits = layer.hit_rows[row] & layer.hit_rows[row + 1];
    const std::size_t first = row * tile_size;
    return hits & alike(layer, first, first + tile_size, tile_size);
}

void add_calm(const LitLayer& layer, const Tile& tile, const TileBits& wanted, TileBits& calm) {
    const auto rows = static_cast<std::size_t>(tile.rows);
    const auto needed = [&](std::size_t row) { return (wanted[row] & layer.hit_rows[row]) != 0; };
    // Row by row: the pixels that look like both of their neighbours, and like those below.
    TileBits beside{};
    TileBits below{};
    for (std::size_t row = 0; row < rows; ++row) {
        const bool here = needed(row);
        const bool next = row + 1 < rows && needed(row + 1);
        if (here || next || (row > 0 && needed(row - 1))) {
            const std::uint64_t right = like_right(layer, row);
            beside[row] = right & right << 1U;
        }
        if (here ? row + 1 < rows : next) below[row] = like_below(layer, row);
    }
    for (std::size_t row = 1; row + 1 < rows; ++row)
        calm[row] |= beside[row - 1] & beside[row] & beside[row + 1] & below[row - 1] & below[row];
}

}  // namespace

TileBits calm_pixels(const Tile& tile, std::span<const LitLayer> layers, const TileBits& wanted) {
    TileBits calm{};
    for (const LitLayer& layer : layers) {
        // A translucent pixel may look calm while what is behind it changes.
        if (layer.cover.empty()) add_calm(layer, tile, wanted, calm);
    }
    return calm;
}

}  // namespace zeroset
