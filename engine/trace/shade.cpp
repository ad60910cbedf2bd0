#include "engine/trace/shade.hpp"

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

/// Misses: `count` pixels from `pixel` on.
HWY_INLINE void clear_pixels(std::size_t pixel, std::size_t count, std::uint32_t background,
                             Framebuffer& out) {
    std::fill_n(&out.color[pixel], count, background);
    std::fill_n(&out.depth[pixel], count, std::numeric_limits<float>::infinity());
    std::memset(&out.certificate[pixel], static_cast<int>(Certificate::Miss), count);
    std::memset(&out.surface[pixel], no_surface, count);
}

/// Writes the pixels of a vector whose bits are set.
HWY_INLINE void write_some(const hn::Vec<hn::RebindToUnsigned<D>>& color, V depth,
                           const Certificate* known, std::uint8_t surface, unsigned bits,
                           std::size_t pixel, Framebuffer& out) {
    constexpr std::size_t lanes = hn::MaxLanes(d);
    alignas(64) std::uint32_t colors[lanes];
    alignas(64) float depths[lanes];
    hn::Store(color, hn::RebindToUnsigned<D>(), colors);
    hn::Store(depth, d, depths);
    for (; bits != 0; bits &= bits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        out.color[pixel + lane] = colors[lane];
        out.depth[pixel + lane] = depths[lane];
        out.certificate[pixel + lane] = known[lane];
        out.surface[pixel + lane] = surface;
    }
}

/// Lights the hits of a row; whether there are any.
bool illuminate_row(const TraceFrame& frame, const Shading& shading, const Tile& tile, int row,
                    const TileHits& hits, Light& light) {
    const double size = frame.view.pixel_size(frame.height);
    const V3 start = splat(
        frame.view.direction(tile.col + 0.5, tile.row + row + 0.5, frame.width, frame.height));
    const V3 step = splat(frame.view.parallel() ? glm::dvec3(0.0) : size * frame.view.right);
    bool any = false;
    for (std::size_t col = 0; col < tile_size; col += hn::MaxLanes(d)) {
        const std::size_t at = static_cast<std::size_t>(row) * tile_size + col;
        if (hn::AllFalse(d, hn::Lt(hn::LoadU(d, &hits.depth[at]), hn::Inf(d)))) continue;
        any = true;
        const V along = hn::Iota(d, static_cast<float>(col));
        const V3 ray{hn::MulAdd(along, step.x, start.x), hn::MulAdd(along, step.y, start.y),
                     hn::MulAdd(along, step.z, start.z)};
        const V3 gradient{hn::LoadU(d, &hits.gradient[0][at]), hn::LoadU(d, &hits.gradient[1][at]),
                          hn::LoadU(d, &hits.gradient[2][at])};
        const V lit = hits.any_dark ? hn::LoadU(d, &hits.lit[at]) : hn::Set(d, 1.0F);
        illuminate(shading, ray, gradient, lit, col, light);
    }
    return any;
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

/// `paint`: BySide or ByPixel. `fresh`: the picture holds nothing yet, so that misses are to be
/// written, too.
template <class Paint>
void shade_row(const Paint& paint, std::uint8_t surface, bool fresh, const Row& to, int row,
               const TileHits& hits, const Light& light, Framebuffer& out) {
    constexpr std::size_t lanes = hn::MaxLanes(d);
    for (std::size_t col = 0; col < to.count; col += lanes) {
        const std::size_t at = static_cast<std::size_t>(row) * tile_size + col;
        const std::size_t pixel = to.first + col;
        const V depth = hn::LoadU(d, &hits.depth[at]);
        const auto hit = hn::And(hn::Lt(depth, hn::Inf(d)), hn::FirstN(d, to.count - col));
        const bool all = hn::AllTrue(d, hit);
        if (fresh && !all) clear_pixels(pixel, std::min(lanes, to.count - col), to.background, out);
        if (!all && hn::AllFalse(d, hit)) continue;
        const auto color = colored(paint, light, col, at);
        if (all) {
            hn::StoreU(color, hn::RebindToUnsigned<D>(), &out.color[pixel]);
            hn::StoreU(depth, d, &out.depth[pixel]);
            std::memcpy(&out.certificate[pixel], &hits.certificate[at], lanes);
            std::memset(&out.surface[pixel], surface, lanes);
        } else {
            std::uint8_t bytes[8] = {};
            hn::StoreMaskBits(d, hit, bytes);
            write_some(color, depth, &hits.certificate[at], surface,
                       bytes[0] | static_cast<unsigned>(bytes[1]) << 8U, pixel, out);
        }
    }
}

void shade_hits(const TraceFrame& frame, std::uint8_t surface, bool fresh, const Tile& tile,
                const TileHits& hits, const Canvas& out) {
    const std::vector<SurfaceColors>& own = frame.scene.colors;
    const Shading shading(frame.view, surface < own.size() ? own[surface] : colors_of(surface));
    const bool by_pixel = !hits.reflectance[0].empty();
    Light light;
    for (int row = 0; row < tile.rows; ++row) {
        const Row to = row_of(tile, row, out);
        if (illuminate_row(frame, shading, tile, row, hits, light)) {
            if (hits.any_cap) tone_caps(frame, tile, row, hits, light);
            if (by_pixel) {
                shade_row(ByPixel{hits}, surface, fresh, to, row, hits, light, out.pixels);
            } else {
                shade_row(BySide{shading}, surface, fresh, to, row, hits, light, out.pixels);
            }
        } else if (fresh) {
            clear_pixels(to.first, to.count, to.background, out.pixels);
        }
    }
}

void clear_rows(const Tile& tile, const Canvas& out) {
    for (int row = 0; row < tile.rows; ++row) {
        const Row to = row_of(tile, row, out);
        clear_pixels(to.first, to.count, to.background, out.pixels);
    }
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
        if (hits[i].any_unsettled) mark_unsettled(tile, hits[i], out);
    }
}

}  // namespace zeroset

#endif
