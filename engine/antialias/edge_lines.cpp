#include "engine/antialias/edge_lines.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/antialias/edge_lines.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/antialias/half_squares-inl.hpp"
#include "engine/antialias/least_search-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// How well a parabola tells how far f falls to its least on a ray beside the one that it was found
/// on, at best.
constexpr double least_doubt = 1.0 / 16;

HWY_INLINE M<double> either(M<double> which, M<double> a, M<double> b) {
    return hn::Or(hn::And(which, a), hn::AndNot(which, b));
}

/// sqrt(x^2 + y^2), also where the squares are beyond the range of double.
HWY_INLINE V<double> length_of(V<double> x, V<double> y) {
    const V<double> zero = hn::Zero(d<double>);
    const V<double> most = hn::Max(hn::Abs(x), hn::Abs(y));
    const V<double> part = hn::Div(hn::Min(hn::Abs(x), hn::Abs(y)), most);
    const V<double> length = hn::Mul(most, hn::Sqrt(hn::MulAdd(part, part, number(1.0))));
    return hn::IfThenElse(hn::Gt(most, zero), length, zero);
}

/// The search for the lines of some squares. Ray k of square i has the index k count + i.
class LineSearch {
public:
    LineSearch(const TileRays& rays, EdgeLines& squares) : rays_(rays), squares_(squares) {}

    void search(const TraceFrame& frame, Counters& counters) {
        squares_.all_rays ? search_all(frame, counters) : search_middles(frame, counters);
    }

private:
    using Five = std::array<V<double>, square_ray_count>;
    /// The heights at the rays of a vector of squares, and how far they can be trusted.
    struct Edges {
        Five height;      ///< at most 0: the ray has a root
        Five place;       ///< where f is least
        V<double> doubt;  ///< how far heights may be off
        M<double> known;  ///< whether heights may go smoothly with the place
        M<double> shown;  ///< no roots hide in stretches
        M<double> folds;  ///< there may be several roots before those that are found
    };

    void search_all(const TraceFrame& frame, Counters& counters);
    void search_middles(const TraceFrame& frame, Counters& counters);
    void load_rays(std::size_t rays);
    [[nodiscard]] HWY_INLINE Edges edges_of_all(std::size_t i) const;
    [[nodiscard]] HWY_INLINE Edges edges_by_middle(std::size_t i, const TileLines& tile) const;
    /// Decides a vector of squares.
    HWY_INLINE void decide(std::size_t i, const Edges& edges);
    HWY_INLINE void put_line(std::size_t i, const Edges& edges, const LinearOnSquares& fit);
    /// Writes the stretches of a square.
    void write(std::size_t i);
    /// Ray k of a vector of squares.
    [[nodiscard]] HWY_INLINE V<double> u_of(std::size_t k, std::size_t i) const {
        const double x = rays_.u(0.5 * squares_.side * square_rays[k].x);
        return hn::MulAdd(load(squares_.col.data() + i), number(rays_.pixel()), number(x));
    }
    [[nodiscard]] HWY_INLINE V<double> v_of(std::size_t k, std::size_t i) const {
        const double y = rays_.v(0.5 * squares_.side * square_rays[k].y);
        return hn::NegMulAdd(load(squares_.row.data() + i), number(rays_.pixel()), number(y));
    }
    [[nodiscard]] std::size_t ray(std::size_t k, std::size_t i) const {
        return k * squares_.count + i;
    }

    const TileRays& rays_;
    EdgeLines& squares_;
    std::size_t stride_ = 0;  ///< of the points of one ray
    LeastSearch least_;
    RayPoints points_;
};
static_assert(square_ray_count * EdgeLines::capacity_of_all_rays + lanes<double> <=
              LeastSearch::capacity);
static_assert(EdgeLines::capacity <= LeastSearch::capacity);
static_assert((square_ray_count - 1) * EdgeLines::capacity <= RayPoints::capacity);
static_assert(EdgeLines::capacity % batch_multiple == 0);

void LineSearch::load_rays(std::size_t rays) {
    const std::size_t count = squares_.count;
    for (std::size_t k = 0; k < rays; ++k) {
        // The last vector of a ray may reach beyond its squares: the next ray's first one
        // overwrites that.
        for (std::size_t i = 0; i < count; i += lanes<double>)
            least_.load_ray(ray(k, i), u_of(k, i), v_of(k, i), load(squares_.from.data() + i),
                            load(squares_.to.data() + i));
    }
    const std::size_t last = rays * count;
    least_.repeat_ray(last - 1, last, padded(last));
}

