#include "engine/light/encode.hpp"

#include "engine/image/background.hpp"
#include "engine/trace/simd/bit_bytes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/light/encode.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/real/lanes-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A channel of the picture, 0 to 255, from linear light; gamma 2. In upward rounding.
HWY_INLINE hn::Vec<hn::RebindToUnsigned<Tag<float>>> encoded(V<float> light) {
    const V<float> within =
        hn::Min(hn::Max(light, hn::Set(d<float>, 1e-12F)), hn::Set(d<float>, 1.0F));
    const V<float> guess = hn::ApproximateReciprocalSqrt(within);
    const V<float> root = hn::Mul(within, guess);
    const V<float> twice = hn::Mul(root, hn::NegMulAdd(root, guess, hn::Set(d<float>, 3.0F)));
    // Whole numbers are the last bits of floats of this size.
    const V<float> last_bits = hn::Set(d<float>, 0x1.8p23F);
    const V<float> number =
        hn::Add(hn::MulAdd(twice, hn::Set(d<float>, 127.5F), hn::Set(d<float>, -0.5F)), last_bits);
    return hn::And(hn::BitCast(du<float>, number), hn::Set(du<float>, 0xFFU));
}

/// A row of a tile in the picture.
struct Row {
    std::size_t first;         ///< pixel of the picture
    std::size_t count;         ///< of pixels
    std::uint32_t background;  ///< its colour
};

Row row_of(const Tile& tile, int row, const Canvas& out) {
    return {.first = out.index(tile.col, tile.row + row),
            .count = static_cast<std::size_t>(tile.cols),
            .background = background_color(out.pixels.background, tile.row + row, out.height)};
}

/// A bit for each pixel of a row of a tile, the first one lowest.
using RowBits = std::uint64_t;
static_assert(tile_size == 64);

RowBits first_bits(std::size_t count) { return ~RowBits{0} >> (tile_size - count); }

/// Writes misses into a picture that holds nothing yet.
void clear_row(const Row& to, int row, const Canvas& canvas) {
    const RowBits bit = RowBits{1} << row;
    if (canvas.blank_rows != nullptr && (*canvas.blank_rows & bit) != 0) return;
    if (canvas.blank_rows != nullptr) *canvas.blank_rows |= bit;
    Framebuffer& out = canvas.pixels;
    std::fill_n(&out.color[to.first], to.count, to.background);
    std::fill_n(&out.depth[to.first], to.count, std::numeric_limits<float>::infinity());
    std::memset(&out.certificate[to.first], static_cast<int>(Certificate::Miss), to.count);
    std::memset(&out.surface[to.first], no_surface, to.count);
}

/// Where a row of a tile goes, all tile_size pixels of it.
struct RowTarget {
    std::uint32_t* color;
    float* depth;
    Certificate* certificate;
    std::uint8_t* surface;
};

/// A row of a tile beside the picture.
struct RowPixels {
    alignas(64) std::uint32_t color[tile_size];
    alignas(64) float depth[tile_size];
    alignas(64) Certificate certificate[tile_size];
    alignas(64) std::uint8_t surface[tile_size];

    RowTarget target() {
        return {.color = color, .depth = depth, .certificate = certificate, .surface = surface};
    }
    /// Copies the first `count` pixels.
    void copy(std::size_t first, std::size_t count, Framebuffer& out) const {
        std::copy_n(color, count, &out.color[first]);
        std::copy_n(depth, count, &out.depth[first]);
        std::copy_n(certificate, count, &out.certificate[first]);
        std::copy_n(surface, count, &out.surface[first]);
    }
    /// Copies the pixels whose bits are set.
    void copy_some(std::size_t first, RowBits bits, Framebuffer& out) const {
        for (; bits != 0; bits &= bits - 1) {
            const auto col = static_cast<std::size_t>(std::countr_zero(bits));
            out.color[first + col] = color[col];
            out.depth[first + col] = depth[col];
            out.certificate[first + col] = certificate[col];
            out.surface[first + col] = surface[col];
        }
    }
};

/// The certificates and surfaces of a row; `known`: the hits' certificates.
void write_facts(RowBits hit, const Certificate* known, std::uint8_t surface, const RowTarget& to) {
    if (hit == ~RowBits{0}) {
        std::memcpy(to.certificate, known, tile_size);
        std::memset(to.surface, surface, tile_size);
        return;
    }
    constexpr std::uint64_t every = 0x0101010101010101U;
    constexpr auto miss = static_cast<std::uint64_t>(Certificate::Miss) * every;
    for (std::size_t col = 0; col < tile_size; col += 8) {
        const std::uint64_t bytes = bytes_of_bits(hit >> col & 0xFFU);
        std::uint64_t eight = 0;
        std::memcpy(&eight, known + col, 8);
        eight = (eight & bytes) | (miss & ~bytes);
        std::memcpy(to.certificate + col, &eight, 8);
        eight = (surface * every & bytes) | (no_surface * every & ~bytes);
        std::memcpy(to.surface + col, &eight, 8);
    }
}

