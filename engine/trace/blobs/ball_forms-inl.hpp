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

#include "engine/trace/blobs/ball_curves-inl.hpp"
#include "engine/trace/blobs/ball_reach-inl.hpp"
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
          first_(first),
          count_(std::min(lanes<Real>, cells.count - first)),
          reach_(of, bin, cells, first) {}

    void write(BallForm* forms) {
        clear();
        const Vector half = reach_.half_z;
        const auto end_of = [&](Vector at) { return static_cast<double>(hn::GetLane(at)); };
        each_ball_between(bin_, end_of(hn::MinOfLanes(d<Real>, hn::Sub(reach_.at, half))),
                          end_of(hn::MaxOfLanes(d<Real>, hn::Add(reach_.at, half))),
                          [&](std::size_t i) { add(i); });
        write_results(forms);
    }

private:
    using Vector = V<Real>;
    using Mask = M<Real>;
    using Lanes = Real[lanes<Real>];
    using Place = CellReach<Real>::Place;
    using Squares = CellReach<Real>::Squares;
    static constexpr BlobFacts facts = blob_facts(kind);
    static constexpr double unit = std::numeric_limits<Real>::epsilon();

    static HWY_INLINE Vector number(double x) { return hn::Set(d<Real>, static_cast<Real>(x)); }
    static HWY_INLINE Vector zero() { return hn::Zero(d<Real>); }
    static HWY_INLINE Vector same(Real x) { return hn::Set(d<Real>, x); }

    HWY_INLINE void add(std::size_t i) {
        const Vector reach = number(facts.reach);
        // Find where the cells are from the ball, and skip it if it reaches none.
        const Vector z = hn::Sub(reach_.at, same(balls_.z[i]));
        const Place from{hn::MulAdd(number(bin_.u), z, hn::Sub(reach_.start_x, same(balls_.x[i]))),
                         hn::MulAdd(number(bin_.v), z, hn::Sub(reach_.start_y, same(balls_.y[i]))),
                         z};
        const Vector per_square = same(balls_.per_square[i]);
        const Squares q = reach_.squares_of(from, per_square);
        const Mask reached = hn::Lt(q.lo, reach);
        if (hn::AllFalse(d<Real>, reached)) return;
        const auto height_up_to_reach = [&](Vector of) {
            auto h = height_at<kind, Rounds::Once>(d<Real>, hn::Min(of, reach));
            const Mask inside = hn::Lt(of, reach);
            h.value = hn::IfThenElseZero(inside, h.value);
            h.slope = hn::IfThenElseZero(inside, h.slope);
            return h;
        };
        // Evaluate the height in the middle of the cells, and where they are nearest and farthest.
        const auto middle = height_up_to_reach(q.middle);
        const auto top = height_up_to_reach(q.lo);
        const auto end = height_up_to_reach(q.hi);
        const Vector strength = same(balls_.strength[i]);
        add_linear(q, middle, strength, per_square, reached);
        add_bends(q, hn::Abs(middle.slope), strength, per_square, reached);
        // Add the ranges of the height and of its slope along the rays.
        const Mask hollow = hn::Lt(strength, zero());
        const Vector least = hn::Mul(strength, end.value);
        const Vector most = hn::Mul(strength, top.value);
        add_in(reached, hn::IfThenElse(hollow, most, least), range_lo_);
        add_in(reached, hn::IfThenElse(hollow, least, most), range_hi_);
        add_slope(from, top.slope, end.slope, hn::Mul(strength, per_square), reached);
    }
    /// Adds a term in those lanes that a ball reaches: in others it may overflow.
    static HWY_INLINE void add_in(Mask reached, Vector term, Vector& sum) {
        sum = hn::Add(sum, hn::IfThenElseZero(reached, term));
    }
    HWY_INLINE void add_linear(const Squares& q, const HeightOf<Vector>& middle, Vector strength,
                               Vector per_square, Mask reached) {
        const auto add_to = [&](Vector& sum, Vector term) { add_in(reached, term, sum); };
        add_to(c_, hn::Mul(strength, middle.value));
        const Vector steep = hn::Mul(strength, middle.slope);
        add_to(along_u_, hn::Mul(steep, q.linear_u));
        add_to(along_v_, hn::Mul(steep, q.linear_v));
        add_to(along_s_, hn::Mul(steep, q.linear_s));
        add_to(round_, hn::Mul(steep, per_square));
    }
    /// Adds the quadratic terms, and bounds of the rest.
    HWY_INLINE void add_bends(const Squares& q, Vector flat, Vector strength, Vector per_square,
                              Mask reached) {
        const auto add_to = [&](Vector& sum, Vector term) { add_in(reached, term, sum); };
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
        // Bound how far 1/2 h'' change^2 is from 1/2 curve linear^2, and the part of h' rest that
        // is not quadratic.
        const Vector size = hn::Abs(strength);
        const Vector square = hn::Mul(q.change, q.change);
        const Vector mixed = hn::Mul(q.rest, hn::Add(hn::Add(q.linear, q.linear), q.rest));
        const Vector half = number(0.5);
        const Vector third =
            hn::MulAdd(hn::Mul(half, unsure), square,
                       hn::MulAdd(hn::Mul(half, curve), mixed, hn::Mul(flat, q.beside)));
        // Bound the numbers that were rounded, and how far heights beyond the reach are from 0.
        const Vector sizes =
            hn::MulAdd(hn::Mul(half, curves.most), square,
                       hn::MulAdd(number(facts.bend), q.change, number(facts.top)));
        const Vector beyond = hn::MulAdd(number(4 * facts.tail), q.change, number(facts.tail));
        const Vector rounded = hn::MulAdd(number(64 * unit), sizes, beyond);
        add_to(third_, hn::Mul(size, third));
        add_to(rounding_, hn::Mul(size, rounded));
        // Bound how the slope along the rays changes beyond the quadratic terms.
        const Vector along = hn::Abs(q.linear_s);
        const Vector turning =
            hn::MulAdd(unsure, hn::Mul(q.change, along),
                       hn::MulAdd(curve, hn::Mul(q.rest, along),
                                  hn::Mul(hn::Mul(curves.most, q.change), q.turn)));
        const Vector beside = hn::Mul(flat, hn::MulAdd(per_square, reach_.turn_off, zero()));
        add_to(turning_, hn::Mul(size, hn::Add(turning, beside)));
    }

    /// The slope along the rays is 2 s h'(q) / r^2 times how far along its direction a place is
    /// from the ball.
    HWY_INLINE void add_slope(const Place& from, Vector steepest, Vector flattest, Vector weight,
                              Mask reached) {
        const Vector along = hn::MulAdd(reach_.u, from.x, hn::MulAdd(reach_.v, from.y, from.z));
        const Vector half =
            hn::MulAdd(hn::Abs(from.x), reach_.aside_x,
                       hn::MulAdd(hn::Abs(from.y), reach_.aside_y,
                                  hn::MulAdd(hn::Abs(from.z), number(16 * unit), reach_.aside)));
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

    /// Bounds of the terms that are quadratic in the place: their middle, how far they are from it,
    /// and their slope by es.
    struct Bends {
        Vector middle, error, turn;
    };
    HWY_INLINE Bends bends() const {
        const Vector half = number(0.5);
        // Rays that part add to the terms in eu es and ev es.
        const Vector tilt = hn::Div(reach_.way_s, reach_.w);
        const Vector round_s = hn::Mul(round_, reach_.way_s);
        const Vector square =
            hn::MulAdd(reach_.u, reach_.u, hn::MulAdd(reach_.v, reach_.v, number(1)));
        const Vector uu = hn::MulAdd(hn::Mul(round_, reach_.way_u), reach_.way_u, bend_uu_);
        const Vector vv = hn::MulAdd(hn::Mul(round_, reach_.way_v), reach_.way_v, bend_vv_);
        const Vector ss = hn::MulAdd(hn::Mul(round_s, square), reach_.way_s, bend_ss_);
        const auto mixed = [&](Vector bend, Vector way, Vector direction, Vector along) {
            const Vector sum = hn::MulAdd(hn::Mul(round_s, way), direction, bend);
            return hn::Abs(hn::MulAdd(along, tilt, hn::Add(sum, sum)));
        };
        const Vector us_vs = hn::Add(mixed(bend_us_, reach_.way_u, reach_.u, along_u_),
                                     mixed(bend_vs_, reach_.way_v, reach_.v, along_v_));
        const Vector uv = hn::Abs(hn::Add(bend_uv_, bend_uv_));
        const Vector size_ss = hn::Abs(ss);
        const Vector sizes = hn::Add(hn::Add(hn::Abs(uu), hn::Abs(vv)), size_ss);
        return {.middle = hn::Mul(half, hn::Add(hn::Add(uu, vv), ss)),
                .error = hn::MulAdd(half, sizes, hn::Add(us_vs, uv)),
                .turn = hn::Add(hn::Add(size_ss, size_ss), us_vs)};
    }

    HWY_INLINE void write_results(BallForm* forms) const {
        const auto above = [](Vector bound) { return CellReach<Real>::above(bound); };
        const auto count = static_cast<double>(bin_.count);
        const Vector level = number(of_.level);
        const Vector half = number(0.5);
        const Vector spare = above(hn::MulAdd(number(1 + count / 64), rounding_,
                                              number(of_.tail + 256 * unit * std::abs(of_.level))));
        // Sum up Taylor's formula, with a bound of the rest.
        const Bends bent = bends();
        const Vector c = hn::Add(hn::Sub(c_, level), bent.middle);
        const Vector error = above(hn::Add(hn::Add(bent.error, third_), spare));
        const Vector turn = above(hn::MulAdd(turning_, number(1 + 0x1p-10), bent.turn));
        const Vector slope_spare = CellReach<Real>::above(
            hn::MulAdd(number((64 + count) * unit), slope_size_, number(of_.slope_tail)));
        const Vector unknown = hn::Inf(d<Real>);
        const Mask is_long = hn::Gt(reach_.way_s, zero());
        const Vector per_way = hn::Div(number(1), reach_.way_s);
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
