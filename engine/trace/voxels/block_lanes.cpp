// Tests of all rays of a bundle at once, a ray a lane (engine/trace/voxels/voxel_tile.hpp).
//
// In floats a ray is known to 2^-16 of a cell, as places count from the slab's first cells, at most
// 32 away. So a ray may be in a cell that it is not looked for in, but only as far from a face of
// one that it is looked for in. f changes there by less than that times the slopes of both, which
// are no larger than twice the largest sample; this and the rounding of f itself is what
// AskedLayer::error must cover: 2^-11 of the largest sample does, four times over.
// A cell beyond the slab is taken for the nearest one in it, continued: f is continuous.

#include "engine/trace/voxels/block_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/voxels/block_lanes.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/real/lanes-inl.hpp"
#include "engine/trace/voxels/cell_lanes-inl.hpp"

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// More than rounding in float moves places by.
constexpr float place_spare = 1e-3F;

double make_columns_lanes(const IndexRays& rays, const WalkAxes& axes, double u, double v,
                          double pixel, RayColumns& columns) {
    const hn::CappedTag<double, block_size> tag;
    using Vector = hn::Vec<decltype(tag)>;
    const auto number = [&](double x) { return hn::Set(tag, x); };
    Vector steepest = hn::Zero(tag);
    for (std::size_t ray = 0; ray < block_rays; ray += hn::Lanes(tag)) {
        const auto col = static_cast<double>(ray % block_size);
        const auto row = static_cast<double>(ray / block_size);
        const Vector us = hn::MulAdd(hn::Iota(tag, col), number(pixel), number(u));
        const double of_row = v - row * pixel;
        const auto across = [&](std::size_t axis) {
            return hn::MulAdd(us, number(rays.right[axis]), number(of_row * rays.up[axis]));
        };
        const Vector k_across = across(axes.k);
        const Vector per_layer =
            hn::Div(number(1.0), hn::Add(number(rays.forward[axes.k]), k_across));
        const Vector k_at = hn::MulAdd(number(rays.distance), k_across, number(rays.base[axes.k]));
        const auto line = [&](std::size_t axis, double* at, double* slope) {
            const Vector aside = across(axis);
            const Vector slopes = hn::Mul(hn::Add(number(rays.forward[axis]), aside), per_layer);
            const Vector from = hn::MulAdd(number(rays.distance), aside, number(rays.base[axis]));
            hn::StoreU(slopes, tag, slope + ray);
            hn::StoreU(hn::NegMulAdd(slopes, k_at, from), tag, at + ray);
            steepest = hn::Max(steepest, hn::Abs(slopes));
        };
        line(axes.i, columns.i_at.data(), columns.i_slope.data());
        line(axes.j, columns.j_at.data(), columns.j_slope.data());
    }
    return hn::GetLane(hn::MaxOfLanes(tag, steepest));
}

RayExtent extent_of_lanes(const RayColumns& columns, double k, std::uint64_t open) {
    const Tag<double> tag;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr std::uint64_t all = (std::uint64_t{1} << lanes<double>)-1;
    V<double> i_low = hn::Set(tag, infinity);
    V<double> i_high = hn::Set(tag, -infinity);
    V<double> j_low = i_low;
    V<double> j_high = i_high;
    for (std::size_t ray = 0; ray < block_rays; ray += lanes<double>) {
        const auto bits = static_cast<LaneBits>(open >> ray & all);
        if (bits == 0) continue;
        const M<double> some = mask_of(tag, bits);
        const auto add = [&](const double* at, const double* slope, V<double>& low,
                             V<double>& high) {
            const V<double> here =
                hn::MulAdd(hn::LoadU(tag, slope), hn::Set(tag, k), hn::LoadU(tag, at));
            low = hn::Min(low, hn::IfThenElse(some, here, low));
            high = hn::Max(high, hn::IfThenElse(some, here, high));
        };
        add(&columns.i_at[ray], &columns.i_slope[ray], i_low, i_high);
        add(&columns.j_at[ray], &columns.j_slope[ray], j_low, j_high);
    }
    return {.i_low = hn::GetLane(hn::MinOfLanes(tag, i_low)),
            .i_high = hn::GetLane(hn::MaxOfLanes(tag, i_high)),
            .j_low = hn::GetLane(hn::MinOfLanes(tag, j_low)),
            .j_high = hn::GetLane(hn::MaxOfLanes(tag, j_high))};
}

void count_from_lanes(const RayColumns& columns, double i, double j, double layer, SlabRays& rays) {
    const Tag<double> tag;
    const hn::Rebind<float, Tag<double>> floats;
    const auto convert = [&](const double* at, const double* slope, double first, float* at_to,
                             float* slope_to) {
        const V<double> slopes = hn::LoadU(tag, slope);
        const V<double> here = hn::MulAdd(slopes, hn::Set(tag, layer), hn::LoadU(tag, at));
        hn::StoreU(hn::DemoteTo(floats, hn::Sub(here, hn::Set(tag, first))), floats, at_to);
        hn::StoreU(hn::DemoteTo(floats, slopes), floats, slope_to);
    };
    for (std::size_t ray = 0; ray < block_rays; ray += lanes<double>) {
        convert(&columns.i_at[ray], &columns.i_slope[ray], i, &rays.i_at[ray], &rays.i_slope[ray]);
        convert(&columns.j_at[ray], &columns.j_slope[ray], j, &rays.j_at[ray], &rays.j_slope[ray]);
    }
}

