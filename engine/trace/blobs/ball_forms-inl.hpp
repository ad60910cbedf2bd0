// The sum of balls over cells of beams, a cell a lane, by Taylor's formula about the middle.
//   eu, ev, es   the place in the cell: each in [-1, 1]
//   way          the place's from the middle, up to `off_`: linear in these but for eu es and ev es
//   q            the square of the distance from the ball by its radius: over the cell it is
//                  q + linear + rest,  linear in eu, ev, es
//   h(q)         the ball's height: convex, falling, with a continuous derivative; h'' is between
//                two bounds on the cell
// So the sum is a constant, a linear and a quadratic form, and a rest of third order; bends of
// balls that cancel each other do so here, too.
//
// What is proved: places and directions are known to an error, `off_`, by which the cell is taken
// to be larger; each result is rounded a few times, which `rounding_` bounds by its size.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BALL_FORMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BALL_FORMS_INL
#undef ZEROSET_BALL_FORMS_INL
#else
#define ZEROSET_BALL_FORMS_INL
#endif

#include "engine/trace/blobs/ball_curves-inl.hpp"
#include "engine/trace/blobs/ball_sums.hpp"
#include "engine/trace/simd/vectors-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Calls visit(ball) for those of a bin that may reach what is between two of its depths.
HWY_INLINE void each_ball_between(const BallBin& bin, double first, double last,
                                  const auto& visit) {
    for (std::size_t i = 0; i < bin.count; ++i) {
        if (static_cast<double>(bin.from[i]) > last) break;
        if (static_cast<double>(bin.to[i]) >= first) visit(i);
    }
}

/// Some cells of a bin, as many as there are lanes at most.
template <class Real, BlobKind kind>
class CellSums {
public:
    CellSums(const BallForms& of, const BallBin& bin, const BallCells& cells, std::size_t first)
        : of_(of),
          bin_(bin),
          balls_(bin.columns<Real>()),
          cells_(cells),
          first_(first),
          count_(std::min(lanes<Real>, cells.count - first)) {}

    void write(BallForm* forms) {
        place();
        measure();
        clear();
        const Vector half = half_z_;
        const auto end_of = [&](Vector at) { return static_cast<double>(hn::GetLane(at)); };
        each_ball_between(bin_, end_of(hn::MinOfLanes(d<Real>, hn::Sub(at_, half))),
                          end_of(hn::MaxOfLanes(d<Real>, hn::Add(at_, half))),
                          [&](std::size_t i) { add(i); });
        write_results(forms);
    }

private:
    using Vector = V<Real>;
    using Mask = M<Real>;
    using Lanes = Real[lanes<Real>];
    static constexpr BlobFacts facts = blob_facts(kind);
    static constexpr double unit = std::numeric_limits<Real>::epsilon();

    static HWY_INLINE Vector number(double x) { return hn::Set(d<Real>, static_cast<Real>(x)); }
    static HWY_INLINE Vector zero() { return hn::Zero(d<Real>); }
    static HWY_INLINE Vector same(Real x) { return hn::Set(d<Real>, x); }

