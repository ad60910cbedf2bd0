#include "engine/trace/shade.hpp"

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

HWY_INLINE V3 select(hn::Mask<D> mask, const V3& a, const V3& b) {
    return {hn::IfThenElse(mask, a.x, b.x), hn::IfThenElse(mask, a.y, b.y),
            hn::IfThenElse(mask, a.z, b.z)};
}

/// Whether x is neither so small nor so large that its digits are lost.
HWY_INLINE hn::Mask<D> is_moderate(V x) {
    return hn::And(hn::Gt(x, hn::Set(d, 1e-30F)), hn::Lt(x, hn::Set(d, 1e30F)));
}

/// a / |a|, or `otherwise` where a is 0, too large or not a number.
HWY_INLINE V3 normalized(const V3& a, const V3& otherwise) {
    const V square = dot(a, a);
    const auto moderate = is_moderate(square);
    const V3 n = scaled(a, per_root(square));
    if (hn::AllTrue(d, moderate)) return n;
    // Scaled by the largest component first, so that squares neither overflow nor vanish.
    const V size = hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
    const auto usable = hn::And(hn::Gt(size, hn::Set(d, 1e-37F)), hn::Lt(size, hn::Set(d, 1e37F)));
    const V3 b = scaled(a, hn::Div(hn::Set(d, 1.0F), size));
    const V3 rescaled = scaled(b, per_root(dot(b, b)));
    return select(usable, select(moderate, n, rescaled), otherwise);
}

/// A channel of the picture, 0 to 255, from linear light; gamma 2.
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> encoded(V light) {
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    const V dark = hn::Set(d, 1e-12F);
    const V within = hn::Min(hn::Max(light, dark), hn::Set(d, 1.0F));
    const V value = hn::Mul(within, per_root(within));
    const V scaled_value = hn::MulAdd(value, hn::Set(d, 255.0F), hn::Set(d, 0.5F));
    return hn::BitCast(du, hn::ConvertTo(di, scaled_value));
}

/// What all pixels of a surface share, in all lanes: the lights, which move with the camera, and
/// the colours of its two sides.
struct Shading {
    V3 key, fill, up;
    V front[3], back[3];

    Shading(const ViewFrame& view, const SurfaceColors& colors)
        : key(splat(glm::normalize(-0.45 * view.right + 0.65 * view.up - 0.75 * view.forward))),
          fill(splat(glm::normalize(0.8 * view.right - 0.1 * view.up - 0.45 * view.forward))),
          up(splat(view.up)) {
        for (int channel = 0; channel < 3; ++channel) {
            front[channel] = hn::Set(d, colors.front[channel]);
            back[channel] = hn::Set(d, colors.back[channel]);
        }
    }
};

/// Colours of hits from their rays and gradients.
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> shaded(const Shading& shading, const V3& along,
                                                   const V3& gradient) {
    const hn::RebindToUnsigned<D> du;
    const V zero = hn::Zero(d);
    const V half = hn::Set(d, 0.5F);
    const V two = hn::Set(d, 2.0F);
    const V3 to_viewer = scaled(along, hn::Neg(per_root(dot(along, along))));
    const V3 outward = normalized(gradient, to_viewer);
    const V facing = dot(outward, to_viewer);
    const auto front = hn::Ge(facing, zero);
    const V side = hn::CopySign(hn::Set(d, 1.0F), facing);
    const V to_key = hn::Mul(dot(outward, shading.key), side);
    const V to_fill = hn::Mul(dot(outward, shading.fill), side);
    const V to_sky = hn::Mul(dot(outward, shading.up), side);
    const V key_light = hn::Max(to_key, zero);
    const V fill_light = hn::Max(to_fill, zero);
    const V sky = hn::MulAdd(to_sky, half, half);
    const V diffuse = hn::MulAdd(key_light, hn::Set(d, 0.85F),
                                 hn::MulAdd(fill_light, hn::Set(d, 0.26F),
                                            hn::MulAdd(sky, hn::Set(d, 0.16F), hn::Set(d, 0.10F))));
    // Of the normal and the direction halfway between light and viewer, unit vectors; their sum
    // may vanish.
    const V square = hn::Max(hn::MulAdd(dot(shading.key, to_viewer), two, two), hn::Set(d, 1e-6F));
    V gloss = hn::Max(hn::Mul(hn::Add(to_key, hn::Abs(facing)), per_root(square)), zero);
    for (int doubling = 0; doubling < 5; ++doubling)
        gloss = hn::Mul(gloss, gloss);
    const V specular = hn::Mul(gloss, hn::Set(d, 0.22F));
    auto color = hn::Set(du, 0xFF000000U);
    for (int channel = 0; channel < 3; ++channel) {
        const V albedo = hn::IfThenElse(front, shading.front[channel], shading.back[channel]);
        const auto value = encoded(hn::MulAdd(albedo, diffuse, specular));
        color = hn::Or(color, hn::ShiftLeftSame(value, 8 * channel));
    }
    return color;
}

/// Writes certificate and surface of the pixels whose bits are set.
void write_labels(const Certificate* known, std::uint8_t surface, unsigned bits, std::size_t pixel,
                  Framebuffer& out) {
    for (; bits != 0; bits &= bits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        out.certificate[pixel + lane] = known[lane];
        out.surface[pixel + lane] = surface;
    }
}

