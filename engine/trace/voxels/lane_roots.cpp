// First roots in trilinear cells, a ray a lane, as FirstRoot and ray_cubic find them where f goes
// through 0 once, or not at all. The rays of other lanes are reported as unclear and looked at one
// by one. Places, cubics and brackets are computed as there, so that the same bounds of rounding
// hold.

#include "engine/trace/voxels/lane_roots.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/voxels/lane_roots.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/real/lanes-inl.hpp"

#include <hwy/highway.h>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

HWY_INLINE V<double> load(const LaneRays::Numbers& numbers, std::size_t lane) {
    return hn::Load(d<double>, &numbers[lane]);
}
HWY_INLINE void store(V<double> vector, LaneRays::Numbers& numbers, std::size_t lane) {
    hn::Store(vector, d<double>, &numbers[lane]);
}
HWY_INLINE V<double> mix(V<double> x, V<double> y, V<double> share) {
    return hn::MulAdd(share, hn::Sub(y, x), x);
}
/// The bits of the lanes of one vector among all.
HWY_INLINE std::uint32_t bits_at(M<double> mask, std::size_t lane) {
    return bits_of(d<double>, mask) << lane;
}
HWY_INLINE M<double> mask_at_lane(std::uint32_t bits, std::size_t lane) {
    return mask_of(d<double>, bits >> lane & all_lanes<Tag<double>>);
}

/// Where the ray leaves its cell along an axis across.
HWY_INLINE V<double> leaves(const LaneRays& rays, std::size_t axis, std::size_t lane,
                            V<double> cell) {
    const V<double> along = load(rays.along[axis], lane);
    const V<double> zero = hn::Zero(d<double>);
    const V<double> face = hn::IfThenElse(hn::Gt(along, zero), hn::Add(cell, number(1.0)), cell);
    const V<double> depth = hn::Div(hn::Sub(face, load(rays.at[axis], lane)), along);
    return hn::IfThenElse(hn::Eq(along, zero), number(std::numeric_limits<double>::infinity()),
                          depth);
}

struct Leaving {
    V<double> by_i, by_j;
};
/// Finds where the rays leave their cells.
HWY_INLINE void find_end(const LaneRays& rays, std::size_t lane, const Leaving& leaving,
                         LaneRays::Numbers& until) {
    const V<double> nearest = hn::Min(leaving.by_i, leaving.by_j);
    const V<double> to = load(rays.to, lane);
    store(hn::Max(load(rays.from, lane), hn::Min(to, nearest)), until, lane);
}

std::uint32_t enter_layer_lanes(const BundleSearch& search, std::int32_t layer, LaneRays& rays) {
    const auto [axis_i, axis_j, axis_k] = search.axes;
    std::uint32_t inside = 0;
    for (std::size_t lane = 0; lane < rays.count; lane += lanes<double>) {
        const V<double> u = load(rays.u, lane);
        const V<double> v = load(rays.v, lane);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const V<double> across = hn::MulAdd(u, number(search.rays.right[axis]),
                                                hn::Mul(v, number(search.rays.up[axis])));
            store(hn::MulAdd(number(search.rays.distance), across, number(search.rays.base[axis])),
                  rays.at[axis], lane);
            store(hn::Add(number(search.rays.forward[axis]), across), rays.along[axis], lane);
        }
        // Find the stretches in the layer, and which of them are inside the region.
        const V<double> at = load(rays.at[axis_k], lane);
        const V<double> per_layer = hn::Div(number(1.0), load(rays.along[axis_k], lane));
        const V<double> low = hn::Mul(hn::Sub(number(layer), at), per_layer);
        const V<double> high = hn::Mul(hn::Sub(number(layer + 1.0), at), per_layer);
        const V<double> from = hn::Min(low, high);
        const V<double> to = hn::Max(low, high);
        store(from, rays.from, lane);
        store(to, rays.to, lane);
        inside |= bits_at(
            hn::And(hn::Ge(from, number(search.enter)), hn::Le(to, number(search.exit))), lane);
        const auto first_cell = [&](std::size_t axis) {
            const V<double> cell = hn::Floor(
                hn::MulAdd(from, load(rays.along[axis], lane), load(rays.at[axis], lane)));
            store(cell, rays.cell[axis], lane);
            return leaves(rays, axis, lane, cell);
        };
        const V<double> by_i = first_cell(axis_i);
        find_end(rays, lane, {.by_i = by_i, .by_j = first_cell(axis_j)}, rays.until);
        store(number(layer), rays.cell[axis_k], lane);
    }
    return inside & ((1U << rays.count) - 1);
}