    /// Takes in where the cells are.
    HWY_INLINE void place() {
        alignas(64) Lanes u, v, at, start_x, start_y, w, way_s;
        for (std::size_t i = 0; i < lanes<Real>; ++i) {
            const std::size_t cell = first_ + std::min(i, count_ - 1);
            const double depth = of_.distance + cells_.s[cell];
            u[i] = static_cast<Real>(cells_.u[cell]);
            v[i] = static_cast<Real>(cells_.v[cell]);
            at[i] = static_cast<Real>(cells_.s[cell] - bin_.depth);
            start_x[i] = static_cast<Real>(depth * (cells_.u[cell] - bin_.u));
            start_y[i] = static_cast<Real>(depth * (cells_.v[cell] - bin_.v));
            w[i] = static_cast<Real>(depth);
            way_s[i] = static_cast<Real>(cells_.s_radius[cell]);
        }
        const auto lane = [](const Lanes& numbers) { return hn::Load(d<Real>, numbers); };
        u_ = lane(u);
        v_ = lane(v);
        at_ = lane(at);
        start_x_ = lane(start_x);
        start_y_ = lane(start_y);
        w_ = lane(w);
        way_s_ = lane(way_s);
        way_u_ = hn::Mul(w_, number(cells_.u_radius));
        way_v_ = hn::Mul(w_, number(cells_.v_radius));
    }
    /// A bound that is made of a few sums and products of bounds, in upward rounding.
    static HWY_INLINE Vector above(Vector bound) { return hn::Mul(bound, number(1 + 16 * unit)); }
    /// Sets the bounds of each cell's reach.
    HWY_INLINE void measure() {
        const auto sum3 = [](Vector a, Vector b, Vector c) { return hn::Add(hn::Add(a, b), c); };
        const auto twice = [](Vector a) { return hn::Add(a, a); };
        const Vector u_radius = number(cells_.u_radius);
        const Vector v_radius = number(cells_.v_radius);
        const Vector u_size = above(hn::Add(hn::Abs(u_), u_radius));
        const Vector v_size = above(hn::Add(hn::Abs(v_), v_radius));
        const Vector ways = above(hn::Add(hn::Abs(way_u_), hn::Abs(way_v_)));
        const Vector sizes = sum3(u_size, v_size, number(1));
        const Vector size = hn::MulAdd(sizes, way_s_, ways);
        const Vector places =
            sum3(hn::Add(hn::Abs(start_x_), hn::Abs(start_y_)), hn::Abs(at_), size);
        const Vector reach = hn::Add(number(bin_.most_support), size);
        const Vector off =
            hn::MulAdd(number(16 * unit), hn::MulAdd(hn::Add(sizes, number(1)), reach, places),
                       number(of_.place_error));
        off_ = above(off);
        half_x_ = above(sum3(hn::Abs(way_u_), hn::Mul(u_size, way_s_), off_));
        half_y_ = above(sum3(hn::Abs(way_v_), hn::Mul(v_size, way_s_), off_));
        half_z_ = above(hn::Add(way_s_, off_));
        square_ = above(
            sum3(hn::Mul(half_x_, half_x_), hn::Mul(half_y_, half_y_), hn::Mul(half_z_, half_z_)));
        tilt_u_ = above(hn::Mul(u_radius, way_s_));
        tilt_v_ = above(hn::Mul(v_radius, way_s_));
        // By so much the way is not linear in the place.
        const Vector bent_x = hn::Add(tilt_u_, off_);
        const Vector bent_y = hn::Add(tilt_v_, off_);
        beside_ = above(twice(
            sum3(hn::Mul(half_x_, bent_x), hn::Mul(half_y_, bent_y), hn::Mul(half_z_, off_))));
        aside_ = above(sum3(hn::Mul(u_size, half_x_), hn::Mul(v_size, half_y_), half_z_));
        turn_ = above(twice(hn::Mul(way_s_, aside_)));
        const Vector off_turn =
            hn::Add(sum3(hn::Mul(u_size, bent_x), hn::Mul(v_size, bent_y), off_),
                    hn::Add(hn::Mul(u_radius, half_x_), hn::Mul(v_radius, half_y_)));
        turn_off_ = above(twice(hn::Mul(way_s_, off_turn)));
        aside_x_ = above(hn::MulAdd(number(16 * unit), u_size, u_radius));
        aside_y_ = above(hn::MulAdd(number(16 * unit), v_size, v_radius));
    }

