#include "engine/antialias/calm_pixels.hpp"

#include "engine/trace/flag_bits.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {
namespace {

/// How much channels of pixels that look the same may differ; 1 is the brightest that is shown.
constexpr float most_difference = 4.0F / 255.0F;

/// Columns that are compared at once.
constexpr std::size_t block = 8;

/// Which of `count` pixels from a and b on look the same, pixel by pixel.
template <std::size_t count>
std::uint64_t alike(const LitLayer& layer, std::size_t a, std::size_t b) {
    std::array<std::uint8_t, block> same{};
    std::fill_n(same.begin(), count, std::uint8_t{1});
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

/// Which of the wanted pixels of a row look like those to the right; of others it tells nothing.
std::uint64_t like_right(const LitLayer& layer, std::size_t row, std::uint64_t wanted) {
    std::uint64_t same = 0;
    for (std::size_t col = 0; col < tile_size; col += block) {
        if ((wanted >> col & 0xFFU) == 0) continue;
        const std::size_t at = row * tile_size + col;
        same |= (col + block < tile_size ? alike<block>(layer, at, at + 1)
                                         : alike<block - 1>(layer, at, at + 1))
                << col;
    }
    return same;
}

/// Which of the wanted pixels of a row look like both beside them; of others it tells nothing.
std::uint64_t like_beside(const LitLayer& layer, std::size_t row, std::uint64_t wanted) {
    const std::uint64_t right = like_right(layer, row, wanted | wanted >> 1U);
    return right & right << 1U;
}

/// Which of the wanted pixels of a row look like those below; of others it tells nothing.
std::uint64_t like_below(const LitLayer& layer, std::size_t row, std::uint64_t wanted) {
    std::uint64_t same = 0;
    for (std::size_t col = 0; col < tile_size; col += block) {
        if ((wanted >> col & 0xFFU) == 0) continue;
        const std::size_t at = row * tile_size + col;
        same |= alike<block>(layer, at, at + tile_size) << col;
    }
    return same;
}

/// The wanted pixels that are hit, as all around them are.
TileBits amid_hits(const LitLayer& layer, const Tile& tile, const TileBits& wanted) {
    const auto three = [&](std::size_t row) {
        const std::uint64_t hits = layer.hit_rows[row];
        return hits & hits << 1U & hits >> 1U;
    };
    TileBits amid{};
    for (std::size_t row = 1; row + 1 < static_cast<std::size_t>(tile.rows); ++row) {
        if (wanted[row] != 0)
            amid[row] = wanted[row] & three(row - 1) & three(row) & three(row + 1);
    }
    return amid;
}

void add_calm(const LitLayer& layer, const Tile& tile, const TileBits& wanted, TileBits& calm) {
    const TileBits asked = amid_hits(layer, tile, wanted);
    // Row by row: the asked pixels that look like both of their neighbours.
    TileBits beside{};
    TileBits left{};
    for (std::size_t row = 0; row < tile_size; ++row) {
        if (asked[row] == 0) continue;
        beside[row] = like_beside(layer, row, asked[row]);
        left[row] = asked[row] & beside[row];
    }
    // Around those: the pixels that do, and those that look like the ones below.
    TileBits below{};
    for (std::size_t row = 0; row < static_cast<std::size_t>(tile.rows); ++row) {
        const std::uint64_t next = row + 1 < tile_size ? left[row + 1] : 0;
        const std::uint64_t around = (next | (row > 0 ? left[row - 1] : 0)) & ~asked[row];
        if (around != 0) beside[row] |= around & like_beside(layer, row, around);
        if ((left[row] | next) != 0) below[row] = like_below(layer, row, left[row] | next);
    }
    for (std::size_t row = 1; row + 1 < static_cast<std::size_t>(tile.rows); ++row) {
        if (left[row] != 0)
            calm[row] |=
                left[row] & beside[row - 1] & beside[row + 1] & below[row - 1] & below[row];
    }
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