HWY_INLINE auto LineSearch::edges_of_all(std::size_t i) const -> Edges {
    const V<double> zero = hn::Zero(d<double>);
    const M<double> above = hn::Ge(least_.near_at(ray(0, i)), zero);
    Edges edges;
    edges.doubt = zero;
    M<double> differ = hn::Lt(zero, zero);
    edges.shown = differ;
    edges.folds = differ;
    V<double> size = zero;
    for (std::size_t k = 0; k < square_ray_count; ++k) {
        const V<double> near = least_.near_at(ray(k, i));
        const V<double> height = least_.least_at(ray(k, i));
        edges.height[k] = height;
        edges.place[k] = least_.place_at(ray(k, i));
        differ = hn::Or(differ, hn::Xor(above, hn::Ge(near, zero)));
        edges.shown = hn::Or(edges.shown, hn::Or(least_.inner_at(ray(k, i)), hn::Le(height, zero)));
        edges.folds = hn::Or(edges.folds, least_.wavers_at(ray(k, i)));
        size = hn::Add(size, hn::Add(hn::Abs(near), hn::Abs(height)));
    }
    edges.known = hn::AndNot(differ, hn::Lt(size, hn::Inf(d<double>)));
    return edges;
}

HWY_INLINE auto LineSearch::edges_by_middle(std::size_t i, const TileLines& tile) const -> Edges {
    const V<double> zero = hn::Zero(d<double>);
    const V<double> half = number(0.5);
    const V<double> sign = least_.sign_at(i);
    const V<double> near = hn::Mul(sign, least_.near_at(i));
    const V<double> from = load(squares_.from.data() + i);
    const V<double> to = load(squares_.to.data() + i);
    const V<double> place = least_.place_at(i);
    const M<double> inner = least_.inner_at(i);
    const Bends bends = least_.bends_at(i);
    const V<double> per_curvature = hn::Div(number(1.0), bends.curvature);
    const V<double> per_length = hn::Div(number(1.0), bends.length);
    // The other rays are a quarter of the side away; f keeps its sign at their near ends.
    const V<double> change = hn::Mul(number(0.25 * squares_.side), least_.near_change_at(i));
    const V<double> least_near = hn::NegMulAdd(number(2.0), change, near);
    Edges edges;
    edges.doubt = zero;
    edges.height[0] = least_.least_at(i);
    edges.place[0] = place;
    edges.known = hn::Gt(least_near, zero);
    edges.shown = hn::Or(inner, hn::Le(edges.height[0], zero));
    edges.folds = least_.wavers_at(i);
    V<double> size = hn::Add(near, hn::Abs(edges.height[0]));
    for (std::size_t k = 1; k < square_ray_count; ++k) {
        const std::size_t point = (k - 1) * stride_ + i;
        const V<double> f = hn::Mul(sign, points_.f_at(point));
        const V<double> slope = hn::Mul(
            sign, dot(points_.gradient_at(point), tile.at(u_of(k, i), v_of(k, i)).direction));
        // A parabola is least there; at the far end, towards which f falls, f is.
        const V<double> step = hn::Neg(hn::Mul(slope, per_curvature));
        const V<double> fall = hn::Mul(half, hn::Abs(hn::Mul(slope, step)));
        const V<double> there = hn::Add(place, step);
        const M<double> within = hn::And(hn::Ge(there, from), hn::Le(there, to));
        const M<double> falls = hn::And(hn::Le(slope, zero), hn::Lt(f, least_near));
        edges.known = hn::And(edges.known, either(inner, within, falls));
        edges.height[k] = hn::Sub(f, hn::IfThenElseZero(inner, fall));
        edges.place[k] = hn::IfThenElse(inner, there, place);
        edges.shown = hn::Or(edges.shown, hn::Le(edges.height[k], zero));
        // The cubic tells more of the doubt the farther the least is away.
        const V<double> ways = hn::MulAdd(hn::Abs(step), per_length, number(1.0));
        const V<double> part = hn::MulAdd(bends.doubt, ways, number(least_doubt));
        edges.doubt = hn::Max(edges.doubt, hn::IfThenElseZero(inner, hn::Mul(part, fall)));
        size = hn::Add(size, hn::Abs(edges.height[k]));
    }
    const M<double> bends_up = hn::Gt(bends.curvature, zero);
    const M<double> one_bend = either(inner, bends_up, hn::Eq(place, to));
    edges.known = hn::And(edges.known, hn::And(one_bend, hn::Lt(size, hn::Inf(d<double>))));
    return edges;
}

void LineSearch::search_all(const TraceFrame& frame, Counters& counters) {
    load_rays(square_ray_count);
    least_.search_loaded(frame, rays_, square_ray_count * squares_.count, counters);
    for (std::size_t i = 0; i < squares_.count; i += lanes<double>)
        decide(i, edges_of_all(i));
    for (std::size_t i = 0; i < squares_.count; ++i) {
        if (squares_.is_line[i] == 0.0) write(i);
    }
}

