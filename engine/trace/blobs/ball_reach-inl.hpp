// How far cells of beams reach from their middles, and what follows for the squares of distances
// from balls there; a cell a lane (ball_forms-inl.hpp). Included once for each instruction set,
// after Highway.

#if defined(ZEROSET_BALL_REACH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BALL_REACH_INL
#undef ZEROSET_BALL_REACH_INL
#else
#define ZEROSET_BALL_REACH_INL
#endif

#include "engine/real/lanes-inl.hpp"
#include "engine/trace/blobs/ball_sums.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Some cells of a bin, as many as there are lanes at most. In upward rounding.
template <class Real>
struct CellReach {
    using Lanes = Real[lanes<Real>];
    static constexpr double unit = std::numeric_limits<Real>::epsilon();

    /// The way from a ball's middle to the cell's.
    struct Way {
        V<Real> x, y, z;
    };
    /// Bounds of q, the square of the way from a ball times its per_square, on the cell.
    struct Squares {
        V<Real> middle, lo, hi;
        V<Real> linear_u, linear_v, linear_s;
        V<Real> linear;  ///< at most
        V<Real> rest;    ///< at most
        V<Real> beside;  ///< the part of it that is not quadratic in the place, at most
        V<Real> change;  ///< linear + rest
        V<Real> turn;    ///< of how the rest changes with es, at most
    };
    // The cells' middles; how far cells reach to both sides of these; bounds of these ways and of
    // their products.
    V<Real> u, v, at, start_x, start_y, w, way_u, way_v, way_s;
    V<Real> off, half_x, half_y, half_z, square, beside, tilt_u, tilt_v;
    V<Real> turn, turn_off, aside_x, aside_y, aside;