    /// From a ball's middle to the cell's.
    struct Place {
        Vector x, y, z;
    };
    /// What is known of q on the cell.
    struct Squares {
        Vector middle, lo, hi;
        Vector linear_u, linear_v, linear_s;
        Vector linear;  ///< at most
        Vector rest;    ///< at most
        Vector beside;  ///< what of it is not quadratic in the place, at most
        Vector change;  ///< linear + rest
        Vector turn;    ///< of how the rest changes with es, at most
    };
    HWY_INLINE Squares squares_of(const Place& from, Vector per_square) const {
        const auto twice = [&](Vector a) { return hn::Mul(hn::Add(a, a), per_square); };
        Squares q{};
        q.middle =
            hn::Mul(hn::MulAdd(from.x, from.x, hn::MulAdd(from.y, from.y, hn::Mul(from.z, from.z))),
                    per_square);
        const Place steep{twice(from.x), twice(from.y), twice(from.z)};
        q.linear_u = hn::Mul(steep.x, way_u_);
        q.linear_v = hn::Mul(steep.y, way_v_);
        q.linear_s = hn::Mul(hn::MulAdd(steep.x, u_, hn::MulAdd(steep.y, v_, steep.z)), way_s_);
        const Vector size_x = hn::Abs(steep.x);
        const Vector size_y = hn::Abs(steep.y);
        const Vector sizes = hn::Add(hn::Add(size_x, size_y), hn::Abs(steep.z));
        q.linear =
            hn::Mul(hn::Add(hn::Abs(q.linear_u), hn::Add(hn::Abs(q.linear_v), hn::Abs(q.linear_s))),
                    number(1 + 16 * unit));
        const Vector tilted = hn::MulAdd(size_x, tilt_u_, hn::Mul(size_y, tilt_v_));
        const Vector off = hn::Mul(sizes, off_);
        q.beside = hn::MulAdd(per_square, beside_, off);
        q.rest = hn::MulAdd(square_, per_square, hn::Add(tilted, off));
        q.turn = hn::MulAdd(turn_, per_square, tilted);
        q.change = hn::Add(q.linear, q.rest);
        const auto gap = [&](Vector a, Vector half) {
            return hn::Max(hn::Sub(hn::Abs(a), half), zero());
        };
        const Place gaps{gap(from.x, half_x_), gap(from.y, half_y_), gap(from.z, half_z_)};
        const Vector nearest =
            hn::MulAdd(gaps.x, gaps.x, hn::MulAdd(gaps.y, gaps.y, hn::Mul(gaps.z, gaps.z)));
        // Differences of far larger numbers are known to the digits of these.
        const Vector spare = hn::Mul(number(16 * unit), q.middle);
        const Vector lo = hn::Sub(q.middle, hn::Add(q.linear, hn::Add(tilted, off)));
        q.lo =
            hn::Max(hn::Sub(hn::Max(hn::Mul(nearest, per_square), lo), spare), hn::Zero(d<Real>));
        q.hi = hn::Add(hn::Add(q.middle, q.change), spare);
        return q;
    }