void shade_row(const TraceFrame& frame, const Shading& shading, std::uint8_t surface,
               const Tile& tile, int row, const TileHits& hits, Framebuffer& out) {
    const hn::RebindToUnsigned<D> du;
    constexpr std::size_t lanes = hn::MaxLanes(d);
    const double size = frame.view.pixel_size(frame.height);
    const glm::dvec3 first =
        frame.view.direction(tile.col + 0.5, tile.row + row + 0.5, frame.width, frame.height);
    const V3 start = splat(first);
    const V3 step = splat(size * frame.view.right);
    const auto cols = static_cast<std::size_t>(tile.cols);
    for (std::size_t col = 0; col < cols; col += lanes) {
        const std::size_t at = static_cast<std::size_t>(row) * tile_size + col;
        const V depth = hn::LoadU(d, &hits.depth[at]);
        auto hit = hn::Lt(depth, hn::Inf(d));
        if (hn::AllFalse(d, hit)) continue;
        hit = hn::And(hit, hn::FirstN(d, cols - col));
        const V along = hn::Iota(d, static_cast<float>(col));
        const V3 ray{hn::MulAdd(along, step.x, start.x), hn::MulAdd(along, step.y, start.y),
                     hn::MulAdd(along, step.z, start.z)};
        const V3 gradient{hn::LoadU(d, &hits.gradient[0][at]), hn::LoadU(d, &hits.gradient[1][at]),
                          hn::LoadU(d, &hits.gradient[2][at])};
        const auto color = shaded(shading, ray, gradient);
        const std::size_t pixel = out.index(tile.col + static_cast<int>(col), tile.row + row);
        if (hn::AllTrue(d, hit)) {
            hn::StoreU(color, du, &out.color[pixel]);
            hn::StoreU(depth, d, &out.depth[pixel]);
            std::memcpy(&out.certificate[pixel], &hits.certificate[at], lanes);
            std::memset(&out.surface[pixel], surface, lanes);
        } else {
            hn::BlendedStore(color, hn::RebindMask(du, hit), du, &out.color[pixel]);
            hn::BlendedStore(depth, hit, d, &out.depth[pixel]);
            std::uint8_t bytes[8] = {};
            hn::StoreMaskBits(d, hit, bytes);
            write_labels(&hits.certificate[at], surface,
                         bytes[0] | static_cast<unsigned>(bytes[1]) << 8U, pixel, out);
        }
    }
}

void shade_hits(const TraceFrame& frame, std::uint8_t surface, const Tile& tile,
                const TileHits& hits, Framebuffer& out) {
    const std::vector<SurfaceColors>& own = frame.scene.colors;
    const Shading shading(frame.view, surface < own.size() ? own[surface] : colors_of(surface));
    for (int row = 0; row < tile.rows; ++row)
        shade_row(frame, shading, surface, tile, row, hits, out);
}

template <class Tag, class T = hn::TFromD<Tag>>
HWY_INLINE void fill(Tag tag, T value, std::size_t count, T* out) {
    std::size_t i = 0;
    for (; i + hn::Lanes(tag) <= count; i += hn::Lanes(tag))
        hn::StoreU(hn::Set(tag, value), tag, out + i);
    std::fill(out + i, out + count, value);
}

void clear_pixels(const Tile& tile, Framebuffer& out) {
    const auto count = static_cast<std::size_t>(tile.cols);
    for (int row = tile.row; row < tile.row + tile.rows; ++row) {
        const std::size_t begin = out.index(tile.col, row);
        fill(hn::RebindToUnsigned<D>(), background_color(row, out.height), count,
             &out.color[begin]);
        fill(d, std::numeric_limits<float>::infinity(), count, &out.depth[begin]);
        std::memset(&out.certificate[begin], static_cast<int>(Certificate::Miss), count);
        std::memset(&out.surface[begin], no_surface, count);
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(clear_pixels);
HWY_EXPORT(shade_hits);

/// Undecided where a ray is unsettled on pixels that are still misses.
void mark_unsettled(const Tile& tile, const TileHits& hits, Framebuffer& out) {
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col) {
            const auto at = static_cast<std::size_t>(row * tile_size + col);
            Certificate& certificate = out.certificate[out.index(tile.col + col, tile.row + row)];
            const bool unsettled = hits.unsettled[at] < std::numeric_limits<float>::infinity();
            if (unsettled && certificate == Certificate::Miss) {
                certificate = Certificate::Undecided;
            }
        }
    }
}

}  // namespace

void clear_tile(const Tile& tile, Framebuffer& out) {
    HWY_DYNAMIC_DISPATCH(clear_pixels)(tile, out);
}

std::uint32_t background_color(int row, int height) {
    const double t = (row + 0.5) / height;
    const auto mixed = [t](double top, double bottom) {
        return static_cast<std::uint32_t>(top + t * (bottom - top));
    };
    return 0xFF000000U | mixed(58, 24) << 16U | mixed(50, 20) << 8U | mixed(44, 18);
}

void shade_tile(const TraceFrame& frame, std::uint8_t surface, const Tile& tile,
                const TileHits& hits, Framebuffer& out) {
    if (hits.any_unsettled) mark_unsettled(tile, hits, out);
    if (hits.any) HWY_DYNAMIC_DISPATCH(shade_hits)(frame, surface, tile, hits, out);
}

}  // namespace zeroset

#endif
