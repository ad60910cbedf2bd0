#include "engine/light/shade.hpp"

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

/// The directions of a tile's rays, not of length 1, and their products with the direction of the
/// key light.
struct RayDirections {
    struct Vector {
        V3 along;
        V<float> to_key;
    };
    const RayPlaces* places;
    glm::dvec3 first, by_row, key;
    V3 by_col, down;
    V<float> key_by_col, key_down;

    RayDirections(const TraceFrame& frame, const Tile& tile, const UnitVector& key_light)
        : places(tile.places),
          first(frame.view.direction(pixel_centre(tile.col, tile.row), frame.image)),
          key(key_light) {
        const double size = frame.view.parallel() ? 0.0 : frame.view.pixel_size(frame.image.height);
        by_row = -size * frame.view.up;
        by_col = splat(size * frame.view.right);
        down = splat(by_row);
        key_by_col = hn::Set(d<float>, static_cast<float>(size * glm::dot(key, frame.view.right)));
        key_down = hn::Set(d<float>, static_cast<float>(glm::dot(key, by_row)));
    }
};

/// The directions of a row's rays.
class RowDirections {
public:
    RowDirections(const RayDirections& rays, int row)
        : rays_(rays), row_(static_cast<std::size_t>(row)) {
        const double down = rays.places == nullptr ? static_cast<double>(row) : 0.0;
        const glm::dvec3 first = rays.first + down * rays.by_row;
        start_ = splat(first);
        key_start_ = hn::Set(d<float>, static_cast<float>(glm::dot(rays.key, first)));
    }
    /// The directions from a column on.
    HWY_INLINE RayDirections::Vector at(std::size_t col) const {
        if (rays_.places == nullptr)
            return right_of(start_, key_start_, hn::Iota(d<float>, static_cast<float>(col)));
        const std::size_t pixel = row_ * tile_size + col;
        const V<float> down = hn::LoadU(d<float>, rays_.places->row + pixel);
        const V3 start{.x = hn::MulAdd(down, rays_.down.x, start_.x),
                       .y = hn::MulAdd(down, rays_.down.y, start_.y),
                       .z = hn::MulAdd(down, rays_.down.z, start_.z)};
        return right_of(start, hn::MulAdd(down, rays_.key_down, key_start_),
                        hn::LoadU(d<float>, rays_.places->col + pixel));
    }

private:
    HWY_INLINE RayDirections::Vector right_of(const V3& start, V<float> key_start,
                                              V<float> right) const {
        return {.along = {.x = hn::MulAdd(right, rays_.by_col.x, start.x),
                          .y = hn::MulAdd(right, rays_.by_col.y, start.y),
                          .z = hn::MulAdd(right, rays_.by_col.z, start.z)},
                .to_key = hn::MulAdd(right, rays_.key_by_col, key_start)};
    }

    const RayDirections& rays_;
    std::size_t row_;
    V3 start_;
    V<float> key_start_;
};

/// Lights the hits of a row.
void illuminate_row(const RayDirections& rays, const Shading& shading, int row, RowBits hit,
                    const LitLayer& layer, RowLight& light) {
    const TileHits& hits = *layer.hits;
    const RowDirections directions(rays, row);
    const RowBits dark = layer.dark_rows[static_cast<std::size_t>(row)];
    for (std::size_t col = 0; col < tile_size; col += lanes<float>) {
        const RowBits bits = bits_at(hit, col);
        if (bits == 0) continue;
        const std::size_t at = static_cast<std::size_t>(row) * tile_size + col;
        const RayDirections::Vector direction = directions.at(col);
        const HitVector vector{.along = direction.along,
                               .along_to_key = direction.to_key,
                               .gradient = {.x = hn::LoadU(d<float>, &hits.gradient[0][at]),
                                            .y = hn::LoadU(d<float>, &hits.gradient[1][at]),
                                            .z = hn::LoadU(d<float>, &hits.gradient[2][at])},
                               .key_light = hn::IfThenZeroElse(
                                   mask_of(d<float>, bits_at(dark, col)), hn::Set(d<float>, 1.0F)),
                               .is_hit = mask_of(d<float>, static_cast<LaneBits>(bits))};
        illuminate(shading, vector, col, light);
    }
}

/// Caps are darker than the skin, hatched and without highlights.
void tone_caps(const TraceFrame& frame, const Tile& tile, int row, const TileHits& hits,
               RowLight& light) {
    for (int col = 0; col < tile.cols; ++col) {
        const auto at = static_cast<std::size_t>(row * tile_size + col);
        if (!hits.is_cap(at)) continue;
        const glm::dvec3 normal = hits.gradient_at(at);
        const glm::dvec3 point = frame.view.point(tile.place(col, row), frame.image,
                                                  static_cast<double>(hits.depth[at]));
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
    const Shading shading(frame.view, frame.scene.colors_of_surface(layer.surface));
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
    return UnitVector(view.from_view({-0.45, 0.65, 0.75}));
}

UnitVector fill_light(const ViewFrame& view) {
    return UnitVector(view.from_view({0.8, -0.1, 0.45}));
}

void shade(const TraceFrame& frame, const Tile& tile, LitLayer& layer) {
    HWY_DYNAMIC_DISPATCH(shade_layer)(frame, tile, layer);
}

}  // namespace zeroset

#endif
