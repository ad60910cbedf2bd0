// The sum of balls over cells of beams, a cell a lane, by Taylor's formula about the middle.
//   eu, ev, es   the place in the cell: each in [-1, 1]
//   way          from the middle to the place, up to `CellReach::off`: linear in eu, ev, es but for
//                the terms in eu es and ev es
//   q            the square of the distance from the ball by its radius; over the cell it is
//                  q in the middle + linear + rest,  linear in eu, ev, es
//   h(q)         the ball's height: convex, falling, with a continuous derivative; h'' is between
//                two bounds on the cell
// So the sum is a constant, a linear and a quadratic form, and a rest of third order; bends of
// balls that cancel each other do so here, too.
//
// The enclosures are proved as follows: places and directions are known to an error,
// `CellReach::off`, by which the cell is taken to be larger; each result is rounded a few times,
// which `rounding_` bounds by its size. Included once for each instruction set, after Highway.

#if defined(ZEROSET_BALL_FORMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BALL_FORMS_INL
#undef ZEROSET_BALL_FORMS_INL
#else
#define ZEROSET_BALL_FORMS_INL
#endif

#include "engine/real/lanes-inl.hpp"
#include "engine/trace/blobs/ball_curves-inl.hpp"
#include "engine/trace/blobs/ball_reach-inl.hpp"
#include "engine/trace/blobs/ball_sums.hpp"

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
          first_(first),
          count_(std::min(lanes<Real>, cells.count - first)),
          reach_(of, bin, cells, first) {}

    void write(BallForm* forms) {
        clear();
        const V<Real> half = reach_.half_z;
        const auto end_of = [&](V<Real> at) { return static_cast<double>(hn::GetLane(at)); };
        each_ball_between(bin_, end_of(hn::MinOfLanes(d<Real>, hn::Sub(reach_.at, half))),
                          end_of(hn::MaxOfLanes(d<Real>, hn::Add(reach_.at, half))),
                          [&](std::size_t i) { add(i); });
        write_results(forms);
    }