/// Rays along one axis across: where they are on entering the layer, and by how much they go on.
struct Across {
    V<float> at, slope;
};

/// The least cell that a ray is in along an axis in the layer.
HWY_INLINE hn::Vec<hn::RebindToSigned<Tag<float>>> least_cell(const Across& ray, float most) {
    const Tag<float> tag;
    const V<float> least = hn::Min(ray.at, hn::Add(ray.at, ray.slope));
    const V<float> place = hn::Sub(least, hn::Set(tag, place_spare));
    const V<float> inside = hn::Min(hn::Max(place, hn::Zero(tag)), hn::Set(tag, most));
    return hn::ConvertTo(hn::RebindToSigned<Tag<float>>(), inside);
}

/// The rays that may be in marked cells: those whose least cell along both axes has a mark.
HWY_INLINE M<float> near_marked(const NearCells& cells, const Across& i, const Across& j) {
    const hn::RebindToSigned<Tag<float>> whole;
    const hn::RebindToUnsigned<Tag<float>> words;
    const auto row = hn::GatherIndex(words, cells.rows.data(), least_cell(j, 63.0F));
    const auto mark =
        hn::And(hn::Shr(row, hn::BitCast(words, least_cell(i, 31.0F))), hn::Set(words, 1U));
    return hn::RebindMask(Tag<float>(), hn::Eq(hn::BitCast(whole, mark), hn::Set(whole, 1)));
}

/// A ray's way from cell to cell along one axis across.
struct CellWay {
    V<float> cell, step;
    V<float> next, per_cell;  ///< where it leaves the cell, in parts of the layer

    explicit HWY_INLINE CellWay(const Across& ray) {
        const Tag<float> tag;
        const V<float> one = hn::Set(tag, 1.0F);
        cell = hn::Floor(ray.at);
        const M<float> down = hn::Lt(ray.slope, hn::Zero(tag));
        step = hn::IfThenElse(down, hn::Neg(one), one);
        per_cell = hn::Div(one, hn::Max(hn::Abs(ray.slope), hn::Set(tag, 1e-20F)));
        const V<float> passed = hn::Sub(ray.at, cell);
        next = hn::Mul(hn::IfThenElse(down, passed, hn::Sub(one, passed)), per_cell);
    }
    HWY_INLINE void go_on(M<float> where) {
        cell = hn::IfThenElse(where, hn::Add(cell, step), cell);
        next = hn::IfThenElse(where, hn::Add(next, per_cell), next);
    }
};

/// The rays among `open` on which f may come near 0 in some cell of the layer.
template <class Cell>
HWY_INLINE M<float> at_level(const AskedLayer& asked, const Across& i, const Across& j,
                             M<float> open) {
    const Tag<float> tag;
    const hn::RebindToSigned<Tag<float>> whole;
    const SlabSamples& samples = asked.samples;
    const V<float> zero = hn::Zero(tag);
    const V<float> one = hn::Set(tag, 1.0F);
    const V<float> i_last = hn::Set(tag, static_cast<float>(samples.count - Cell::support));
    const V<float> j_first = hn::Set(tag, static_cast<float>(asked.rows.first));
    const V<float> j_last = hn::Set(tag, static_cast<float>(asked.rows.last));
    const V<float> row = hn::Set(tag, static_cast<float>(samples.row));
    const float* const corners = &samples.numbers[asked.layer * samples.rows * samples.row];
    CellWay i_steps(i);
    CellWay j_steps(j);
    M<float> found = hn::Lt(one, zero);  // none
    V<float> from = zero;
    for (;;) {
        // End the stretch where the ray leaves the cell or the layer.
        const V<float> to = hn::Min(hn::Min(i_steps.next, j_steps.next), one);
        // Take the nearest cell of the slab; cells more than one away from it do not count.
        const V<float> i_cell = hn::Min(hn::Max(i_steps.cell, zero), i_last);
        const V<float> j_cell = hn::Min(hn::Max(j_steps.cell, j_first), j_last);
        const V<float> far =
            hn::Max(hn::Abs(hn::Sub(i_cell, i_steps.cell)), hn::Abs(hn::Sub(j_cell, j_steps.cell)));
        const auto in_cell = [&](const Across& ray, V<float> cell) {
            const V<float> at = hn::Sub(ray.at, cell);
            return Stretch{.from = hn::MulAdd(ray.slope, from, at),
                           .to = hn::MulAdd(ray.slope, to, at)};
        };
        // Test whether f may come near 0 on the stretch.
        const M<float> may_be = Cell::may_be_zero(
            corners, samples, hn::ConvertTo(whole, hn::MulAdd(j_cell, row, i_cell)),
            in_cell(i, i_cell), in_cell(j, j_cell), {.from = from, .to = to}, asked.error);
        found = hn::Or(found, hn::And(hn::And(open, may_be), hn::Le(far, one)));
        open = hn::And(hn::AndNot(found, open), hn::Lt(to, one));
        if (hn::AllFalse(tag, open)) return found;
        // Go on to the next cell.
        const M<float> by_i = hn::Le(i_steps.next, j_steps.next);
        i_steps.go_on(by_i);
        j_steps.go_on(hn::Not(by_i));
        from = to;
    }
}

