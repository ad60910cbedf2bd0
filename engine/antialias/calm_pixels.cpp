#include "engine/antialias/mixed_pixels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/antialias/calm_pixels.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/real/lanes-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// How much channels of pixels that look the same may differ; 1 is the brightest that is shown.
inline constexpr float most_difference = 4.0F / 255.0F;

/// Columns that are compared at once.
inline constexpr std::size_t block = 8;
constexpr hn::CappedTag<float, block> in_block{};

/// Which of a block's width of pixels from a and b on look the same, pixel by pixel.
HWY_INLINE std::uint64_t alike(const LitLayer& layer, std::size_t a, std::size_t b) {
    const auto most = hn::Set(in_block, 2.0F * most_difference * most_difference);
    std::uint64_t same = 0;
    for (std::size_t i = 0; i < block; i += hn::MaxLanes(in_block)) {
        const auto light = [&](std::size_t at, int channel) {
            const float* const row = layer.light_row(static_cast<int>(at / tile_size), channel);
            return hn::LoadU(in_block, row + at % tile_size + i);
        };
        auto near = hn::FirstN(in_block, block);
        for (int channel = 0; channel < 3; ++channel) {
            const auto p = light(a, channel);
            const auto q = light(b, channel);
            // Compare by gamma 2, as shown: the difference is (p - q) / (sqrt p + sqrt q).
            const auto change = hn::Sub(p, q);
            near = hn::And(near, hn::Le(hn::Mul(change, change), hn::Mul(most, hn::Add(p, q))));
        }
        same |= std::uint64_t{bits_of(in_block, near)} << i;
    }
    return same;
}

/// Which of the wanted pixels of a row look like those to the right; of others it tells nothing.
std::uint64_t like_right(const LitLayer& layer, std::size_t row, std::uint64_t wanted) {
    std::uint64_t same = 0;
    for (std::size_t col = 0; col < tile_size; col += block) {
        if ((wanted >> col & 0xFFU) == 0) continue;
        // The row's last pixel has none to the right.
        const std::size_t first = std::min(col, tile_size - block - 1);
        const std::size_t at = row * tile_size + first;
        same |= alike(layer, at, at + 1) << first;
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
        same |= alike(layer, at, at + tile_size) << col;
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

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(add_calm);

}  // namespace

TileBits calm_pixels(const Tile& tile, std::span<const LitLayer> layers, const TileBits& wanted) {
    TileBits calm{};
    for (const LitLayer& layer : layers) {
        // A translucent pixel may look calm while what is behind it changes.
        if (layer.cover.empty()) HWY_DYNAMIC_DISPATCH(add_calm)(layer, tile, wanted, calm);
    }
    return calm;
}

}  // namespace zeroset

#endif