private:
    using Lanes = Real[lanes<Real>];
    using Way = CellReach<Real>::Way;
    using Squares = CellReach<Real>::Squares;
    static constexpr BlobFacts facts = blob_facts(kind);
    static constexpr double unit = std::numeric_limits<Real>::epsilon();

    static HWY_INLINE V<Real> zero() { return hn::Zero(d<Real>); }
    static HWY_INLINE V<Real> same(Real x) { return hn::Set(d<Real>, x); }

    HWY_INLINE void add(std::size_t i) {
        const V<Real> reach = number<Real>(facts.reach);
        // Find where the cells are from the ball, and skip it if it reaches none.
        const V<Real> z = hn::Sub(reach_.at, same(balls_.z[i]));
        const Way from{
            hn::MulAdd(number<Real>(bin_.u), z, hn::Sub(reach_.start_x, same(balls_.x[i]))),
            hn::MulAdd(number<Real>(bin_.v), z, hn::Sub(reach_.start_y, same(balls_.y[i]))), z};
        const V<Real> per_square = same(balls_.per_square[i]);
        const Squares q = reach_.squares_of(from, per_square);
        const M<Real> reached = hn::Lt(q.lo, reach);
        if (hn::AllFalse(d<Real>, reached)) return;
        const auto height_up_to_reach = [&](V<Real> of) {
            auto h = height_at<kind, Rounds::Once>(d<Real>, hn::Min(of, reach));
            const M<Real> inside = hn::Lt(of, reach);
            h.value = hn::IfThenElseZero(inside, h.value);
            h.slope = hn::IfThenElseZero(inside, h.slope);
            return h;
        };
        // Evaluate the height in the middle of the cells, and where they are nearest and farthest.
        const auto middle = height_up_to_reach(q.middle);
        const auto top = height_up_to_reach(q.lo);
        const auto end = height_up_to_reach(q.hi);
        const V<Real> strength = same(balls_.strength[i]);
        add_linear(q, middle, strength, per_square, reached);
        add_bends(q, hn::Abs(middle.slope), strength, per_square, reached);
        // Add the ranges of the height and of its slope along the rays.
        const M<Real> hollow = hn::Lt(strength, zero());
        const V<Real> least = hn::Mul(strength, end.value);
        const V<Real> most = hn::Mul(strength, top.value);
        add_in(reached, hn::IfThenElse(hollow, most, least), range_lo_);
        add_in(reached, hn::IfThenElse(hollow, least, most), range_hi_);
        add_slope(from, top.slope, end.slope, hn::Mul(strength, per_square), reached);
    }
    /// Adds a term in those lanes that a ball reaches: in others it may overflow.
    static HWY_INLINE void add_in(M<Real> reached, V<Real> term, V<Real>& sum) {
        sum = hn::Add(sum, hn::IfThenElseZero(reached, term));
    }
    HWY_INLINE void add_linear(const Squares& q, const HeightOf<V<Real>>& middle, V<Real> strength,
                               V<Real> per_square, M<Real> reached) {
        const auto add_to = [&](V<Real>& sum, V<Real> term) { add_in(reached, term, sum); };
        add_to(c_, hn::Mul(strength, middle.value));
        const V<Real> steep = hn::Mul(strength, middle.slope);
        add_to(along_u_, hn::Mul(steep, q.linear_u));
        add_to(along_v_, hn::Mul(steep, q.linear_v));
        add_to(along_s_, hn::Mul(steep, q.linear_s));
        add_to(round_, hn::Mul(steep, per_square));
    }
    /// Adds the quadratic terms, and bounds of the rest.
    HWY_INLINE void add_bends(const Squares& q, V<Real> flat, V<Real> strength, V<Real> per_square,
                              M<Real> reached) {
        const auto add_to = [&](V<Real>& sum, V<Real> term) { add_in(reached, term, sum); };
        const auto curves = curves_between<kind>(d<Real>, q.lo, q.hi);
        const V<Real> curve = hn::Mul(number<Real>(0.5), hn::Add(curves.least, curves.most));
        const V<Real> unsure = hn::Mul(number<Real>(0.5), hn::Sub(curves.most, curves.least));
        const V<Real> bent = hn::Mul(number<Real>(0.5), hn::Mul(strength, curve));
        const V<Real> bent_u = hn::Mul(bent, q.linear_u);
        const V<Real> bent_v = hn::Mul(bent, q.linear_v);
        add_to(bend_uu_, hn::Mul(bent_u, q.linear_u));
        add_to(bend_vv_, hn::Mul(bent_v, q.linear_v));
        add_to(bend_uv_, hn::Mul(bent_u, q.linear_v));
        add_to(bend_us_, hn::Mul(bent_u, q.linear_s));
        add_to(bend_vs_, hn::Mul(bent_v, q.linear_s));
        add_to(bend_ss_, hn::Mul(hn::Mul(bent, q.linear_s), q.linear_s));
        // Bound how far 1/2 h'' change^2 is from 1/2 curve linear^2, and the part of h' rest that
        // is not quadratic.
        const V<Real> size = hn::Abs(strength);
        const V<Real> square = hn::Mul(q.change, q.change);
        const V<Real> mixed = hn::Mul(q.rest, hn::Add(hn::Add(q.linear, q.linear), q.rest));
        const V<Real> half = number<Real>(0.5);
        const V<Real> third =
            hn::MulAdd(hn::Mul(half, unsure), square,
                       hn::MulAdd(hn::Mul(half, curve), mixed, hn::Mul(flat, q.beside)));
        // Bound the numbers that were rounded, and how far heights beyond the reach are from 0.
        const V<Real> sizes =
            hn::MulAdd(hn::Mul(half, curves.most), square,
                       hn::MulAdd(number<Real>(facts.bend), q.change, number<Real>(facts.top)));
        const V<Real> beyond =
            hn::MulAdd(number<Real>(4 * facts.tail), q.change, number<Real>(facts.tail));
        const V<Real> rounded = hn::MulAdd(number<Real>(64 * unit), sizes, beyond);
        add_to(third_, hn::Mul(size, third));
        add_to(rounding_, hn::Mul(size, rounded));
        // Bound how the slope along the rays changes beyond the quadratic terms.
        const V<Real> along = hn::Abs(q.linear_s);
        const V<Real> turning =
            hn::MulAdd(unsure, hn::Mul(q.change, along),
                       hn::MulAdd(curve, hn::Mul(q.rest, along),
                                  hn::Mul(hn::Mul(curves.most, q.change), q.turn)));
        const V<Real> beside = hn::Mul(flat, hn::MulAdd(per_square, reach_.turn_off, zero()));
        add_to(turning_, hn::Mul(size, hn::Add(turning, beside)));
    }

    /// The slope along the rays is 2 s h'(q) / r^2 times how far along its direction a place is
    /// from the ball.
    HWY_INLINE void add_slope(const Way& from, V<Real> steepest, V<Real> flattest, V<Real> weight,
                              M<Real> reached) {
        const V<Real> along = hn::MulAdd(reach_.u, from.x, hn::MulAdd(reach_.v, from.y, from.z));
        const V<Real> half = hn::MulAdd(
            hn::Abs(from.x), reach_.aside_x,
            hn::MulAdd(hn::Abs(from.y), reach_.aside_y,
                       hn::MulAdd(hn::Abs(from.z), number<Real>(16 * unit), reach_.aside)));
        const V<Real> near = hn::Sub(along, half);
        const V<Real> far = hn::Add(along, half);
        const V<Real> least = hn::Mul(hn::IfThenElse(hn::Gt(far, zero()), steepest, flattest), far);
        const V<Real> most =
            hn::Mul(hn::IfThenElse(hn::Lt(near, zero()), steepest, flattest), near);
        const V<Real> twice = hn::Add(weight, weight);
        const V<Real> a = hn::Mul(twice, least);
        const V<Real> b = hn::Mul(twice, most);
        const M<Real> hollow = hn::Lt(weight, zero());
        const auto add_to = [&](V<Real>& sum, V<Real> term) {
            sum = hn::Add(sum, hn::IfThenElseZero(reached, term));
        };
        add_to(slope_lo_, hn::IfThenElse(hollow, b, a));
        add_to(slope_hi_, hn::IfThenElse(hollow, a, b));
        add_to(slope_size_, hn::Mul(hn::Mul(hn::Abs(twice), number<Real>(facts.bend)),
                                    hn::Max(hn::Abs(near), hn::Abs(far))));
    }

    HWY_INLINE void clear() {
        for (V<Real>* const sum :
             {&c_, &along_u_, &along_v_, &along_s_, &round_, &bend_uu_, &bend_vv_, &bend_ss_,
              &bend_uv_, &bend_us_, &bend_vs_, &third_, &turning_, &range_lo_, &range_hi_,
              &rounding_, &slope_lo_, &slope_hi_, &slope_size_})
            *sum = zero();
    }

    /// Bounds of the terms that are quadratic in the place: their middle, how far they are from it,
    /// and their slope by es.
    struct Bends {
        V<Real> middle, error, turn;
    };
    HWY_INLINE Bends bends() const {
        const V<Real> half = number<Real>(0.5);
        // Rays that part add to the terms in eu es and ev es.
        const V<Real> tilt = hn::Div(reach_.way_s, reach_.w);
        const V<Real> round_s = hn::Mul(round_, reach_.way_s);
        const V<Real> square =
            hn::MulAdd(reach_.u, reach_.u, hn::MulAdd(reach_.v, reach_.v, number<Real>(1)));
        const V<Real> uu = hn::MulAdd(hn::Mul(round_, reach_.way_u), reach_.way_u, bend_uu_);
        const V<Real> vv = hn::MulAdd(hn::Mul(round_, reach_.way_v), reach_.way_v, bend_vv_);
        const V<Real> ss = hn::MulAdd(hn::Mul(round_s, square), reach_.way_s, bend_ss_);
        const auto mixed = [&](V<Real> bend, V<Real> way, V<Real> direction, V<Real> along) {
            const V<Real> sum = hn::MulAdd(hn::Mul(round_s, way), direction, bend);
            return hn::Abs(hn::MulAdd(along, tilt, hn::Add(sum, sum)));
        };
        const V<Real> us_vs = hn::Add(mixed(bend_us_, reach_.way_u, reach_.u, along_u_),
                                      mixed(bend_vs_, reach_.way_v, reach_.v, along_v_));
        const V<Real> uv = hn::Abs(hn::Add(bend_uv_, bend_uv_));
        const V<Real> size_ss = hn::Abs(ss);
        const V<Real> sizes = hn::Add(hn::Add(hn::Abs(uu), hn::Abs(vv)), size_ss);
        return {.middle = hn::Mul(half, hn::Add(hn::Add(uu, vv), ss)),
                .error = hn::MulAdd(half, sizes, hn::Add(us_vs, uv)),
                .turn = hn::Add(hn::Add(size_ss, size_ss), us_vs)};
    }

    HWY_INLINE void write_results(BallForm* forms) const {
        const auto above = [](V<Real> bound) { return CellReach<Real>::above(bound); };
        const auto count = static_cast<double>(bin_.count);
        const V<Real> level = number<Real>(of_.level);
        const V<Real> half = number<Real>(0.5);
        const V<Real> spare =
            above(hn::MulAdd(number<Real>(1 + count / 64), rounding_,
                             number<Real>(of_.tail + 256 * unit * std::abs(of_.level))));
        // Sum up Taylor's formula, with a bound of the rest.
        const Bends bent = bends();
        const V<Real> c = hn::Add(hn::Sub(c_, level), bent.middle);
        const V<Real> error = above(hn::Add(hn::Add(bent.error, third_), spare));
        const V<Real> turn = above(hn::MulAdd(turning_, number<Real>(1 + 0x1p-10), bent.turn));
        const V<Real> slope_spare = CellReach<Real>::above(hn::MulAdd(
            number<Real>((64 + count) * unit), slope_size_, number<Real>(of_.slope_tail)));
        const V<Real> unknown = hn::Inf(d<Real>);
        const M<Real> is_long = hn::Gt(reach_.way_s, zero());
        const V<Real> per_way = hn::Div(number<Real>(1), reach_.way_s);
        const V<Real> rounded = hn::Mul(number<Real>(16 * unit), hn::Abs(along_s_));
        const V<Real> spread_s = hn::Mul(hn::Add(turn, rounded), per_way);
        const V<Real> slope_s = hn::Mul(along_s_, per_way);
        const V<Real> least = hn::IfThenElse(is_long, hn::Sub(slope_s, spread_s), hn::Neg(unknown));
        const V<Real> most = hn::IfThenElse(is_long, hn::Add(slope_s, spread_s), unknown);
        // Over large cells the heights' ranges tell more.
        const V<Real> lo = hn::Sub(range_lo_, level);
        const V<Real> hi = hn::Sub(range_hi_, level);
        const V<Real> radius = hn::Mul(half, hn::Sub(hi, lo));
        const V<Real> range_error = above(hn::Add(radius, hn::Add(spare, spare)));
        const V<Real> spread = hn::Add(hn::Add(hn::Abs(along_u_), hn::Abs(along_v_)),
                                       hn::Add(hn::Abs(along_s_), error));
        const V<Real> far = hn::Mul(number<Real>(4), spare);
        const M<Real> rejects = hn::Or(hn::Gt(lo, far), hn::Lt(hi, hn::Neg(far)));
        const V<Real> enough = hn::IfThenElse(rejects, spread, hn::Mul(half, spread));
        const M<Real> by_range = hn::Lt(range_error, enough);
        const auto linear = [&](V<Real> k) { return hn::IfThenZeroElse(by_range, k); };
        const V<Real> results[] = {hn::IfThenElse(by_range, hn::Mul(half, hn::Add(lo, hi)), c),
                                   linear(along_u_),
                                   linear(along_v_),
                                   linear(along_s_),
                                   hn::IfThenElse(by_range, range_error, error),
                                   hn::Sub(hn::Max(least, slope_lo_), slope_spare),
                                   hn::Add(hn::Min(most, slope_hi_), slope_spare)};
        // Write the form of each cell.
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
    std::size_t first_, count_;
    CellReach<Real> reach_;
    V<Real> c_, along_u_, along_v_, along_s_;
    V<Real> round_;  ///< of h' / r^2
    V<Real> bend_uu_, bend_vv_, bend_ss_, bend_uv_, bend_us_, bend_vs_;
    V<Real> third_, turning_;  ///< of third order: of f, and of its slope
    V<Real> range_lo_, range_hi_, rounding_;
    V<Real> slope_lo_, slope_hi_, slope_size_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