    HWY_INLINE void add(std::size_t i) {
        const Vector reach = number(facts.reach);
        const Vector z = hn::Sub(at_, same(balls_.z[i]));
        const Place from{hn::MulAdd(number(bin_.u), z, hn::Sub(start_x_, same(balls_.x[i]))),
                         hn::MulAdd(number(bin_.v), z, hn::Sub(start_y_, same(balls_.y[i]))), z};
        const Vector per_square = same(balls_.per_square[i]);
        const Squares q = squares_of(from, per_square);
        const Mask reached = hn::Lt(q.lo, reach);
        if (hn::AllFalse(d<Real>, reached)) return;
        const auto height_up_to_reach = [&](Vector of) {
            auto h = height_at<kind, Rounds::Once>(d<Real>, hn::Min(of, reach));
            const Mask inside = hn::Lt(of, reach);
            h.value = hn::IfThenElseZero(inside, h.value);
            h.slope = hn::IfThenElseZero(inside, h.slope);
            return h;
        };
        const auto middle = height_up_to_reach(q.middle);
        const auto top = height_up_to_reach(q.lo);
        const auto end = height_up_to_reach(q.hi);
        const Vector strength = same(balls_.strength[i]);
        // What is not reached may overflow.
        const auto add_to = [&](Vector& sum, Vector term) {
            sum = hn::Add(sum, hn::IfThenElseZero(reached, term));
        };
        add_to(c_, hn::Mul(strength, middle.value));
        const Vector steep = hn::Mul(strength, middle.slope);
        add_to(along_u_, hn::Mul(steep, q.linear_u));
        add_to(along_v_, hn::Mul(steep, q.linear_v));
        add_to(along_s_, hn::Mul(steep, q.linear_s));
        add_to(round_, hn::Mul(steep, per_square));
        const auto curves = curves_between<kind>(d<Real>, q.lo, q.hi);
        const Vector curve = hn::Mul(number(0.5), hn::Add(curves.least, curves.most));
        const Vector unsure = hn::Mul(number(0.5), hn::Sub(curves.most, curves.least));
        const Vector bent = hn::Mul(number(0.5), hn::Mul(strength, curve));
        const Vector bent_u = hn::Mul(bent, q.linear_u);
        const Vector bent_v = hn::Mul(bent, q.linear_v);
        add_to(bend_uu_, hn::Mul(bent_u, q.linear_u));
        add_to(bend_vv_, hn::Mul(bent_v, q.linear_v));
        add_to(bend_uv_, hn::Mul(bent_u, q.linear_v));
        add_to(bend_us_, hn::Mul(bent_u, q.linear_s));
        add_to(bend_vs_, hn::Mul(bent_v, q.linear_s));
        add_to(bend_ss_, hn::Mul(hn::Mul(bent, q.linear_s), q.linear_s));
        // 1/2 h'' change^2 is 1/2 curve linear^2 up to this, and h' rest quadratic up to h' beside.
        const Vector size = hn::Abs(strength);
        const Vector flat = hn::Abs(middle.slope);
        const Vector square = hn::Mul(q.change, q.change);
        const Vector mixed = hn::Mul(q.rest, hn::Add(hn::Add(q.linear, q.linear), q.rest));
        const Vector half = number(0.5);
        const Vector third =
            hn::MulAdd(hn::Mul(half, unsure), square,
                       hn::MulAdd(hn::Mul(half, curve), mixed, hn::Mul(flat, q.beside)));
        // The largest numbers that were rounded; and how far heights beyond the reach are from 0.
        const Vector sizes =
            hn::MulAdd(hn::Mul(half, curves.most), square,
                       hn::MulAdd(number(facts.bend), q.change, number(facts.top)));
        const Vector beyond = hn::MulAdd(number(4 * facts.tail), q.change, number(facts.tail));
        const Vector rounded = hn::MulAdd(number(64 * unit), sizes, beyond);
        add_to(third_, hn::Mul(size, third));
        add_to(rounding_, hn::Mul(size, rounded));
        const Vector along = hn::Abs(q.linear_s);
        const Vector turning =
            hn::MulAdd(unsure, hn::Mul(q.change, along),
                       hn::MulAdd(curve, hn::Mul(q.rest, along),
                                  hn::Mul(hn::Mul(curves.most, q.change), q.turn)));
        const Vector beside = hn::Mul(flat, hn::MulAdd(per_square, turn_off_, zero()));
        add_to(turning_, hn::Mul(size, hn::Add(turning, beside)));
        const Mask hollow = hn::Lt(strength, zero());
        const Vector least = hn::Mul(strength, end.value);
        const Vector most = hn::Mul(strength, top.value);
        add_to(range_lo_, hn::IfThenElse(hollow, most, least));
        add_to(range_hi_, hn::IfThenElse(hollow, least, most));
        add_slope(from, top.slope, end.slope, hn::Mul(strength, per_square), reached);
    }