/// The rays among those of a bundle that are near marked cells, side by side.
class NearRays {
public:
    NearRays(const SlabRays& rays, const AskedLayer& asked, std::uint64_t open) {
        const V<float> layer = hn::Set(tag, static_cast<float>(asked.layer));
        constexpr std::uint64_t all = (std::uint64_t{1} << lanes<float>)-1;
        for (std::size_t ray = 0; ray < block_rays; ray += lanes<float>) {
            const auto here = static_cast<LaneBits>(open >> ray & all);
            if (here == 0) continue;
            const auto across = [&](const float* at, const float* slope) {
                const V<float> slopes = hn::LoadU(tag, slope);
                return Across{.at = hn::MulAdd(slopes, layer, hn::LoadU(tag, at)), .slope = slopes};
            };
            const Across i = across(&rays.i_at[ray], &rays.i_slope[ray]);
            const Across j = across(&rays.j_at[ray], &rays.j_slope[ray]);
            const M<float> near = hn::And(near_marked(asked.marked, i, j), mask_of(tag, here));
            const auto bits = std::uint64_t{bits_of(tag, near)};
            if (bits == 0) continue;
            rays_ |= bits << ray;
            const std::array<V<float>, 4> numbers{i.at, i.slope, j.at, j.slope};
            for (std::size_t column = 0; column < 4; ++column)
                hn::StoreU(hn::Compress(numbers[column], near), tag, &columns_[column][count_]);
            count_ += static_cast<std::size_t>(std::popcount(bits));
        }
        // The rest of the last vector is no ray's, but goes to cells, too.
        for (auto& column : columns_)
            hn::StoreU(hn::Zero(tag), tag, &column[count_]);
    }

    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] Across i(std::size_t first) const { return across(0, first); }
    [[nodiscard]] Across j(std::size_t first) const { return across(2, first); }
    /// Bits of these rays, side by side, turned into bits of the bundle.
    [[nodiscard]] std::uint64_t of_bundle(std::uint64_t found) const {
        std::uint64_t result = 0;
        for (std::uint64_t left = rays_; left != 0; left &= left - 1, found >>= 1U)
            result |= (found & 1U) != 0 ? left & -left : 0;
        return result;
    }

private:
    [[nodiscard]] Across across(std::size_t column, std::size_t first) const {
        return {.at = hn::LoadU(tag, &columns_[column][first]),
                .slope = hn::LoadU(tag, &columns_[column + 1][first])};
    }

    static constexpr Tag<float> tag{};
    std::uint64_t rays_ = 0;
    std::size_t count_ = 0;
    alignas(64) std::array<std::array<float, block_rays + lanes<float>>, 4> columns_;
};

std::uint64_t rays_at_level_lanes(const SlabRays& rays, const AskedLayer& asked,
                                  std::uint64_t open) {
    const Tag<float> tag;
    const NearRays near(rays, asked, open);
    std::uint64_t found = 0;
    for (std::size_t first = 0; first < near.count(); first += lanes<float>) {
        const M<float> some = hn::FirstN(tag, near.count() - first);
        const Across i = near.i(first);
        const Across j = near.j(first);
        const M<float> at = asked.is_spline ? at_level<SplineCells>(asked, i, j, some)
                                            : at_level<TrilinearCells>(asked, i, j, some);
        found |= std::uint64_t{bits_of(tag, at)} << first;
    }
    return found == 0 ? 0 : near.of_bundle(found);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(make_columns_lanes);
HWY_EXPORT(extent_of_lanes);
HWY_EXPORT(count_from_lanes);
HWY_EXPORT(rays_at_level_lanes);

}  // namespace

double make_columns(const IndexRays& rays, const WalkAxes& axes, double u, double v, double pixel,
                    RayColumns& columns) {
    return HWY_DYNAMIC_DISPATCH(make_columns_lanes)(rays, axes, u, v, pixel, columns);
}

RayExtent extent_of(const RayColumns& columns, double k, std::uint64_t open) {
    return HWY_DYNAMIC_DISPATCH(extent_of_lanes)(columns, k, open);
}

void count_from(const RayColumns& columns, double i, double j, double layer, SlabRays& rays) {
    HWY_DYNAMIC_DISPATCH(count_from_lanes)(columns, i, j, layer, rays);
}

std::uint64_t rays_at_level(const SlabRays& rays, const AskedLayer& asked, std::uint64_t open) {
    return HWY_DYNAMIC_DISPATCH(rays_at_level_lanes)(rays, asked, open);
}

}  // namespace zeroset

#endif
