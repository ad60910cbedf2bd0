#include "engine/antialias/calm_pixels.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace zeroset {
namespace {

/// How much channels of pixels that look the same may differ; 1 is the brightest that is shown.
constexpr float most_difference = 4.0F / 255.0F;

/// The lowest bits of bytes.
std::uint64_t bits_of(const std::array<std::uint8_t, tile_size>& flags) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < tile_size; i += 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, &flags[i], 8);
        // Gathers the lowest bits of eight bytes in the highest one.
        bits |= (eight * 0x0102040810204080U >> 56U) << i;
    }
    return bits;
}

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
    return bits_of(same);
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
    // Of each row, pixels that look like both of their neighbours, and like those below.
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
        // What is seen through a surface may change where it does not.
        if (layer.cover.empty()) add_calm(layer, tile, wanted, calm);
    }
    return calm;
}

}  // namespace zeroset