    /// The slope along the rays is 2 s h'(q) / r^2 times how far along its direction a place is
    /// from the ball.
    HWY_INLINE void add_slope(const Place& from, Vector steepest, Vector flattest, Vector weight,
                              Mask reached) {
        const Vector along = hn::MulAdd(u_, from.x, hn::MulAdd(v_, from.y, from.z));
        const Vector half =
            hn::MulAdd(hn::Abs(from.x), aside_x_,
                       hn::MulAdd(hn::Abs(from.y), aside_y_,
                                  hn::MulAdd(hn::Abs(from.z), number(16 * unit), aside_)));
        const Vector near = hn::Sub(along, half);
        const Vector far = hn::Add(along, half);
        const Vector least = hn::Mul(hn::IfThenElse(hn::Gt(far, zero()), steepest, flattest), far);
        const Vector most = hn::Mul(hn::IfThenElse(hn::Lt(near, zero()), steepest, flattest), near);
        const Vector twice = hn::Add(weight, weight);
        const Vector a = hn::Mul(twice, least);
        const Vector b = hn::Mul(twice, most);
        const Mask hollow = hn::Lt(weight, zero());
        const auto add_to = [&](Vector& sum, Vector term) {
            sum = hn::Add(sum, hn::IfThenElseZero(reached, term));
        };
        add_to(slope_lo_, hn::IfThenElse(hollow, b, a));
        add_to(slope_hi_, hn::IfThenElse(hollow, a, b));
        add_to(slope_size_, hn::Mul(hn::Mul(hn::Abs(twice), number(facts.bend)),
                                    hn::Max(hn::Abs(near), hn::Abs(far))));
    }

    HWY_INLINE void clear() {
        for (Vector* const sum :
             {&c_, &along_u_, &along_v_, &along_s_, &round_, &bend_uu_, &bend_vv_, &bend_ss_,
              &bend_uv_, &bend_us_, &bend_vs_, &third_, &turning_, &range_lo_, &range_hi_,
              &rounding_, &slope_lo_, &slope_hi_, &slope_size_})
            *sum = zero();
    }

