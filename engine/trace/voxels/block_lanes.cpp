// What the rays of a bundle are asked all at once (engine/trace/voxels/proved_voxels.cpp).

#include "engine/trace/voxels/block_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/voxels/block_lanes.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/simd/vectors-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// More than rounding in float moves places by.
constexpr float place_spare = 1e-3F;

/// The least cell that a ray is in along an axis in the layer, from the rectangle's first one.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> least_cell(D tag, const float* at, const float* slope,
                                                     hn::Vec<D> layers, float first, float most) {
    const hn::Vec<D> along = hn::LoadU(tag, slope);
    const hn::Vec<D> here = hn::MulAdd(along, layers, hn::LoadU(tag, at));
    const hn::Vec<D> least = hn::Min(here, hn::Add(here, along));
    const hn::Vec<D> place = hn::Sub(least, hn::Set(tag, first + place_spare));
    const hn::Vec<D> inside = hn::Min(hn::Max(place, hn::Zero(tag)), hn::Set(tag, most));
    return hn::ConvertTo(hn::RebindToSigned<D>(), inside);
}

std::uint64_t rays_near_lanes(const RayColumns& rays, const NearCells& cells) {
    const Tag<float> tag;
    const hn::RebindToSigned<Tag<float>> whole;
    const hn::RebindToUnsigned<Tag<float>> words;
    const V<float> layers = hn::Set(tag, cells.layer);
    std::uint64_t near = 0;
    for (std::size_t ray = 0; ray < block_rays; ray += lanes<float>) {
        const auto i =
            least_cell(tag, &rays.i_at[ray], &rays.i_slope[ray], layers, cells.i_first, 31.0F);
        const auto j =
            least_cell(tag, &rays.j_at[ray], &rays.j_slope[ray], layers, cells.j_first, 63.0F);
        const auto row = hn::GatherIndex(words, cells.rows.data(), j);
        const auto mark = hn::And(hn::Shr(row, hn::BitCast(words, i)), hn::Set(words, 1U));
        const auto marked = hn::Eq(hn::BitCast(whole, mark), hn::Set(whole, 1));
        near |= static_cast<std::uint64_t>(bits_of(whole, marked)) << ray;
    }
    return near;
}

HWY_INLINE SampleBits row_bits(const float* samples, std::size_t count, float above, float below) {
    const Tag<float> tag;
    SampleBits bits{};
    for (std::size_t i = 0; i < count; i += lanes<float>) {
        const std::size_t left = count - i;
        const V<float> some = left >= lanes<float>
                                  ? hn::LoadU(tag, samples + i)
                                  : hn::MaskedLoad(hn::FirstN(tag, left), tag, samples + i);
        const M<float> is_above = hn::Ge(some, hn::Set(tag, above));
        const M<float> is_below = hn::Le(some, hn::Set(tag, below));
        bits.above |= static_cast<std::uint64_t>(bits_of(tag, is_above)) << i;
        bits.below |= static_cast<std::uint64_t>(bits_of(tag, is_below)) << i;
    }
    return bits;
}

void sample_bits_lanes(const float* samples, std::ptrdiff_t stride, std::size_t rows,
                       std::size_t count, float above, float below, SampleBits* bits) {
    for (std::size_t row = 0; row < rows; ++row)
        bits[row] =
            row_bits(samples + static_cast<std::ptrdiff_t>(row) * stride, count, above, below);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(rays_near_lanes);
HWY_EXPORT(sample_bits_lanes);

}  // namespace

std::uint64_t rays_near(const RayColumns& rays, const NearCells& cells) {
    return HWY_DYNAMIC_DISPATCH(rays_near_lanes)(rays, cells);
}

void sample_bits(const float* samples, std::ptrdiff_t stride, std::size_t rows, std::size_t count,
                 float above, float below, SampleBits* bits) {
    HWY_DYNAMIC_DISPATCH(sample_bits_lanes)(samples, stride, rows, count, above, below, bits);
}

}  // namespace zeroset

#endif
