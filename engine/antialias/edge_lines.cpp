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

/// The search for the lines of some squares. Ray k of square i has the index k count + i.
class LineSearch {
public:
    LineSearch(const TileRays& rays, EdgeLines& squares) : rays_(rays), squares_(squares) {}

    void search(const TraceFrame& frame, Counters& counters) {
        load_rays();
        least_.search_loaded(frame, rays_, square_ray_count * squares_.count, counters);
        for (std::size_t i = 0; i < squares_.count; i += lanes<double>)
            decide(i);
        for (std::size_t i = 0; i < squares_.count; ++i) {
            if (squares_.is_line[i] == 0.0) write(i);
        }
    }

private:
    using Five = std::array<V<double>, square_ray_count>;

    void load_rays();
    /// Decides a vector of squares.
    HWY_INLINE void decide(std::size_t i);
    HWY_INLINE void put_line(std::size_t i, const Five& heights, const LinearOnSquares& fit);
    /// Writes the stretches of a square.
    void write(std::size_t i);
    [[nodiscard]] std::size_t ray(std::size_t k, std::size_t i) const {
        return k * squares_.count + i;
    }

    const TileRays& rays_;
    EdgeLines& squares_;
    LeastSearch least_;
};
static_assert(square_ray_count * EdgeLines::room + lanes<double> <= LeastSearch::room);
static_assert(EdgeLines::room % lanes<double> == 0);

void LineSearch::load_rays() {
    const std::size_t count = squares_.count;
    const V<double> pixel = number(rays_.pixel());
    const V<double> u_first = number(rays_.u(0.0));
    const V<double> v_first = number(rays_.v(0.0));
    for (std::size_t k = 0; k < square_ray_count; ++k) {
        const V<double> x = number(0.5 * squares_.side * square_rays[k].x);
        const V<double> y = number(0.5 * squares_.side * square_rays[k].y);
        // What a last vector holds too much is written over by the next ray's, or comes last.
        for (std::size_t i = 0; i < count; i += lanes<double>) {
            const V<double> col = hn::Add(load(squares_.col.data() + i), x);
            const V<double> row = hn::Add(load(squares_.row.data() + i), y);
            least_.load_ray(ray(k, i), hn::MulAdd(col, pixel, u_first),
                            hn::NegMulAdd(row, pixel, v_first), load(squares_.from.data() + i),
                            load(squares_.to.data() + i));
        }
    }
    const std::size_t last = square_ray_count * count;
    least_.repeat_ray(last - 1, last, padded(last));
}

HWY_INLINE void LineSearch::put_line(std::size_t i, const Five& heights,
                                     const LinearOnSquares& fit) {
    const V<double> zero = hn::Zero(d<double>);
    const SquareParts part = parts_below_zero(fit);
    store(part.share, squares_.share.data() + i);
    store(part.x, squares_.x.data() + i);
    store(part.y, squares_.y.data() + i);
    // The ray with a root that is nearest to the part's middle; where none has one, the deepest.
    V<double> deepest = heights[0];
    V<double> end = least_.place_at(ray(0, i));
    V<double> nearest = hn::Inf(d<double>);
    V<double> hits = zero;
    for (std::size_t k = 0; k < square_ray_count; ++k) {
        const V<double> place = least_.place_at(ray(k, i));
        const M<double> hit = hn::Le(heights[k], zero);
        const V<double> x = hn::Sub(part.x, number(square_rays[k].x));
        const V<double> y = hn::Sub(part.y, number(square_rays[k].y));
        const V<double> apart = hn::MulAdd(x, x, hn::Mul(y, y));
        const M<double> nearer = hn::And(hit, hn::Lt(apart, nearest));
        const M<double> deeper =
            hn::And(hn::Eq(nearest, hn::Inf(d<double>)), hn::Lt(heights[k], deepest));
        end = hn::IfThenElse(hn::Or(nearer, deeper), place, end);
        nearest = hn::IfThenElse(nearer, apart, nearest);
        deepest = hn::Min(deepest, heights[k]);
        hits = hn::Add(hits, hn::IfThenElseZero(hit, number(static_cast<double>(1U << k))));
    }
    store(end, squares_.end.data() + i);
    store(hits, squares_.hits.data() + i);
}

HWY_INLINE void LineSearch::decide(std::size_t i) {
    const V<double> zero = hn::Zero(d<double>);
    Five h;
    const M<double> above = hn::Ge(least_.near_at(ray(0, i)), zero);
    M<double> differ = hn::Lt(zero, zero);
    M<double> any = differ;
    V<double> size = zero;
    for (std::size_t k = 0; k < square_ray_count; ++k) {
        const V<double> near = least_.near_at(ray(k, i));
        h[k] = least_.least_at(ray(k, i));
        differ = hn::Or(differ, hn::Xor(above, hn::Ge(near, zero)));
        any = hn::Or(any, hn::Or(least_.inner_at(ray(k, i)), hn::Le(h[k], zero)));
        size = hn::Add(size, hn::Add(hn::Abs(near), hn::Abs(h[k])));
    }
    // As fit_edge in edge_fit.cpp.
    const V<double> left = hn::Add(h[1], h[3]);
    const V<double> right = hn::Add(h[2], h[4]);
    const V<double> off_mean = hn::MulAdd(number(0.25), hn::Add(left, right), hn::Neg(h[0]));
    const V<double> twist = hn::Sub(hn::Add(h[1], h[4]), hn::Add(h[2], h[3]));
    const V<double> half = number(0.5);
    const LinearOnSquares fit{
        .value = hn::MulAdd(number(4.0 / 3.0), off_mean, h[0]),
        .by_x = hn::Mul(half, hn::Sub(right, left)),
        .by_y = hn::Mul(half, hn::Sub(hn::Add(h[3], h[4]), hn::Add(h[1], h[2])))};
    const V<double> off = hn::MulAdd(half, hn::Abs(twist), hn::Mul(number(2.0), hn::Abs(off_mean)));
    const V<double> slope = hn::Sqrt(hn::MulAdd(fit.by_x, fit.by_x, hn::Mul(fit.by_y, fit.by_y)));
    M<double> clear = hn::Le(off, hn::Mul(number(squares_.rules.error), slope));
    if (squares_.rules.flat_too) {
        const V<double> least =
            hn::Sub(hn::Abs(fit.value), hn::Add(hn::Abs(fit.by_x), hn::Abs(fit.by_y)));
        clear = hn::Or(clear, hn::Gt(least, hn::Mul(number(4.0), off)));
    }
    const M<double> known = hn::AndNot(differ, hn::Lt(size, hn::Inf(d<double>)));
    clear = hn::And(clear, known);
    if (squares_.rules.may_hide) clear = hn::And(clear, any);
    store(flags(clear), squares_.is_line.data() + i);
    put_line(i, h, fit);
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