std::uint32_t next_cells_lanes(const BundleSearch& search, std::uint32_t some, LaneRays& rays) {
    std::uint32_t left = 0;
    const auto [axis_i, axis_j, axis_k] = search.axes;
    for (std::size_t lane = 0; lane < rays.count; lane += lanes<double>) {
        const V<double> until = load(rays.until, lane);
        left |= bits_at(hn::Lt(until, load(rays.to, lane)), lane);
        if (((some & left) >> lane) == 0) continue;
        const V<double> i = load(rays.cell[axis_i], lane);
        const V<double> j = load(rays.cell[axis_j], lane);
        const M<double> by_i = hn::Le(leaves(rays, axis_i, lane, i), leaves(rays, axis_j, lane, j));
        const auto go = [&](std::size_t axis, V<double> cell, M<double> where) {
            const V<double> one = hn::CopySign(number(1.0), load(rays.along[axis], lane));
            const V<double> next = hn::IfThenElse(where, hn::Add(cell, one), cell);
            store(next, rays.cell[axis], lane);
            return leaves(rays, axis, lane, next);
        };
        const V<double> next_i = go(axis_i, i, by_i);
        const V<double> next_j = go(axis_j, j, hn::Not(by_i));
        store(until, rays.from, lane);
        find_end(rays, lane, {.by_i = next_i, .by_j = next_j}, rays.until);
    }
    return some & left;
}

/// The Bernstein coefficients of f between two places, as ray_cubic has them.
HWY_INLINE std::array<V<double>, 4> cubic(const std::array<V<double>, 8>& corners,
                                          const std::array<V<double>, 3>& from,
                                          const std::array<V<double>, 3>& to) {
    std::array<std::array<V<double>, 2>, 4> edges;
    for (std::size_t edge = 0; edge < 4; ++edge) {
        edges[edge] = {mix(corners[2 * edge], corners[2 * edge + 1], from[0]),
                       mix(corners[2 * edge], corners[2 * edge + 1], to[0])};
    }
    std::array<V<double>, 8> ends;
    for (std::size_t x = 0; x < 2; ++x) {
        for (std::size_t y = 0; y < 2; ++y) {
            const V<double> share = y == 0 ? from[1] : to[1];
            const V<double> below = mix(edges[0][x], edges[1][x], share);
            const V<double> above = mix(edges[2][x], edges[3][x], share);
            ends[x + 2 * y] = mix(below, above, from[2]);
            ends[x + 2 * y + 4] = mix(below, above, to[2]);
        }
    }
    const V<double> third = number(1.0 / 3.0);
    return {ends[0], hn::Mul(third, hn::Add(hn::Add(ends[1], ends[2]), ends[4])),
            hn::Mul(third, hn::Add(hn::Add(ends[3], ends[5]), ends[6])), ends[7]};
}

using Cubic = std::array<V<double>, 4>;

HWY_INLINE V<double> value_at(const Cubic& b, V<double> t) {
    const V<double> s = hn::Sub(number(1.0), t);
    const V<double> three = number(3.0);
    const V<double> low = hn::MulAdd(s, b[0], hn::Mul(hn::Mul(three, t), b[1]));
    const V<double> high = hn::MulAdd(hn::Mul(three, s), b[2], hn::Mul(t, b[3]));
    return hn::MulAdd(hn::Mul(s, s), low, hn::Mul(hn::Mul(t, t), high));
}
HWY_INLINE V<double> slope_at(const Cubic& b, V<double> t) {
    const V<double> s = hn::Sub(number(1.0), t);
    const V<double> twice = hn::Add(s, s);
    const V<double> first = hn::Mul(hn::Mul(s, s), hn::Sub(b[1], b[0]));
    const V<double> second = hn::MulAdd(hn::Mul(twice, t), hn::Sub(b[2], b[1]), first);
    return hn::Mul(number(3.0), hn::MulAdd(hn::Mul(t, t), hn::Sub(b[3], b[2]), second));
}