void LineSearch::search_middles(const TraceFrame& frame, Counters& counters) {
    load_rays(1);
    least_.search_loaded(frame, rays_, squares_.count, counters);
    const TileLines tile(rays_);
    stride_ = padded(squares_.count);
    for (std::size_t k = 1; k < square_ray_count; ++k) {
        for (std::size_t i = 0; i < stride_; i += lanes<double>)
            points_.ask((k - 1) * stride_ + i, tile.at(u_of(k, i), v_of(k, i)), least_.place_at(i));
    }
    points_.evaluate(frame, (square_ray_count - 1) * stride_);
    counters.value += (square_ray_count - 1) * squares_.count;
    for (std::size_t i = 0; i < squares_.count; i += lanes<double>)
        decide(i, edges_by_middle(i, tile));
}

HWY_INLINE void LineSearch::put_line(std::size_t i, const Edges& edges,
                                     const LinearOnSquares& fit) {
    const V<double> zero = hn::Zero(d<double>);
    const SquareParts part = parts_below_zero(fit);
    store(part.share, squares_.share.data() + i);
    store(part.x, squares_.x.data() + i);
    store(part.y, squares_.y.data() + i);
    // The ray with a root that is nearest to the part's middle; where none has one, the deepest.
    V<double> deepest = edges.height[0];
    V<double> end = edges.place[0];
    V<double> nearest = hn::Inf(d<double>);
    V<double> hits = zero;
    for (std::size_t k = 0; k < square_ray_count; ++k) {
        const V<double> height = edges.height[k];
        const M<double> hit = hn::Le(height, zero);
        const V<double> x = hn::Sub(part.x, number(square_rays[k].x));
        const V<double> y = hn::Sub(part.y, number(square_rays[k].y));
        const V<double> apart = hn::MulAdd(x, x, hn::Mul(y, y));
        const M<double> nearer = hn::And(hit, hn::Lt(apart, nearest));
        const M<double> deeper =
            hn::And(hn::Eq(nearest, hn::Inf(d<double>)), hn::Lt(height, deepest));
        end = hn::IfThenElse(hn::Or(nearer, deeper), edges.place[k], end);
        nearest = hn::IfThenElse(nearer, apart, nearest);
        deepest = hn::Min(deepest, height);
        hits = hn::Add(hits, hn::IfThenElseZero(hit, number(static_cast<double>(1U << k))));
    }
    store(end, squares_.end.data() + i);
    store(hits, squares_.hits.data() + i);
    store(flags(edges.folds), squares_.folds.data() + i);
}

HWY_INLINE void LineSearch::decide(std::size_t i, const Edges& edges) {
    // Fit a line to the heights, by the formulas of edge_fit.cpp.
    const Five& h = edges.height;
    const V<double> half = number(0.5);
    const V<double> left = hn::Add(h[1], h[3]);
    const V<double> right = hn::Add(h[2], h[4]);
    const V<double> off_mean = hn::MulSub(number(0.25), hn::Add(left, right), h[0]);
    const V<double> twist = hn::Sub(hn::Add(h[1], h[4]), hn::Add(h[2], h[3]));
    const LinearOnSquares fit{
        .value = hn::MulAdd(number(4.0 / 3.0), off_mean, h[0]),
        .by_x = hn::Mul(half, hn::Sub(right, left)),
        .by_y = hn::Mul(half, hn::Sub(hn::Add(h[3], h[4]), hn::Add(h[1], h[2])))};
    const V<double> bend = hn::Add(hn::Abs(off_mean), edges.doubt);
    const V<double> off = hn::MulAdd(half, hn::Abs(twist), hn::Mul(number(2.0), bend));
    const V<double> slope = length_of(fit.by_x, fit.by_y);
    M<double> clear = hn::Le(off, hn::Mul(number(squares_.rules.error), slope));
    if (squares_.rules.flat_too) {
        const V<double> least =
            hn::Sub(hn::Abs(fit.value), hn::Add(hn::Abs(fit.by_x), hn::Abs(fit.by_y)));
        clear = hn::Or(clear, hn::Gt(least, hn::Mul(number(4.0), off)));
    }
    clear = hn::And(clear, edges.known);
    if (squares_.rules.may_hide) clear = hn::And(clear, edges.shown);
    store(flags(clear), squares_.is_line.data() + i);
    put_line(i, edges, fit);
}

void LineSearch::write(std::size_t i) {
    for (std::size_t k = 0; k < square_ray_count; ++k) {
        RayStretch& stretch = squares_.stretches[i][k];
        stretch.col = squares_.col[i] + 0.5 * squares_.side * square_rays[k].x;
        stretch.row = squares_.row[i] + 0.5 * squares_.side * square_rays[k].y;
        stretch.from = squares_.from[i];
        stretch.to = squares_.to[i];
        least_.write(ray(k, i), stretch);
    }
}

void search_lines(const TraceFrame& frame, const TileRays& rays, EdgeLines& squares,
                  Counters& counters) {
    LineSearch(rays, squares).search(frame, counters);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(search_lines);

}  // namespace

void find_lines(const TraceFrame& frame, const TileRays& rays, EdgeLines& squares,
                Counters& counters) {
    HWY_DYNAMIC_DISPATCH(search_lines)(frame, rays, squares, counters);
}

}  // namespace zeroset

#endif