/// The alpha of hits from `pixel` on: at least 1, or they would be taken for misses.
HWY_INLINE hn::Vec<decltype(du<float>)> alpha_of(const LitLayer& layer, std::size_t pixel) {
    if (layer.cover.empty()) return hn::Set(du<float>, 0xFF000000U);
    const V<float> cover = hn::LoadU(d<float>, &layer.cover[pixel]);
    const V<float> part = hn::Mul(cover, hn::Set(d<float>, 255.0F));
    const V<float> alpha =
        hn::Max(hn::Min(part, hn::Set(d<float>, 255.0F)), hn::Set(d<float>, 1.0F));
    return hn::ShiftLeft<24>(hn::BitCast(du<float>, hn::NearestInt(alpha)));
}

/// Encodes the light of hits, and copies their depths.
void encode_row(const LitLayer& layer, int row, std::uint32_t background, const RowTarget& to) {
    const float* const depths = &layer.hits->depth[static_cast<std::size_t>(row) * tile_size];
    const RowBits hit = layer.hit_rows[static_cast<std::size_t>(row)];
    for (std::size_t col = 0; col < tile_size; col += lanes<float>) {
        auto color = hn::Set(du<float>, background);
        const auto bits = static_cast<LaneBits>(hit >> col & first_bits(lanes<float>));
        if (bits != 0) {
            auto lit = alpha_of(layer, static_cast<std::size_t>(row) * tile_size + col);
            for (int channel = 0; channel < 3; ++channel) {
                const V<float> light = hn::LoadU(d<float>, layer.light_row(row, channel) + col);
                lit = hn::Or(lit, hn::ShiftLeftSame(encoded(light), 8 * channel));
            }
            color = hn::IfThenElse(mask_of(du<float>, bits), lit, color);
        }
        hn::StoreU(color, du<float>, to.color + col);
        hn::StoreU(hn::LoadU(d<float>, depths + col), d<float>, to.depth + col);
    }
}

void make_row(const LitLayer& layer, int row, std::uint32_t background, const RowTarget& to) {
    encode_row(layer, row, background, to);
    const auto at = static_cast<std::size_t>(row);
    write_facts(layer.hit_rows[at], &layer.hits->certificate[at * tile_size], layer.surface, to);
}

/// Draws a row that has hits.
void draw_row(const LitLayer& layer, bool fresh, int row, const Row& to, const Canvas& out) {
    if (out.blank_rows != nullptr) *out.blank_rows &= ~(RowBits{1} << row);
    Framebuffer& pixels = out.pixels;
    if (fresh && to.count == tile_size) {
        return make_row(layer, row, to.background,
                        {.color = &pixels.color[to.first],
                         .depth = &pixels.depth[to.first],
                         .certificate = &pixels.certificate[to.first],
                         .surface = &pixels.surface[to.first]});
    }
    RowPixels aside;
    make_row(layer, row, to.background, aside.target());
    if (fresh) {
        aside.copy(to.first, to.count, pixels);
    } else {
        aside.copy_some(to.first, layer.hit_rows[static_cast<std::size_t>(row)], pixels);
    }
}

/// Draws the hits of a layer; into pictures that hold nothing yet its misses, too.
void draw_layer(const LitLayer& layer, bool fresh, const Tile& tile, const Canvas& out) {
    for (int row = 0; row < tile.rows; ++row) {
        const Row to = row_of(tile, row, out);
        if (layer.hit_rows[static_cast<std::size_t>(row)] != 0) {
            draw_row(layer, fresh, row, to, out);
        } else if (fresh) {
            clear_row(to, row, out);
        }
    }
}

void clear_rows(const Tile& tile, const Canvas& out) {
    const bool blank = out.blank_rows != nullptr &&
                       *out.blank_rows == first_bits(static_cast<std::size_t>(tile.rows));
    for (int row = 0; row < tile.rows && !blank; ++row)
        clear_row(row_of(tile, row, out), row, out);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(clear_rows);
HWY_EXPORT(draw_layer);

/// Undecided where a ray is unsettled on pixels that are still misses.
void mark_unsettled(const Tile& tile, const TileHits& hits, const Canvas& out) {
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col) {
            const auto at = static_cast<std::size_t>(row * tile_size + col);
            Certificate& certificate =
                out.pixels.certificate[out.index(tile.col + col, tile.row + row)];
            const bool unsettled = hits.unsettled[at] < std::numeric_limits<float>::infinity();
            if (unsettled && certificate == Certificate::Miss) {
                certificate = Certificate::Undecided;
            }
        }
    }
}

}  // namespace

void encode_tile(const Tile& tile, std::span<const TileHits> hits, const LitTile& lit,
                 const Canvas& out) {
    bool fresh = true;
    for (const LitLayer& layer : lit.layers()) {
        HWY_DYNAMIC_DISPATCH(draw_layer)(layer, fresh, tile, out);
        fresh = false;
    }
    if (fresh) HWY_DYNAMIC_DISPATCH(clear_rows)(tile, out);
    for (const TileHits& of_surface : hits) {
        if (!of_surface.any_unsettled) continue;
        if (out.blank_rows != nullptr) *out.blank_rows = 0;
        mark_unsettled(tile, of_surface, out);
    }
}

}  // namespace zeroset

#endif
