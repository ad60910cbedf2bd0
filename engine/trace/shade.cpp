#include "engine/trace/shade.hpp"

#include "engine/trace/bit_bytes.hpp"
#include "engine/trace/caps.hpp"
#include "engine/trace/palette.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/shade.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
constexpr D d;

struct V3 {
    V x, y, z;
};

HWY_INLINE V3 splat(const glm::dvec3& v) {
    return {hn::Set(d, static_cast<float>(v.x)), hn::Set(d, static_cast<float>(v.y)),
            hn::Set(d, static_cast<float>(v.z))};
}

HWY_INLINE V dot(const V3& a, const V3& b) {
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

HWY_INLINE V3 scaled(const V3& a, V s) {
    return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}

/// 1 / sqrt(x) to float's last digits but one.
HWY_INLINE V per_root(V x) {
    const V guess = hn::ApproximateReciprocalSqrt(x);
    const V half = hn::Mul(hn::Mul(x, guess), hn::Set(d, 0.5F));
    return hn::Mul(guess, hn::NegMulAdd(half, guess, hn::Set(d, 1.5F)));
}

/// A direction as a vector times a number: its length is 1.
struct Direction {
    V3 along;
    V scale;
};

/// Whether x is neither so small nor so large that its digits are lost.
HWY_INLINE hn::Mask<D> is_moderate(V x) {
    return hn::And(hn::Gt(x, hn::Set(d, 1e-30F)), hn::Lt(x, hn::Set(d, 1e30F)));
}

/// Of `a`, or `otherwise` where a is 0, too large or not a number.
HWY_INLINE Direction direction_of(const V3& a, const Direction& otherwise) {
    const V square = dot(a, a);
    if (hn::AllTrue(d, is_moderate(square))) return {a, per_root(square)};
    // Scaled by the largest component first, so that squares neither overflow nor vanish.
    const V size = hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
    const auto usable = hn::And(hn::Gt(size, hn::Set(d, 1e-37F)), hn::Lt(size, hn::Set(d, 1e37F)));
    const V3 b = scaled(a, hn::Div(hn::Set(d, 1.0F), size));
    const auto pick = [&](V usual, V rare) { return hn::IfThenElse(usable, usual, rare); };
    const V3& c = otherwise.along;
    return {{pick(b.x, c.x), pick(b.y, c.y), pick(b.z, c.z)},
            pick(per_root(dot(b, b)), otherwise.scale)};
}

/// A channel of the picture, 0 to 255, from linear light; gamma 2. In upward rounding.
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> encoded(V light) {
    const hn::RebindToUnsigned<D> du;
    const V within = hn::Min(hn::Max(light, hn::Set(d, 1e-12F)), hn::Set(d, 1.0F));
    const V value = hn::Mul(within, per_root(within));
    // Whole numbers are the last bits of floats of this size.
    const V last_bits = hn::Set(d, 0x1.8p23F);
    const V number = hn::Add(hn::MulAdd(value, hn::Set(d, 255.0F), hn::Set(d, -0.5F)), last_bits);
    return hn::And(hn::BitCast(du, number), hn::Set(du, 0xFFU));
}

/// What all pixels of a surface share, in all lanes: the lights, which move with the camera, and
/// the colours of its two sides.
struct Shading {
    V3 key, fill, up;
    V front[3], back[3];

    Shading(const ViewFrame& view, const SurfaceColors& colors)
        : key(splat(key_light(view))),
          fill(splat(glm::normalize(0.8 * view.right - 0.1 * view.up - 0.45 * view.forward))),
          up(splat(view.up)) {
        for (int channel = 0; channel < 3; ++channel) {
            front[channel] = hn::Set(d, colors.front[channel]);
            back[channel] = hn::Set(d, colors.back[channel]);
        }
    }
};

/// What falls on the pixels of a row of a tile, in all its vectors.
struct Light {
    alignas(64) float diffuse[tile_size];
    alignas(64) float gloss[tile_size];   ///< of the highlight, before it is sharpened
    alignas(64) float facing[tile_size];  ///< at least 0: the front is seen
};

/// The light on hits from their rays and gradients, to the pixels from `col` on; `lit`: how much of
/// the key light.
HWY_INLINE void illuminate(const Shading& shading, const V3& along, const V3& gradient, V lit,
                           std::size_t col, Light& light) {
    const V zero = hn::Zero(d);
    const V half = hn::Set(d, 0.5F);
    const V two = hn::Set(d, 2.0F);
    const V towards_viewer = hn::Neg(per_root(dot(along, along)));
    const Direction outward = direction_of(gradient, {along, towards_viewer});
    const V facing = hn::Mul(dot(outward.along, along), towards_viewer);
    const V to_side = hn::CopySign(outward.scale, facing);
    const V to_key = hn::Mul(dot(outward.along, shading.key), to_side);
    const V to_fill = hn::Mul(dot(outward.along, shading.fill), to_side);
    const V to_sky = hn::Mul(dot(outward.along, shading.up), to_side);
    const V to_viewer = hn::Mul(hn::Abs(facing), outward.scale);
    const V key_light = hn::Mul(hn::Max(to_key, zero), lit);
    const V fill_light = hn::Max(to_fill, zero);
    const V sky = hn::MulAdd(to_sky, half, half);
    const V diffuse = hn::MulAdd(key_light, hn::Set(d, 0.85F),
                                 hn::MulAdd(fill_light, hn::Set(d, 0.26F),
                                            hn::MulAdd(sky, hn::Set(d, 0.16F), hn::Set(d, 0.10F))));
    // Of the normal and the direction halfway between light and viewer, unit vectors; their sum
    // may vanish.
    const V key_to_viewer = hn::Mul(dot(shading.key, along), towards_viewer);
    const V square = hn::Max(hn::MulAdd(key_to_viewer, two, two), hn::Set(d, 1e-6F));
    const V gloss =
        hn::Mul(hn::Max(hn::Mul(hn::Add(to_key, to_viewer), per_root(square)), zero), lit);
    hn::Store(diffuse, d, &light.diffuse[col]);
    hn::Store(gloss, d, &light.gloss[col]);
    hn::Store(facing, d, &light.facing[col]);
}

/// The reflectances of pixels by the side of the surface that is seen.
struct BySide {
    const Shading& shading;

    HWY_INLINE V at(int channel, V facing, std::size_t /*pixel*/) const {
        const auto front = hn::Ge(facing, hn::Zero(d));
        return hn::IfThenElse(front, shading.front[channel], shading.back[channel]);
    }
};

/// The reflectances that each pixel has of its own.
struct ByPixel {
    const TileHits& hits;

    HWY_INLINE V at(int channel, V /*facing*/, std::size_t pixel) const {
        return hn::LoadU(d, &hits.reflectance[static_cast<std::size_t>(channel)][pixel]);
    }
};

/// The colours of the pixels from `col` on, which are those from `pixel` on in the tile.
template <class Paint>
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> colored(const Paint& paint, const Light& light,
                                                    std::size_t col, std::size_t pixel) {
    const hn::RebindToUnsigned<D> du;
    const V diffuse = hn::Load(d, &light.diffuse[col]);
    V gloss = hn::Load(d, &light.gloss[col]);
    for (int doubling = 0; doubling < 5; ++doubling)
        gloss = hn::Mul(gloss, gloss);
    const V specular = hn::Mul(gloss, hn::Set(d, 0.22F));
    const V facing = hn::Load(d, &light.facing[col]);
    auto color = hn::Set(du, 0xFF000000U);
    for (int channel = 0; channel < 3; ++channel) {
        const V albedo = paint.at(channel, facing, pixel);
        const auto value = encoded(hn::MulAdd(albedo, diffuse, specular));
        color = hn::Or(color, hn::ShiftLeftSame(value, 8 * channel));
    }
    return color;
}

/// A row of a tile in the picture.
struct Row {
    std::size_t first;         ///< pixel of the picture
    std::size_t count;         ///< of pixels
    std::uint32_t background;  ///< its colour
};

Row row_of(const Tile& tile, int row, const Canvas& out) {
    return {out.index(tile.col, tile.row + row), static_cast<std::size_t>(tile.cols),
            background_color(tile.row + row, out.height)};
}

/// A bit for each pixel of a row of a tile, the first one lowest.
using RowBits = std::uint64_t;
static_assert(tile_size == 64);

RowBits first_bits(std::size_t count) { return ~RowBits{0} >> (tile_size - count); }

/// Misses, in a picture that holds nothing yet.
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

    RowTarget target() { return {color, depth, certificate, surface}; }
    /// The first `count` pixels.
    void copy(std::size_t first, std::size_t count, Framebuffer& out) const {
        std::copy_n(color, count, &out.color[first]);
        std::copy_n(depth, count, &out.depth[first]);
        std::copy_n(certificate, count, &out.certificate[first]);
        std::copy_n(surface, count, &out.surface[first]);
    }
    /// Those whose bits are set.
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
    for (std::size_t col = 0; col < tile_size; col += hn::MaxLanes(d)) {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, hn::Lt(hn::LoadU(d, depths + col), hn::Inf(d)), bytes);
        bits |= (bytes[0] | static_cast<RowBits>(bytes[1]) << 8U) << col;
    }
    return bits & first_bits(count);
}

