#include "engine/light/shade.hpp"

#include "engine/scene/palette.hpp"
#include "engine/trace/caps.hpp"
#include "engine/trace/simd/bit_bytes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/light/shade.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/light/shade_light-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A row of a tile in the picture.
struct Row {
    std::size_t first;         ///< pixel of the picture
    std::size_t count;         ///< of pixels
    std::uint32_t background;  ///< its colour
};

Row row_of(const Tile& tile, int row, const Canvas& out) {
    return {.first = out.index(tile.col, tile.row + row),
            .count = static_cast<std::size_t>(tile.cols),
            .background = background_color(tile.row + row, out.height)};
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

/// Which pixels of a row are hits.
RowBits hits_of(const float* depths, std::size_t count) {
    RowBits bits = 0;
    for (std::size_t col = 0; col < tile_size; col += lanes<float>) {
        const auto is_hit = hn::Lt(hn::LoadU(d<float>, depths + col), hn::Inf(d<float>));
        bits |= RowBits{bits_of(d<float>, is_hit)} << col;
    }
    return bits & first_bits(count);
}

/// The bits of a vector's pixels, from `col` on.
RowBits bits_at(RowBits bits, std::size_t col) { return bits >> col & first_bits(lanes<float>); }

/// The directions of a tile's rays, not of length 1.
struct RayDirections {
    glm::dvec3 first, by_row, key;
    V3 by_col;
    V<float> key_by_col;

    RayDirections(const TraceFrame& frame, const Tile& tile, const glm::dvec3& key_light)
        : first(frame.view.direction(tile.col + 0.5, tile.row + 0.5, frame.width, frame.height)),
          key(key_light) {
        const double size = frame.view.parallel() ? 0.0 : frame.view.pixel_size(frame.height);
        by_row = -size * frame.view.up;
        by_col = splat(size * frame.view.right);
        key_by_col = hn::Set(d<float>, static_cast<float>(size * glm::dot(key, frame.view.right)));
    }
};

/// Lights the hits of a row.
void illuminate_row(const RayDirections& rays, const Shading& shading, int row, RowBits hit,
                    const TileHits& hits, Light& light) {
    const glm::dvec3 first = rays.first + static_cast<double>(row) * rays.by_row;
    const V3 start = splat(first);
    const V3& step = rays.by_col;
    const V<float> key_start = hn::Set(d<float>, static_cast<float>(glm::dot(rays.key, first)));
    for (std::size_t col = 0; col < tile_size; col += lanes<float>) {
        const RowBits bits = bits_at(hit, col);
        if (bits == 0) continue;
        const std::size_t at = static_cast<std::size_t>(row) * tile_size + col;
        const V<float> along = hn::Iota(d<float>, static_cast<float>(col));
        const Lit lit{
            .along = {.x = hn::MulAdd(along, step.x, start.x),
                      .y = hn::MulAdd(along, step.y, start.y),
                      .z = hn::MulAdd(along, step.z, start.z)},
            .along_to_key = hn::MulAdd(along, rays.key_by_col, key_start),
            .gradient = {.x = hn::LoadU(d<float>, &hits.gradient[0][at]),
                         .y = hn::LoadU(d<float>, &hits.gradient[1][at]),
                         .z = hn::LoadU(d<float>, &hits.gradient[2][at])},
            .lit = hits.any_dark ? hn::LoadU(d<float>, &hits.lit[at]) : hn::Set(d<float>, 1.0F),
            .is_hit = mask_of(d<float>, static_cast<LaneBits>(bits))};
        illuminate(shading, lit, col, light);
    }
}

/// Caps are darker than the skin, hatched and without highlights.
void tone_caps(const TraceFrame& frame, const Tile& tile, int row, const TileHits& hits,
               Light& light) {
    for (int col = 0; col < tile.cols; ++col) {
        const auto at = static_cast<std::size_t>(row * tile_size + col);
        if (hits.cap[at] == 0) continue;
        const glm::dvec3 normal(hits.gradient[0][at], hits.gradient[1][at], hits.gradient[2][at]);
        const glm::dvec3 point =
            frame.view.point(tile.col + col + 0.5, tile.row + row + 0.5, frame.width, frame.height,
                             static_cast<double>(hits.depth[at]));
        const auto pixel = static_cast<std::size_t>(col);
        light.diffuse[pixel] *= cap_tone(frame.view, frame.height, point, normal);
        light.gloss[pixel] = 0.0F;
    }
}

/// The colours and depths of a row. `paint`: BySide or ByPixel.
template <class Paint>
void color_row(const Paint& paint, std::uint32_t background, int row, RowBits hit,
               const TileHits& hits, const Light& light, const RowTarget& to) {
    for (std::size_t col = 0; col < tile_size; col += lanes<float>) {
        const std::size_t at = static_cast<std::size_t>(row) * tile_size + col;
        const V<float> depth = hn::LoadU(d<float>, &hits.depth[at]);
        auto color = hn::Set(du<float>, background);
        if (bits_at(hit, col) != 0) {
            const auto is_hit = hn::RebindMask(du<float>, hn::Lt(depth, hn::Inf(d<float>)));
            color = hn::IfThenElse(is_hit, colored(paint, light, col, at), color);
        }
        hn::StoreU(color, du<float>, to.color + col);
        hn::StoreU(depth, d<float>, to.depth + col);
    }
}

/// Draws the hits of one surface; into pictures that hold nothing yet its misses, too.
class HitShader {
public:
    HitShader(const TraceFrame& frame, std::uint8_t surface, const Tile& tile, const TileHits& hits)
        : frame_(frame),
          surface_(surface),
          tile_(tile),
          hits_(hits),
          shading_(frame.view, surface < frame.scene.colors.size() ? frame.scene.colors[surface]
                                                                   : colors_of(surface)),
          rays_(frame, tile, shading_.key) {}

    void draw(bool fresh, const Canvas& out) {
        for (int row = 0; row < tile_.rows; ++row) {
            const Row to = row_of(tile_, row, out);
            const RowBits hit = hits_of(&hits_.depth[first_of(row)], to.count);
            if (hit != 0) {
                draw_row(fresh, row, hit, to, out);
            } else if (fresh) {
                clear_row(to, row, out);
            }
        }
    }

private:
    static std::size_t first_of(int row) { return static_cast<std::size_t>(row) * tile_size; }
    void draw_row(bool fresh, int row, RowBits hit, const Row& to, const Canvas& out);
    void make_row(int row, RowBits hit, std::uint32_t background, const RowTarget& to);

    const TraceFrame& frame_;
    std::uint8_t surface_;
    const Tile& tile_;
    const TileHits& hits_;
    Shading shading_;
    RayDirections rays_;
    Light light_;
    RowPixels aside_;
};

void HitShader::draw_row(bool fresh, int row, RowBits hit, const Row& to, const Canvas& out) {
    if (out.blank_rows != nullptr) *out.blank_rows &= ~(RowBits{1} << row);
    Framebuffer& pixels = out.pixels;
    if (fresh && to.count == tile_size) {
        return make_row(row, hit, to.background,
                        {.color = &pixels.color[to.first],
                         .depth = &pixels.depth[to.first],
                         .certificate = &pixels.certificate[to.first],
                         .surface = &pixels.surface[to.first]});
    }
    make_row(row, hit, to.background, aside_.target());
    if (fresh) {
        aside_.copy(to.first, to.count, pixels);
    } else {
        aside_.copy_some(to.first, hit, pixels);
    }
}

void HitShader::make_row(int row, RowBits hit, std::uint32_t background, const RowTarget& to) {
    illuminate_row(rays_, shading_, row, hit, hits_, light_);
    if (hits_.any_cap) tone_caps(frame_, tile_, row, hits_, light_);
    if (hits_.reflectance[0].empty()) {
        color_row(BySide{shading_}, background, row, hit, hits_, light_, to);
    } else {
        color_row(ByPixel{hits_}, background, row, hit, hits_, light_, to);
    }
    write_facts(hit, &hits_.certificate[first_of(row)], surface_, to);
}

void shade_hits(const TraceFrame& frame, std::uint8_t surface, bool fresh, const Tile& tile,
                const TileHits& hits, const Canvas& out) {
    HitShader(frame, surface, tile, hits).draw(fresh, out);
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
HWY_EXPORT(shade_hits);

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

glm::dvec3 key_light(const ViewFrame& view) {
    return glm::normalize(-0.45 * view.right + 0.65 * view.up - 0.75 * view.forward);
}

std::uint32_t background_color(int row, int height) {
    const double t = (row + 0.5) / height;
    const auto mixed = [t](double top, double bottom) {
        return static_cast<std::uint32_t>(top + t * (bottom - top));
    };
    return 0xFF000000U | mixed(58, 24) << 16U | mixed(50, 20) << 8U | mixed(44, 18);
}

void draw_tile(std::span<const TraceFrame> surfaces, std::span<const TileHits> hits,
               const Tile& tile, const Canvas& out) {
    bool fresh = true;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (!hits[i].any) continue;
        HWY_DYNAMIC_DISPATCH(shade_hits)
        (surfaces[i], static_cast<std::uint8_t>(i), fresh, tile, hits[i], out);
        fresh = false;
    }
    if (fresh) HWY_DYNAMIC_DISPATCH(clear_rows)(tile, out);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (!hits[i].any_unsettled) continue;
        if (out.blank_rows != nullptr) *out.blank_rows = 0;
        mark_unsettled(tile, hits[i], out);
    }
}

}  // namespace zeroset

#endif
