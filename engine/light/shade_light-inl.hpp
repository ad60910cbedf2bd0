// The light on hits, and what they send of it to the eye.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_SHADE_LIGHT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_SHADE_LIGHT_INL
#undef ZEROSET_SHADE_LIGHT_INL
#else
#define ZEROSET_SHADE_LIGHT_INL
#endif

#include "engine/light/shade.hpp"
#include "engine/real/lanes-inl.hpp"
#include "engine/scene/palette.hpp"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

struct V3 {
    V<float> x, y, z;
};

HWY_INLINE V3 splat(const glm::dvec3& v) {
    return {.x = hn::Set(d<float>, static_cast<float>(v.x)),
            .y = hn::Set(d<float>, static_cast<float>(v.y)),
            .z = hn::Set(d<float>, static_cast<float>(v.z))};
}

HWY_INLINE V<float> dot(const V3& a, const V3& b) {
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

HWY_INLINE V3 scaled(const V3& a, V<float> s) {
    return {.x = hn::Mul(a.x, s), .y = hn::Mul(a.y, s), .z = hn::Mul(a.z, s)};
}

/// 2 / sqrt(x) to float's last digits but one.
HWY_INLINE V<float> twice_per_root(V<float> x) {
    const V<float> guess = hn::ApproximateReciprocalSqrt(x);
    return hn::Mul(guess, hn::NegMulAdd(hn::Mul(x, guess), guess, hn::Set(d<float>, 3.0F)));
}

/// A direction as a vector times a number: its length is 2.
struct Direction {
    V3 along;
    V<float> scale;
};

/// Whether x is neither so small nor so large that its digits are lost.
HWY_INLINE M<float> is_moderate(V<float> x) {
    return hn::And(hn::Gt(x, hn::Set(d<float>, 1e-30F)), hn::Lt(x, hn::Set(d<float>, 1e30F)));
}

/// Direction of `a`; `otherwise` where a is 0, infinite or NaN. Undefined in lanes not in `wanted`.
HWY_INLINE Direction direction_of(const V3& a, const Direction& otherwise, M<float> wanted) {
    const V<float> square = dot(a, a);
    if (hn::AllFalse(d<float>, hn::AndNot(is_moderate(square), wanted))) {
        return {.along = a, .scale = twice_per_root(square)};
    }
    // Scaled by the largest component first, so that squares neither overflow nor vanish.
    const V<float> size = hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
    const auto usable = hn::And(hn::Gt(size, hn::Set(d<float>, 1e-42F)), hn::IsFinite(size));
    // Not times 1 / size, which may leave the range of floats where the quotients do not.
    const V3 b{.x = hn::Div(a.x, size), .y = hn::Div(a.y, size), .z = hn::Div(a.z, size)};
    const auto pick = [&](V<float> usual, V<float> rare) {
        return hn::IfThenElse(usable, usual, rare);
    };
    const V3& c = otherwise.along;
    return {.along = {.x = pick(b.x, c.x), .y = pick(b.y, c.y), .z = pick(b.z, c.z)},
            .scale = pick(twice_per_root(dot(b, b)), otherwise.scale)};
}

/// Numbers that all pixels of a surface share, in all lanes: half the directions of the lights,
/// which move with the camera, and the colours of its two sides.
struct Shading {
    UnitVector key;
    V3 half_key, half_fill, half_up;
    V<float> front[3], back[3];

    Shading(const ViewFrame& view, const SurfaceColors& colors)
        : key(key_light(view)),
          half_key(splat(0.5 * key)),
          half_fill(splat(0.5 * fill_light(view))),
          half_up(splat(0.5 * view.up)) {
        for (int channel = 0; channel < 3; ++channel) {
            front[channel] = hn::Set(d<float>, colors.front[channel]);
            back[channel] = hn::Set(d<float>, colors.back[channel]);
        }
    }
};

/// The light on the pixels of a row of a tile, in all its vectors.
struct RowLight {
    alignas(64) float diffuse[tile_size];
    alignas(64) float gloss[tile_size];   ///< twice that of the highlight, before it is sharpened
    alignas(64) float facing[tile_size];  ///< at least 0: the front is seen
};

/// Hits that share a vector.
struct HitVector {
    V3 along;               ///< of their rays, not of length 1
    V<float> along_to_key;  ///< the direction of the key light times that
    V3 gradient;
    V<float> key_light;  ///< how much of it reaches them
    M<float> is_hit;
};

/// The light on hits, to the pixels from `col` on.
HWY_INLINE void illuminate(const Shading& shading, const HitVector& at, std::size_t col,
                           RowLight& light) {
    const V<float> zero = hn::Zero(d<float>);
    const V<float> half = hn::Set(d<float>, 0.5F);
    const V<float> two = hn::Set(d<float>, 2.0F);
    const V3& along = at.along;
    const V<float> twice_towards_viewer = hn::Neg(twice_per_root(dot(along, along)));
    const Direction outward =
        direction_of(at.gradient, {.along = along, .scale = twice_towards_viewer}, at.is_hit);
    const V<float> twice_facing = hn::Mul(dot(outward.along, along), twice_towards_viewer);
    const V<float> to_side = hn::CopySign(outward.scale, twice_facing);
    const V<float> to_key = hn::Mul(dot(outward.along, shading.half_key), to_side);
    const V<float> to_fill = hn::Mul(dot(outward.along, shading.half_fill), to_side);
    const V<float> to_sky = hn::Mul(dot(outward.along, shading.half_up), to_side);
    const V<float> key_light = hn::Mul(hn::Max(to_key, zero), at.key_light);
    const V<float> fill_light = hn::Max(to_fill, zero);
    const V<float> sky = hn::MulAdd(to_sky, half, half);
    const V<float> diffuse =
        hn::MulAdd(key_light, hn::Set(d<float>, 0.85F),
                   hn::MulAdd(fill_light, hn::Set(d<float>, 0.26F),
                              hn::MulAdd(sky, hn::Set(d<float>, 0.16F), hn::Set(d<float>, 0.10F))));
    // The highlight follows from the normal and the direction halfway between light and viewer,
    // unit vectors; their sum may vanish.
    const V<float> quarter = hn::Set(d<float>, 0.25F);
    const V<float> to_key_and_viewer =
        hn::MulAdd(hn::Mul(hn::Abs(twice_facing), quarter), outward.scale, to_key);
    const V<float> square =
        hn::Max(hn::MulAdd(at.along_to_key, twice_towards_viewer, two), hn::Set(d<float>, 1e-6F));
    const V<float> twice_gloss =
        hn::Mul(hn::Max(hn::Mul(to_key_and_viewer, twice_per_root(square)), zero), at.key_light);
    hn::Store(diffuse, d<float>, &light.diffuse[col]);
    hn::Store(twice_gloss, d<float>, &light.gloss[col]);
    hn::Store(twice_facing, d<float>, &light.facing[col]);
}

/// The reflectances of pixels by the side of the surface that is seen.
struct BySide {
    const Shading& shading;

    HWY_INLINE V<float> at(int channel, V<float> facing, std::size_t /*pixel*/) const {
        const auto front = hn::Ge(facing, hn::Zero(d<float>));
        return hn::IfThenElse(front, shading.front[channel], shading.back[channel]);
    }
};

/// The reflectances that each pixel has of its own.
struct ByPixel {
    const LitLayer& layer;

    HWY_INLINE V<float> at(int channel, V<float> /*facing*/, std::size_t pixel) const {
        return hn::LoadU(d<float>, &layer.reflectance[static_cast<std::size_t>(channel)][pixel]);
    }
};

/// Writes the light, red, green and blue, that the pixels from `col` on send to the eye. They are
/// those from `pixel` on in the tile.
template <class Paint>
HWY_INLINE void reflect(const Paint& paint, const RowLight& light, std::size_t col,
                        std::size_t pixel, float* const (&channels)[3]) {
    const V<float> diffuse = hn::Load(d<float>, &light.diffuse[col]);
    V<float> gloss = hn::Load(d<float>, &light.gloss[col]);
    for (int doubling = 0; doubling < 5; ++doubling)
        gloss = hn::Mul(gloss, gloss);
    const V<float> specular = hn::Mul(gloss, hn::Set(d<float>, 0.22F * 0x1p-32F));
    const V<float> facing = hn::Load(d<float>, &light.facing[col]);
    for (int channel = 0; channel < 3; ++channel) {
        // Laid over as a pale veil, the highlight does not burn out to white where it is bright.
        const V<float> body = hn::Mul(paint.at(channel, facing, pixel), diffuse);
        hn::StoreU(hn::NegMulAdd(body, specular, hn::Add(body, specular)), d<float>,
                   channels[channel] + col);
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