/// The root of f that is 0 only once, on the lanes `open`: by Newton's steps within the bracket.
HWY_INLINE V<double> only_root(const Cubic& b, M<double> open) {
    constexpr int most_steps = 24;
    const V<double> half = number(0.5);
    const M<double> falls = hn::Gt(b[0], hn::Zero(d<double>));
    V<double> lo = hn::Zero(d<double>);
    V<double> hi = number(1.0);
    V<double> t = hn::Div(b[0], hn::Sub(b[0], b[3]));
    for (int i = 0; i < most_steps && !hn::AllFalse(d<double>, open); ++i) {
        const V<double> f = value_at(b, t);
        const M<double> before = hn::Not(hn::Xor(hn::Gt(f, hn::Zero(d<double>)), falls));
        lo = hn::IfThenElse(before, t, lo);
        hi = hn::IfThenElse(before, hi, t);
        const V<double> next = hn::Sub(t, hn::Div(f, slope_at(b, t)));
        const M<double> within = hn::And(hn::Gt(next, lo), hn::Lt(next, hi));
        const V<double> inside = hn::IfThenElse(within, next, hn::Mul(half, hn::Add(lo, hi)));
        const M<double> far = hn::Gt(hn::Abs(hn::Sub(inside, t)), number(1e-4));
        t = hn::IfThenElse(open, inside, t);
        open = hn::And(open, far);
    }
    return t;
}

/// Stores f's gradients by its slopes along the grid's axes; returns the lanes where they are
/// neither too small nor too large for floats.
HWY_INLINE M<double> put_gradients(const BundleSearch& search,
                                   const std::array<V<double>, 3>& slopes, std::size_t lane,
                                   LaneRays& rays) {
    const hn::Rebind<float, Tag<double>> floats;
    V<double> largest = hn::Zero(d<double>);
    for (std::size_t c = 0; c < 3; ++c) {
        V<double> sum = hn::Zero(d<double>);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            sum = hn::MulAdd(number(search.map.index_from_world[axis][c] * search.sign),
                             slopes[axis], sum);
        }
        largest = hn::Max(largest, hn::Abs(sum));
        hn::StoreU(hn::DemoteTo(floats, sum), floats, &rays.gradient[c][lane]);
    }
    return hn::And(hn::Ge(largest, number(1e-18)), hn::Le(largest, number(1e18)));
}

/// The slopes of f along the axes of cells at places in them.
HWY_INLINE std::array<V<double>, 3> slopes_at(const std::array<V<double>, 8>& corners,
                                              const std::array<V<double>, 3>& at) {
    std::array<V<double>, 4> edge;
    std::array<V<double>, 4> slope;
    for (std::size_t i = 0; i < 4; ++i) {
        slope[i] = hn::Sub(corners[2 * i + 1], corners[2 * i]);
        edge[i] = hn::MulAdd(at[0], slope[i], corners[2 * i]);
    }
    return {mix(mix(slope[0], slope[1], at[1]), mix(slope[2], slope[3], at[1]), at[2]),
            mix(hn::Sub(edge[1], edge[0]), hn::Sub(edge[3], edge[2]), at[2]),
            hn::Sub(mix(edge[2], edge[3], at[1]), mix(edge[0], edge[1], at[1]))};
}

/// The search of find_roots() on one vector of rays.
class LaneVector {
public:
    HWY_INLINE LaneVector(const BundleSearch& search, LaneRays& rays, std::size_t lane)
        : search_(search),
          rays_(rays),
          lane_(lane),
          error_(number(search.error)),
          from_(load(rays.from, lane)),
          until_(load(rays.until, lane)) {
        for (std::size_t corner = 0; corner < 8; ++corner)
            corners_[corner] = load(rays.corners[corner], lane);
        b_ = cubic(corners_, place(from_), place(until_));
    }

