#include "engine/trace/patch/patch_found.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/patch/patch_found.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/patch/patch_solver-inl.hpp"

#include <hwy/highway.h>

#include <bit>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// TileRays::distance_at of some rays.
HWY_INLINE V<double> distances(const TileFound& tile, std::size_t at) {
    const V<double> u = hn::LoadU(d<double>, tile.u + at % tile_size);
    const V<double> v = number(tile.v[at / tile_size]);
    const V<double> slant = hn::Sqrt(hn::MulAdd(u, u, hn::MulAdd(v, v, number(1.0))));
    return hn::Mul(hn::Add(number(tile.look_distance), hn::LoadU(d<double>, tile.reach + at)),
                   slant);
}

/// The rays from `at` on, as many as a vector of floats has numbers.
inline bool put_some(const TileFound& tile, std::size_t at, TileHits& hits) {
    const hn::RebindToUnsigned<Tag<float>> dw;
    V<float> normal[3];
    V<float> state;
    hn::LoadInterleaved4(d<float>, tile.found[at].normal.data(), normal[0], normal[1], normal[2],
                         state);
    const auto states = hn::BitCast(dw, state);
    const auto is = [&](RayState one) HWY_ATTR {
        return hn::Eq(states, hn::Set(dw, static_cast<std::uint32_t>(one)));
    };
    const auto proved = hn::RebindMask(d<float>, is(RayState::Proved));
    const auto hit = hn::Or(proved, hn::RebindMask(d<float>, is(RayState::Drawn)));
    const auto kept = hn::RebindMask(d<float>, is(RayState::Kept));
    const bool are_others =
        !hn::AllFalse(d<float>, hn::Or(kept, hn::AndNot(hn::IsFinite(normal[0]), hit)));
    if (hn::AllFalse(d<float>, hit)) return are_others;
    hits.any = true;
    const auto put = [&](V<float> numbers, std::vector<float>& to) HWY_ATTR {
        hn::StoreU(hn::IfThenElse(hit, numbers, hn::LoadU(d<float>, to.data() + at)), d<float>,
                   to.data() + at);
    };
    put(floats_of(distances(tile, at), distances(tile, at + lanes<double>)), hits.depth);
    for (std::size_t k = 0; k < 3; ++k)
        put(normal[k], hits.gradient[k]);
    const LaneBits is_hit = bits_of(d<float>, hit);
    const LaneBits is_proved = bits_of(d<float>, proved);
    for (std::size_t lane = 0; lane < lanes<float>; ++lane) {
        if ((is_hit >> lane & 1U) == 0) continue;
        hits.certificate[at + lane] =
            (is_proved >> lane & 1U) != 0 ? Certificate::Certified : Certificate::Undecided;
    }
    return are_others;
}

bool put_all(const TileFound& tile, TileHits& hits) {
    bool are_others = false;
    for (int row = 0; row < tile.rows; ++row) {
        const auto first = static_cast<std::size_t>(row) * tile_size;
        const std::uint64_t in_row = tile.blocks >> block_of(first);
        for (std::size_t col = 0; col < static_cast<std::size_t>(tile.cols); col += lanes<float>) {
            constexpr std::size_t wide = std::max<std::size_t>(lanes<float> / tile_block, 1);
            constexpr std::uint64_t some = (std::uint64_t{1} << wide) - 1;
            if ((in_row >> col / tile_block & some) == 0) continue;
            are_others = put_some(tile, first + col, hits) || are_others;
        }
    }
    return are_others;
}

double largest_of(const double* numbers) {
    const hn::CappedTag<double, tile_block> in_block;
    auto largest = hn::LoadU(in_block, numbers);
    for (std::size_t row = 0; row < tile_block; ++row) {
        for (std::size_t col = 0; col < tile_block; col += hn::MaxLanes(in_block))
            largest = hn::Max(largest, hn::LoadU(in_block, numbers + row * tile_size + col));
    }
    return hn::GetLane(hn::MaxOfLanes(in_block, largest));
}

void largest(const double* numbers, std::uint64_t blocks,
             std::array<double, tile_blocks>& largest) {
    for (; blocks != 0; blocks &= blocks - 1) {
        const auto at = static_cast<std::size_t>(std::countr_zero(blocks));
        largest[at] = largest_of(numbers + first_pixel_of(at));
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {

HWY_EXPORT(put_all);
HWY_EXPORT(largest);

bool put_found(const TileFound& tile, TileHits& hits) {
    return HWY_DYNAMIC_DISPATCH(put_all)(tile, hits);
}

void find_largest(const double* numbers, std::uint64_t blocks,
                  std::array<double, tile_blocks>& largest) {
    HWY_DYNAMIC_DISPATCH(largest)(numbers, blocks, largest);
}

}  // namespace zeroset

#endif
