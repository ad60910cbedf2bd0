// Samples of a slab on their way from the grid (engine/trace/voxels/voxel_tile.hpp).

#include "engine/trace/voxels/slab_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/voxels/slab_lanes.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/real/lanes-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The first lanes of `count` numbers; 0 in the others, which are not read.
HWY_INLINE V<float> load_some(const float* from, std::size_t count) {
    const Tag<float> tag;
    if (count >= lanes<float>) return hn::LoadU(tag, from);
#if HWY_MEM_OPS_MIGHT_FAULT
    HWY_ALIGN float some[lanes<float>] = {};
    for (std::size_t i = 0; i < count; ++i)
        some[i] = from[i];
    return hn::Load(tag, some);
#else
    return hn::MaskedLoad(hn::FirstN(tag, count), tag, from);
#endif
}

/// Adds the bits of samples from the `first` on.
HWY_INLINE void add_bits(V<float> samples, std::size_t first, const LevelBounds& level,
                         SampleBits& bits) {
    const Tag<float> tag;
    const M<float> above = hn::Ge(samples, hn::Set(tag, level.above));
    const M<float> below = hn::Le(samples, hn::Set(tag, level.below));
    bits.above |= std::uint64_t{bits_of(tag, above)} << first;
    bits.below |= std::uint64_t{bits_of(tag, below)} << first;
}

void sample_bits_lanes(const float* samples, std::ptrdiff_t stride, std::size_t rows,
                       std::size_t count, const LevelBounds& level, SampleBits* bits) {
    for (std::size_t row = 0; row < rows; ++row) {
        const float* const from = samples + static_cast<std::ptrdiff_t>(row) * stride;
        bits[row] = {};
        for (std::size_t i = 0; i < count; i += lanes<float>)
            add_bits(load_some(from + i, count - i), i, level, bits[row]);
    }
}

void take_slice_lanes(const float* samples, std::ptrdiff_t stride, const LevelBounds& level,
                      std::size_t slice, const SlabRows& rows, SlabSamples& slab,
                      SampleBits* bits) {
    const Tag<float> tag;
    V<float> largest = hn::Set(tag, slab.largest);
    for (std::size_t row = rows.first; row <= rows.last; ++row) {
        const float* const from = samples + static_cast<std::ptrdiff_t>(row) * stride;
        float* const to = slab.row_at(slice, row);
        bits[row] = {};
        for (std::size_t i = 0; i < slab.count; i += lanes<float>) {
            const V<float> some = load_some(from + i, slab.count - i);
            add_bits(some, i, level, bits[row]);
            const V<float> less = hn::IfThenElseZero(hn::FirstN(tag, slab.count - i),
                                                     hn::Sub(some, hn::Set(tag, level.level)));
            hn::StoreU(less, tag, to + i);
            largest = hn::Max(largest, hn::Abs(less));
        }
    }
    slab.largest = hn::GetLane(hn::MaxOfLanes(tag, largest));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(sample_bits_lanes);
HWY_EXPORT(take_slice_lanes);

}  // namespace

void sample_bits(const float* samples, std::ptrdiff_t stride, std::size_t rows, std::size_t count,
                 const LevelBounds& level, SampleBits* bits) {
    HWY_DYNAMIC_DISPATCH(sample_bits_lanes)(samples, stride, rows, count, level, bits);
}

void take_slice(const float* samples, std::ptrdiff_t stride, const LevelBounds& level,
                std::size_t slice, const SlabRows& rows, SlabSamples& slab, SampleBits* bits) {
    HWY_DYNAMIC_DISPATCH(take_slice_lanes)(samples, stride, level, slice, rows, slab, bits);
}

}  // namespace zeroset

#endif
