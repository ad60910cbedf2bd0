#pragma once

#include "engine/algebra/beam_algebra.hpp"
#include "engine/algebra/dual_algebra.hpp"
#include "engine/real/block.hpp"
#include "engine/tape/parts.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

// Results of the code of a part for a block of items, as values of the interpreter. Each function
// takes the batch of the whole formula and the block's first item.

namespace zeroset {

/// A block, or where the code shall write one.
template <class Real, std::size_t bytes>
const Real* numbers(const Block<Real, bytes>& block) {
    return reinterpret_cast<const Real*>(&block);
}
template <class Real, std::size_t bytes>
Real* numbers(Block<Real, bytes>& block) {
    return reinterpret_cast<Real*>(&block);
}

/// All ones or 0, as kernels write them.
template <class Real, std::size_t bytes>
struct MaskBlock {
    std::array<ContinuityMask<Real>, Block<Real, bytes>::lanes> items;

    [[nodiscard]] BlockMask mask() const {
        Block<Real, bytes> block;
        std::memcpy(&block, items.data(), sizeof block);
        unsigned bits = 0;
        for (std::size_t i = 0; i < block.registers.size(); ++i) {
            bits |= static_cast<unsigned>(detail::sign_bits(block.registers[i].lanes))
                    << (Block<Real, bytes>::register_lanes * i);
        }
        return {static_cast<std::uint16_t>(bits)};
    }
};

/// Absent where it holds in all lanes.
template <class Real>
std::optional<BlockMask> known_mask(BlockMask mask) {
    constexpr unsigned all = (1U << Block<Real>::lanes) - 1U;
    if ((mask.bits & all) == all) return std::nullopt;
    return mask;
}

/// Makes the form, with a slope that is an interval; returns where it may have a kink. `on_rays`:
/// the frustum's radii are 0.
template <class Real, std::size_t bytes>
[[gnu::flatten]] BlockMask part_form(const PartShape& shape, const Part& part,
                                     const FormBatchOf<Real>& batch, std::size_t item, bool on_rays,
                                     BeamValue<Block<Real, bytes>>& value) {
    using Lanes = Block<Real, bytes>;
    MaskBlock<Real, bytes> continuous;
    MaskBlock<Real, bytes> nowhere;
    std::array<ContinuityMask<Real>, Lanes::lanes> branches{};
    Lanes across;
    Interval<Lanes> slope;
    Affine<Lanes>& f = value.f.f;
    f.k[2].emplace();
    if (!on_rays) {
        f.k[0].emplace();
        f.k[1].emplace();
    }
    const FormBatchOf<Real> own{.size = Lanes::lanes,
                                .u = batch.u + item,
                                .v = batch.v + item,
                                .s = batch.s + item,
                                .s_radius = batch.s_radius + item,
                                .frustum = batch.frustum,
                                .uniforms = box_uniforms(shape, part, batch.uniforms),
                                .c = numbers(f.c),
                                .k = {numbers(on_rays ? across : *f.k[0]),
                                      numbers(on_rays ? across : *f.k[1]), numbers(*f.k[2])},
                                .e = numbers(f.e),
                                .r = numbers(value.f.r),
                                .slope_neg_lo = numbers(slope.neg_lo),
                                .slope_hi = numbers(slope.hi),
                                .continuous = continuous.items.data(),
                                .nowhere = nowhere.items.data(),
                                .branches = branches.data()};
    if (on_rays) {
        shape.kernel.ray_form(own);
    } else {
        shape.kernel.form(own);
    }
    value.f.size = largest(f);
    const Affine<Lanes> slope_form = centred(slope);
    value.slope = SlopeBeam<Lanes>{slope_form, largest(slope)};
    value.everywhere = known_mask<Real>(continuous.mask());
    value.continuous = value.everywhere;
    value.somewhere = known_mask<Real>(no(nowhere.mask()));
    unsigned kinks = 0;
    for (std::size_t lane = 0; lane < Lanes::lanes; ++lane)
        kinks |= static_cast<unsigned>(branches[lane] & BranchBits::kink) << lane;
    return {static_cast<std::uint16_t>(kinks)};
}

template <class Real, std::size_t bytes>
Enclosure<Block<Real, bytes>> part_range(const PartShape& shape, const Part& part,
                                         const RangeBatchOf<Real>& batch, std::size_t item) {
    using Lanes = Block<Real, bytes>;
    MaskBlock<Real, bytes> continuous;
    Interval<Lanes> f;
    const auto from = [item](const Real* const(&columns)[3]) {
        return std::array{columns[0] + item, columns[1] + item, columns[2] + item};
    };
    const auto neg_lo = from(batch.neg_lo);
    const auto hi = from(batch.hi);
    shape.kernel.range(RangeBatchOf<Real>{Lanes::lanes,
                                          {neg_lo[0], neg_lo[1], neg_lo[2]},
                                          {hi[0], hi[1], hi[2]},
                                          box_uniforms(shape, part, batch.uniforms),
                                          numbers(f.neg_lo),
                                          numbers(f.hi),
                                          continuous.items.data()});
    const Lanes zero = Lanes::splat(0);
    const Lanes lowest = like(zero, -infinity);
    const auto has_gap = both(f.neg_lo < zero, f.hi < zero);
    const auto nowhere = both(f.neg_lo == lowest, f.hi == lowest);
    const auto everywhere = known_mask<Real>(continuous.mask());
    Enclosure<Lanes> result{without_nan(select(has_gap, whole_line(zero), f)),
                            known_mask<Real>(no(nowhere)), everywhere, everywhere};
    if (has_gap.bits != 0) result.gap = select(has_gap, f, whole_line(zero));
    return result;
}

template <class Real, std::size_t bytes>
Dual<Block<Real, bytes>> part_value(const PartShape& shape, const Part& part,
                                    const ValueBatchOf<Real>& batch, std::size_t item) {
    using Lanes = Block<Real, bytes>;
    Lanes f;
    std::array<Lanes, 3> gradient;
    shape.kernel.value(
        ValueBatchOf<Real>{Lanes::lanes,
                           {batch.x[0] + item, batch.x[1] + item, batch.x[2] + item},
                           point_uniforms(shape, part, batch.uniforms),
                           numbers(f),
                           {numbers(gradient[0]), numbers(gradient[1]), numbers(gradient[2])}});
    return {f, Slopes<Lanes>(gradient[0], gradient[1], gradient[2])};
}

}  // namespace zeroset
