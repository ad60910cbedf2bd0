#include "engine/light/shade.hpp"

#include "engine/light/cap_tone.hpp"
#include "engine/scene/palette.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/light/shade.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/light/shade_light-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A bit for each pixel of a row of a tile, the first one lowest.
using RowBits = std::uint64_t;

/// Which pixels of a row are hits.
RowBits hits_of(const float* depths, int count) {
    RowBits bits = 0;
    for (std::size_t col = 0; col < tile_size; col += lanes<float>) {
        const auto is_hit = hn::Lt(hn::LoadU(d<float>, depths + col), hn::Inf(d<float>));
        bits |= RowBits{bits_of(d<float>, is_hit)} << col;
    }
    return bits & ~RowBits{0} >> (64 - count);
}

/// The bits of a vector's pixels, from `col` on.
LaneBits bits_at(RowBits bits, std::size_t col) {
    return static_cast<LaneBits>(bits >> col & ~RowBits{0} >> (64 - lanes<float>));
}

/// The directions of a tile's rays, not of length 1.
struct RayDirections {
    glm::dvec3 first, by_row, key;
    V3 by_col;
    V<float> key_by_col;

    RayDirections(const TraceFrame& frame, const Tile& tile, const UnitVector& key_light)
        : first(frame.view.direction(pixel_centre(tile.col, tile.row), frame.image)),
          key(key_light) {
        const double size = frame.view.parallel() ? 0.0 : frame.view.pixel_size(frame.image.height);
        by_row = -size * frame.view.up;
        by_col = splat(size * frame.view.right);
        key_by_col = hn::Set(d<float>, static_cast<float>(size * glm::dot(key, frame.view.right)));
    }
};

/// Lights the hits of a row.
void illuminate_row(const RayDirections& rays, const Shading& shading, int row, RowBits hit,
                    const LitLayer& layer, RowLight& light) {
    const TileHits& hits = *layer.hits;
    const glm::dvec3 first = rays.first + static_cast<double>(row) * rays.by_row;
    const V3 start = splat(first);
    const V3& step = rays.by_col;
    const V<float> key_start = hn::Set(d<float>, static_cast<float>(glm::dot(rays.key, first)));
    for (std::size_t col = 0; col < tile_size; col += lanes<float>) {
        const RowBits bits = bits_at(hit, col);
        if (bits == 0) continue;
        const std::size_t at = static_cast<std::size_t>(row) * tile_size + col;
        const V<float> along = hn::Iota(d<float>, static_cast<float>(col));
        const HitVector vector{.along = {.x = hn::MulAdd(along, step.x, start.x),
                                         .y = hn::MulAdd(along, step.y, start.y),
                                         .z = hn::MulAdd(along, step.z, start.z)},
                               .along_to_key = hn::MulAdd(along, rays.key_by_col, key_start),
                               .gradient = {.x = hn::LoadU(d<float>, &hits.gradient[0][at]),
                                            .y = hn::LoadU(d<float>, &hits.gradient[1][at]),
                                            .z = hn::LoadU(d<float>, &hits.gradient[2][at])},
                               .key_light = layer.any_dark
                                                ? hn::LoadU(d<float>, &layer.key_light[at])
                                                : hn::Set(d<float>, 1.0F),
                               .is_hit = mask_of(d<float>, static_cast<LaneBits>(bits))};
        illuminate(shading, vector, col, light);
    }
}

/// Caps are darker than the skin, hatched and without highlights.
void tone_caps(const TraceFrame& frame, const Tile& tile, int row, const TileHits& hits,
               RowLight& light) {
    for (int col = 0; col < tile.cols; ++col) {
        const auto at = static_cast<std::size_t>(row * tile_size + col);
        if (hits.cap[at] == 0) continue;
        const glm::dvec3 normal(hits.gradient[0][at], hits.gradient[1][at], hits.gradient[2][at]);
        const glm::dvec3 point = frame.view.point(pixel_centre(tile.col + col, tile.row + row),
                                                  frame.image, static_cast<double>(hits.depth[at]));
        const auto pixel = static_cast<std::size_t>(col);
        light.diffuse[pixel] *= cap_tone(frame.view, frame.image.height, point, normal);
        light.gloss[pixel] = 0.0F;
    }
}

/// Writes the light of a row. `paint`: BySide or ByPixel.
template <class Paint>
void write_row(const Paint& paint, int row, RowBits hit, const RowLight& light, LitLayer& out) {
    float* const channels[] = {out.light_row(row, 0), out.light_row(row, 1), out.light_row(row, 2)};
    for (std::size_t col = 0; col < tile_size; col += lanes<float>) {
        if (bits_at(hit, col) != 0)
            reflect(paint, light, col, static_cast<std::size_t>(row) * tile_size + col, channels);
    }
}

void shade_layer(const TraceFrame& frame, const Tile& tile, LitLayer& layer) {
    const std::vector<SurfaceColors>& colors = frame.scene.colors;
    const Shading shading(frame.view, layer.surface < colors.size() ? colors[layer.surface]
                                                                    : colors_of(layer.surface));
    const RayDirections rays(frame, tile, shading.key);
    const bool by_pixel = !layer.reflectance[0].empty();
    RowLight light;
    for (int row = 0; row < tile.rows; ++row) {
        const RowBits hit =
            hits_of(&layer.hits->depth[static_cast<std::size_t>(row) * tile_size], tile.cols);
        layer.hit_rows[static_cast<std::size_t>(row)] = hit;
        if (hit == 0) continue;
        illuminate_row(rays, shading, row, hit, layer, light);
        if (layer.hits->any_cap) tone_caps(frame, tile, row, *layer.hits, light);
        if (by_pixel) {
            write_row(ByPixel{layer}, row, hit, light, layer);
        } else {
            write_row(BySide{shading}, row, hit, light, layer);
        }
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(shade_layer);

}  // namespace

UnitVector key_light(const ViewFrame& view) {
    return UnitVector(-0.45 * view.right + 0.65 * view.up - 0.75 * view.forward);
}

void shade(const TraceFrame& frame, const Tile& tile, LitLayer& layer) {
    HWY_DYNAMIC_DISPATCH(shade_layer)(frame, tile, layer);
}

}  // namespace zeroset

#endif