    CellReach(const BallForms& of, const BallBin& bin, const BallCells& cells, std::size_t first) {
        place(of, bin, cells, first);
        measure(of, bin, cells);
    }
    /// A bound that is made of a few sums and products of bounds.
    static HWY_INLINE V<Real> above(V<Real> bound) {
        return hn::Mul(bound, number<Real>(1 + 16 * unit));
    }
    HWY_INLINE Squares squares_of(const Way& from, V<Real> per_square) const {
        const auto twice = [&](V<Real> a) { return hn::Mul(hn::Add(a, a), per_square); };
        Squares q{};
        q.middle =
            hn::Mul(hn::MulAdd(from.x, from.x, hn::MulAdd(from.y, from.y, hn::Mul(from.z, from.z))),
                    per_square);
        const Way steep{twice(from.x), twice(from.y), twice(from.z)};
        q.linear_u = hn::Mul(steep.x, way_u);
        q.linear_v = hn::Mul(steep.y, way_v);
        q.linear_s = hn::Mul(hn::MulAdd(steep.x, u, hn::MulAdd(steep.y, v, steep.z)), way_s);
        const V<Real> size_x = hn::Abs(steep.x);
        const V<Real> size_y = hn::Abs(steep.y);
        const V<Real> sizes = hn::Add(hn::Add(size_x, size_y), hn::Abs(steep.z));
        q.linear =
            hn::Mul(hn::Add(hn::Abs(q.linear_u), hn::Add(hn::Abs(q.linear_v), hn::Abs(q.linear_s))),
                    number<Real>(1 + 16 * unit));
        const V<Real> tilted = hn::MulAdd(size_x, tilt_u, hn::Mul(size_y, tilt_v));
        const V<Real> moved = hn::Mul(sizes, off);
        q.beside = hn::MulAdd(per_square, beside, moved);
        q.rest = hn::MulAdd(square, per_square, hn::Add(tilted, moved));
        q.turn = hn::MulAdd(turn, per_square, tilted);
        q.change = hn::Add(q.linear, q.rest);
        const auto gap = [&](V<Real> a, V<Real> half) {
            return hn::Max(hn::Sub(hn::Abs(a), half), hn::Zero(d<Real>));
        };
        const Way gaps{gap(from.x, half_x), gap(from.y, half_y), gap(from.z, half_z)};
        const V<Real> nearest =
            hn::MulAdd(gaps.x, gaps.x, hn::MulAdd(gaps.y, gaps.y, hn::Mul(gaps.z, gaps.z)));
        // Differences of far larger numbers are known to the digits of these.
        const V<Real> spare = hn::Mul(number<Real>(16 * unit), q.middle);
        const V<Real> lo = hn::Sub(q.middle, hn::Add(q.linear, hn::Add(tilted, moved)));
        q.lo =
            hn::Max(hn::Sub(hn::Max(hn::Mul(nearest, per_square), lo), spare), hn::Zero(d<Real>));
        q.hi = hn::Add(hn::Add(q.middle, q.change), spare);
        return q;
    }

private:
    /// Takes in where the cells are.
    HWY_INLINE void place(const BallForms& of, const BallBin& bin, const BallCells& cells,
                          std::size_t first) {
        const std::size_t count = std::min(lanes<Real>, cells.count - first);
        alignas(64) Lanes columns[7];
        for (std::size_t i = 0; i < lanes<Real>; ++i) {
            const std::size_t cell = first + std::min(i, count - 1);
            const double depth = of.distance + cells.s[cell];
            columns[0][i] = static_cast<Real>(cells.u[cell]);
            columns[1][i] = static_cast<Real>(cells.v[cell]);
            columns[2][i] = static_cast<Real>(cells.s[cell] - bin.depth);
            columns[3][i] = static_cast<Real>(depth * (cells.u[cell] - bin.u));
            columns[4][i] = static_cast<Real>(depth * (cells.v[cell] - bin.v));
            columns[5][i] = static_cast<Real>(depth);
            columns[6][i] = static_cast<Real>(cells.s_radius[cell]);
        }
        const auto lane = [](const Lanes& numbers) { return hn::Load(d<Real>, numbers); };
        u = lane(columns[0]);
        v = lane(columns[1]);
        at = lane(columns[2]);
        start_x = lane(columns[3]);
        start_y = lane(columns[4]);
        w = lane(columns[5]);
        way_s = lane(columns[6]);
        way_u = hn::Mul(w, number<Real>(cells.u_radius));
        way_v = hn::Mul(w, number<Real>(cells.v_radius));
    }
    /// Sets the bounds of each cell's reach.
    HWY_INLINE void measure(const BallForms& of, const BallBin& bin, const BallCells& cells) {
        const auto sum3 = [](V<Real> a, V<Real> b, V<Real> c) { return hn::Add(hn::Add(a, b), c); };
        const auto twice = [](V<Real> a) { return hn::Add(a, a); };
        const V<Real> u_radius = number<Real>(cells.u_radius);
        const V<Real> v_radius = number<Real>(cells.v_radius);
        const V<Real> u_size = above(hn::Add(hn::Abs(u), u_radius));
        const V<Real> v_size = above(hn::Add(hn::Abs(v), v_radius));
        const V<Real> ways = above(hn::Add(hn::Abs(way_u), hn::Abs(way_v)));
        const V<Real> sizes = sum3(u_size, v_size, number<Real>(1));
        const V<Real> size = hn::MulAdd(sizes, way_s, ways);
        const V<Real> places = sum3(hn::Add(hn::Abs(start_x), hn::Abs(start_y)), hn::Abs(at), size);
        const V<Real> reach = hn::Add(number<Real>(bin.most_support), size);
        off = above(hn::MulAdd(number<Real>(16 * unit),
                               hn::MulAdd(hn::Add(sizes, number<Real>(1)), reach, places),
                               number<Real>(of.place_error)));
        half_x = above(sum3(hn::Abs(way_u), hn::Mul(u_size, way_s), off));
        half_y = above(sum3(hn::Abs(way_v), hn::Mul(v_size, way_s), off));
        half_z = above(hn::Add(way_s, off));
        square =
            above(sum3(hn::Mul(half_x, half_x), hn::Mul(half_y, half_y), hn::Mul(half_z, half_z)));
        tilt_u = above(hn::Mul(u_radius, way_s));
        tilt_v = above(hn::Mul(v_radius, way_s));
        // Bound how far the way is from being linear in the place.
        const V<Real> bent_x = hn::Add(tilt_u, off);
        const V<Real> bent_y = hn::Add(tilt_v, off);
        beside = above(
            twice(sum3(hn::Mul(half_x, bent_x), hn::Mul(half_y, bent_y), hn::Mul(half_z, off))));
        aside = above(sum3(hn::Mul(u_size, half_x), hn::Mul(v_size, half_y), half_z));
        turn = above(twice(hn::Mul(way_s, aside)));
        const V<Real> off_turn =
            hn::Add(sum3(hn::Mul(u_size, bent_x), hn::Mul(v_size, bent_y), off),
                    hn::Add(hn::Mul(u_radius, half_x), hn::Mul(v_radius, half_y)));
        turn_off = above(twice(hn::Mul(way_s, off_turn)));
        aside_x = above(hn::MulAdd(number<Real>(16 * unit), u_size, u_radius));
        aside_y = above(hn::MulAdd(number<Real>(16 * unit), v_size, v_radius));
    }
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