    HWY_INLINE void write_results(BallForm* forms) const {
        const auto count = static_cast<double>(bin_.count);
        const Vector level = number(of_.level);
        const Vector half = number(0.5);
        Vector c = hn::Sub(c_, level);
        const Vector spare = above(hn::MulAdd(number(1 + count / 64), rounding_,
                                              number(of_.tail + 256 * unit * std::abs(of_.level))));
        // What is quadratic in the place; of eu es and ev es, rays that part add some.
        const Vector tilt = hn::Div(way_s_, w_);
        const Vector round_s = hn::Mul(round_, way_s_);
        const Vector square = hn::MulAdd(u_, u_, hn::MulAdd(v_, v_, number(1)));
        const Vector uu = hn::MulAdd(hn::Mul(round_, way_u_), way_u_, bend_uu_);
        const Vector vv = hn::MulAdd(hn::Mul(round_, way_v_), way_v_, bend_vv_);
        const Vector ss = hn::MulAdd(hn::Mul(round_s, square), way_s_, bend_ss_);
        const auto mixed = [&](Vector bend, Vector way, Vector direction, Vector along) {
            const Vector sum = hn::MulAdd(hn::Mul(round_s, way), direction, bend);
            return hn::MulAdd(along, tilt, hn::Add(sum, sum));
        };
        const Vector us = hn::Abs(mixed(bend_us_, way_u_, u_, along_u_));
        const Vector vs = hn::Abs(mixed(bend_vs_, way_v_, v_, along_v_));
        const Vector size_uu = hn::Abs(uu);
        const Vector size_vv = hn::Abs(vv);
        const Vector size_ss = hn::Abs(ss);
        const Vector uv = hn::Abs(hn::Add(bend_uv_, bend_uv_));
        c = hn::MulAdd(half, hn::Add(hn::Add(uu, vv), ss), c);
        const Vector bends = hn::Add(hn::Mul(half, hn::Add(hn::Add(size_uu, size_vv), size_ss)),
                                     hn::Add(hn::Add(us, vs), uv));
        const Vector error = above(hn::Add(hn::Add(bends, third_), spare));
        const Vector turn = above(hn::Add(hn::Add(hn::Add(size_ss, size_ss), hn::Add(us, vs)),
                                          hn::Mul(turning_, number(1 + 0x1p-10))));
        const Vector slope_spare =
            above(hn::MulAdd(number((64 + count) * unit), slope_size_, number(of_.slope_tail)));
        const Vector unknown = hn::Inf(d<Real>);
        const Mask is_long = hn::Gt(way_s_, zero());
        const Vector per_way = hn::Div(number(1), way_s_);
        const Vector rounded = hn::Mul(number(16 * unit), hn::Abs(along_s_));
        const Vector spread_s = hn::Mul(hn::Add(turn, rounded), per_way);
        const Vector slope_s = hn::Mul(along_s_, per_way);
        const Vector least = hn::IfThenElse(is_long, hn::Sub(slope_s, spread_s), hn::Neg(unknown));
        const Vector most = hn::IfThenElse(is_long, hn::Add(slope_s, spread_s), unknown);
        // Over large cells the heights' ranges tell more.
        const Vector lo = hn::Sub(range_lo_, level);
        const Vector hi = hn::Sub(range_hi_, level);
        const Vector radius = hn::Mul(half, hn::Sub(hi, lo));
        const Vector range_error = above(hn::Add(radius, hn::Add(spare, spare)));
        const Vector spread = hn::Add(hn::Add(hn::Abs(along_u_), hn::Abs(along_v_)),
                                      hn::Add(hn::Abs(along_s_), error));
        const Vector far = hn::Mul(number(4), spare);
        const Mask rejects = hn::Or(hn::Gt(lo, far), hn::Lt(hi, hn::Neg(far)));
        const Vector enough = hn::IfThenElse(rejects, spread, hn::Mul(half, spread));
        const Mask by_range = hn::Lt(range_error, enough);
        const auto linear = [&](Vector k) { return hn::IfThenZeroElse(by_range, k); };
        const Vector results[] = {hn::IfThenElse(by_range, hn::Mul(half, hn::Add(lo, hi)), c),
                                  linear(along_u_),
                                  linear(along_v_),
                                  linear(along_s_),
                                  hn::IfThenElse(by_range, range_error, error),
                                  hn::Sub(hn::Max(least, slope_lo_), slope_spare),
                                  hn::Add(hn::Min(most, slope_hi_), slope_spare)};
        alignas(64) Lanes numbers[std::size(results)];
        for (std::size_t k = 0; k < std::size(results); ++k)
            hn::Store(results[k], d<Real>, numbers[k]);
        for (std::size_t i = 0; i < count_; ++i) {
            const auto at = [&](std::size_t k) { return static_cast<double>(numbers[k][i]); };
            forms[first_ + i] = {.c = at(0),
                                 .along = {at(1), at(2), at(3)},
                                 .error = at(4),
                                 .slope_lo = at(5),
                                 .slope_hi = at(6)};
        }
    }

    const BallForms& of_;
    const BallBin& bin_;
    const BinColumns<Real>& balls_;
    const BallCells& cells_;
    std::size_t first_, count_;
    // Of each cell: its middle; how far it reaches to both sides of that; bounds of these ways and
    // of their products.
    Vector u_, v_, at_, start_x_, start_y_, w_, way_u_, way_v_, way_s_;
    Vector off_, half_x_, half_y_, half_z_, square_, beside_, tilt_u_, tilt_v_;
    Vector turn_, turn_off_, aside_x_, aside_y_, aside_;
    Vector c_, along_u_, along_v_, along_s_;
    Vector round_;  ///< of h' / r^2
    Vector bend_uu_, bend_vv_, bend_ss_, bend_uv_, bend_us_, bend_vs_;
    Vector third_, turning_;  ///< of third order: of f, and of its slope
    Vector range_lo_, range_hi_, rounding_;
    Vector slope_lo_, slope_hi_, slope_size_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