    [[nodiscard]] HWY_INLINE M<double> is_above() const {
        return hn::Gt(hn::Min(hn::Min(b_[0], b_[1]), hn::Min(b_[2], b_[3])), error_);
    }
    [[nodiscard]] HWY_INLINE M<double> is_below() const {
        return hn::Lt(hn::Max(hn::Max(b_[0], b_[1]), hn::Max(b_[2], b_[3])), hn::Neg(error_));
    }
    [[nodiscard]] HWY_INLINE M<double> begins_above() const { return hn::Gt(b_[0], error_); }
    /// Whether f goes from one side to the other and is 0 only once: the signs of its coefficients
    /// change once, whatever the sign of one in the middle is [Descartes' rule].
    [[nodiscard]] HWY_INLINE M<double> crosses() const {
        const M<double> falls =
            hn::And(hn::And(above(b_[0]), below(b_[3])), hn::Or(above(b_[1]), below(b_[2])));
        const M<double> rises =
            hn::And(hn::And(below(b_[0]), above(b_[3])), hn::Or(below(b_[1]), above(b_[2])));
        return hn::Or(falls, rises);
    }
    /// Finds and stores the roots on these rays; returns the lanes where they are proved.
    HWY_INLINE M<double> find(M<double> some) {
        const V<double> t = only_root(b_, some);
        const V<double> width = hn::Sub(until_, from_);
        // Make the bracket as wide as is allowed, so that signs are proved where f is flat.
        const V<double> half = hn::Div(number(0.49 * search_.finest), width);
        const V<double> first = value_at(b_, hn::Max(hn::Zero(d<double>), hn::Sub(t, half)));
        const V<double> last = value_at(b_, hn::Min(number(1.0), hn::Add(t, half)));
        // Prove that f has the signs of the stretch's ends at the ends of the bracket, too.
        const M<double> falls = hn::And(begins_above(), hn::And(above(first), below(last)));
        const M<double> rises = hn::AndNot(begins_above(), hn::And(below(first), above(last)));
        const V<double> depth = hn::MulAdd(t, width, from_);
        const V<double> u = load(rays_.u, lane_);
        const V<double> v = load(rays_.v, lane_);
        const V<double> square = hn::MulAdd(u, u, hn::MulAdd(v, v, number(1.0)));
        store(hn::Mul(hn::Add(number(search_.look_distance), depth), hn::Sqrt(square)),
              rays_.distance, lane_);
        const M<double> usual =
            put_gradients(search_, slopes_at(corners_, place(depth)), lane_, rays_);
        return hn::And(hn::And(some, usual), hn::Or(falls, rises));
    }

private:
    [[nodiscard]] HWY_INLINE M<double> above(V<double> f) const { return hn::Gt(f, error_); }
    [[nodiscard]] HWY_INLINE M<double> below(V<double> f) const {
        return hn::Lt(f, hn::Neg(error_));
    }
    [[nodiscard]] HWY_INLINE std::array<V<double>, 3> place(V<double> depth) const {
        std::array<V<double>, 3> result;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            result[axis] = hn::Sub(
                hn::MulAdd(depth, load(rays_.along[axis], lane_), load(rays_.at[axis], lane_)),
                load(rays_.cell[axis], lane_));
        }
        return result;
    }

    const BundleSearch& search_;
    LaneRays& rays_;
    std::size_t lane_;
    V<double> error_, from_, until_;
    std::array<V<double>, 8> corners_;
    Cubic b_;
};

std::uint32_t find_roots_lanes(const BundleSearch& search, std::uint32_t some, LaneRays& rays,
                               LaneSides& sides, std::uint32_t& unclear) {
    std::uint32_t found = 0;
    for (std::size_t lane = 0; lane < rays.count; lane += lanes<double>) {
        const std::uint32_t here = some & all_lanes<Tag<double>> << lane;
        if (here == 0) continue;
        LaneVector vector(search, rays, lane);
        // Find the rays on which f keeps its sign.
        const std::uint32_t above = bits_at(vector.is_above(), lane) & here;
        const std::uint32_t below = bits_at(vector.is_below(), lane) & here;
        const std::uint32_t open = here & ~(above | below);
        // Find the roots of rays on which f crosses 0 just once.
        std::uint32_t roots = 0;
        if (open != 0) {
            const M<double> crosses = hn::And(mask_at_lane(open, lane), vector.crosses());
            if (!hn::AllFalse(d<double>, crosses)) roots = bits_at(vector.find(crosses), lane);
        }
        // Between stretches f is not near 0, so the side has not changed since.
        const std::uint32_t from_above = bits_at(vector.begins_above(), lane);
        const std::uint32_t turned = (sides.below & (above | (roots & from_above))) |
                                     (sides.above & (below | (roots & ~from_above)));
        found |= roots & ~turned;
        unclear |= (open & ~roots) | turned;
        sides.above |= above;
        sides.below |= below;
    }
    return found;
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(enter_layer_lanes);
HWY_EXPORT(next_cells_lanes);
HWY_EXPORT(find_roots_lanes);

}  // namespace

std::uint32_t enter_layer(const BundleSearch& search, std::int32_t layer, LaneRays& rays) {
    return HWY_DYNAMIC_DISPATCH(enter_layer_lanes)(search, layer, rays);
}

std::uint32_t next_cells(const BundleSearch& search, std::uint32_t lanes, LaneRays& rays) {
    return HWY_DYNAMIC_DISPATCH(next_cells_lanes)(search, lanes, rays);
}

std::uint32_t find_roots(const BundleSearch& search, std::uint32_t lanes, LaneRays& rays,
                         LaneSides& sides, std::uint32_t& unclear) {
    return HWY_DYNAMIC_DISPATCH(find_roots_lanes)(search, lanes, rays, sides, unclear);
}

}  // namespace zeroset

#endif