/// Those of a vector.
RowBits bits_at(RowBits bits, std::size_t col) { return bits >> col & first_bits(hn::MaxLanes(d)); }

/// Lights the hits of a row.
void illuminate_row(const TraceFrame& frame, const Shading& shading, const Tile& tile, int row,
                    RowBits hit, const TileHits& hits, Light& light) {
    const double size = frame.view.pixel_size(frame.height);
    const V3 start = splat(
        frame.view.direction(tile.col + 0.5, tile.row + row + 0.5, frame.width, frame.height));
    const V3 step = splat(frame.view.parallel() ? glm::dvec3(0.0) : size * frame.view.right);
    for (std::size_t col = 0; col < tile_size; col += hn::MaxLanes(d)) {
        if (bits_at(hit, col) == 0) continue;
        const std::size_t at = static_cast<std::size_t>(row) * tile_size + col;
        const V along = hn::Iota(d, static_cast<float>(col));
        const V3 ray{hn::MulAdd(along, step.x, start.x), hn::MulAdd(along, step.y, start.y),
                     hn::MulAdd(along, step.z, start.z)};
        const V3 gradient{hn::LoadU(d, &hits.gradient[0][at]), hn::LoadU(d, &hits.gradient[1][at]),
                          hn::LoadU(d, &hits.gradient[2][at])};
        const V lit = hits.any_dark ? hn::LoadU(d, &hits.lit[at]) : hn::Set(d, 1.0F);
        illuminate(shading, ray, gradient, lit, col, light);
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
    const hn::RebindToUnsigned<D> du;
    for (std::size_t col = 0; col < tile_size; col += hn::MaxLanes(d)) {
        const std::size_t at = static_cast<std::size_t>(row) * tile_size + col;
        const V depth = hn::LoadU(d, &hits.depth[at]);
        auto color = hn::Set(du, background);
        if (bits_at(hit, col) != 0) {
            const auto is_hit = hn::RebindMask(du, hn::Lt(depth, hn::Inf(d)));
            color = hn::IfThenElse(is_hit, colored(paint, light, col, at), color);
        }
        hn::StoreU(color, du, to.color + col);
        hn::StoreU(depth, d, to.depth + col);
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
                                                                   : colors_of(surface)) {}

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
    Light light_;
    RowPixels aside_;
};

void HitShader::draw_row(bool fresh, int row, RowBits hit, const Row& to, const Canvas& out) {
    if (out.blank_rows != nullptr) *out.blank_rows &= ~(RowBits{1} << row);
    Framebuffer& pixels = out.pixels;
    if (fresh && to.count == tile_size) {
        return make_row(row, hit, to.background,
                        {&pixels.color[to.first], &pixels.depth[to.first],
                         &pixels.certificate[to.first], &pixels.surface[to.first]});
    }
    make_row(row, hit, to.background, aside_.target());
    if (fresh) {
        aside_.copy(to.first, to.count, pixels);
    } else {
        aside_.copy_some(to.first, hit, pixels);
    }
}

void HitShader::make_row(int row, RowBits hit, std::uint32_t background, const RowTarget& to) {
    illuminate_row(frame_, shading_, tile_, row, hit, hits_, light_);
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
