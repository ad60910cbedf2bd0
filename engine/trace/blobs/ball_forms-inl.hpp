// The sum of balls over cells of beams, a cell a lane, by Taylor's formula about the middle.
//   eu, ev, es   the place in the cell: each in [-1, 1]
//   way          the place's from the middle, up to `off_`: linear in these but for eu es and ev es
//   q            the square of the distance from the ball by its radius: over the cell it is
//                  q + linear + rest,  linear in eu, ev, es
//   h(q)         the ball's height: convex, falling, with a continuous derivative; h'' is between
//                two bounds on the cell
// So the sum is a constant, a linear and a quadratic form, and a rest of third order; bends of balls
// that cancel each other do so here, too.
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

#include "engine/blobs/blob_heights-inl.hpp"
#include "engine/trace/blobs/ball_sums.hpp"
#include "engine/trace/simd/vectors-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Bounds of h'' between two q.
template <class Vector>
struct CurvesOf {
    Vector least, most;
};
template <BlobKind kind, class D, class Vector>
HWY_INLINE CurvesOf<Vector> curves_between(D tag, Vector lo, Vector hi) {
    const auto number = [&](double x) { return hn::Set(tag, static_cast<hn::TFromD<D>>(x)); };
    const Vector reach = number(blob_facts(kind).reach);
    const auto curve_at = [&](Vector q) {
        if constexpr (kind == BlobKind::Wyvill) {
            return hn::NegMulAdd(q, number(1.0 / 12), number(17.0 / 36));
        } else if constexpr (kind == BlobKind::Metaball) {
            const Vector outside = hn::Max(q, number(4.0 / 9));
            return hn::Div(number(1), hn::Mul(outside, hn::Sqrt(outside)));
        } else {
            return hn::Mul(number(4), height_at<kind, Rounds::Once>(tag, q).value);
        }
    };
    // It falls with q; metaballs' is 0 up to 4/9.
    Vector most = curve_at(hn::Min(lo, reach));
    Vector least = hn::IfThenElseZero(hn::Lt(hi, reach), curve_at(hn::Min(hi, reach)));
    if constexpr (kind == BlobKind::Metaball) {
        least = hn::IfThenElseZero(hn::Gt(lo, number(4.0 / 9)), least);
        most = hn::IfThenElseZero(hn::Ge(hi, number(4.0 / 9)), most);
    }
    return {.least = least, .most = most};
}

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
        measure();
        double from = std::numeric_limits<double>::infinity();
        double to = -from;
        for (std::size_t i = 0; i < count_; ++i) {
            const double half = static_cast<double>(half_z_[i]);
            from = std::min(from, static_cast<double>(at_[i]) - half);
            to = std::max(to, static_cast<double>(at_[i]) + half);
        }
        load();
        each_ball_between(bin_, from, to, [&](std::size_t i) { add(i); });
        store();
        for (std::size_t i = 0; i < count_; ++i)
            forms[first_ + i] = result(i);
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
    static HWY_INLINE Vector lane(const Lanes& numbers) { return hn::Load(d<Real>, numbers); }

    /// Sets the numbers of each cell. In upward rounding, and a little more for bounds.
    void measure() {
        const double u_radius = cells_.u_radius;
        const double v_radius = cells_.v_radius;
        const auto above = [](double x) { return static_cast<Real>(x * (1 + 4 * unit)); };
        for (std::size_t i = 0; i < lanes<Real>; ++i) {
            const std::size_t cell = first_ + std::min(i, count_ - 1);
            const double u = cells_.u[cell];
            const double v = cells_.v[cell];
            const double way_s = cells_.s_radius[cell];
            const double w = of_.distance + cells_.s[cell];
            const double at = cells_.s[cell] - bin_.depth;
            const double start_x = w * (u - bin_.u);
            const double start_y = w * (v - bin_.v);
            const double u_size = std::abs(u) + u_radius;
            const double v_size = std::abs(v) + v_radius;
            const double way_u = w * u_radius;
            const double way_v = w * v_radius;
            const double size =
                std::abs(way_u) + std::abs(way_v) + (1 + u_size + v_size) * way_s;
            const double off =
                of_.place_error +
                16 * unit *
                    (std::abs(start_x) + std::abs(start_y) + std::abs(at) + size +
                     (2 + u_size + v_size) * (bin_.most_support + size));
            const double half_x = std::abs(way_u) + u_size * way_s + off;
            const double half_y = std::abs(way_v) + v_size * way_s + off;
            const double half_z = way_s + off;
            // By so much the way is not linear in the place.
            const double bent_x = u_radius * way_s + off;
            const double bent_y = v_radius * way_s + off;
            u_[i] = static_cast<Real>(u);
            v_[i] = static_cast<Real>(v);
            at_[i] = static_cast<Real>(at);
            start_x_[i] = static_cast<Real>(start_x);
            start_y_[i] = static_cast<Real>(start_y);
            way_u_[i] = static_cast<Real>(way_u);
            way_v_[i] = static_cast<Real>(way_v);
            way_s_[i] = static_cast<Real>(way_s);
            off_[i] = above(off);
            half_x_[i] = above(half_x);
            half_y_[i] = above(half_y);
            half_z_[i] = above(half_z);
            square_[i] = above(half_x * half_x + half_y * half_y + half_z * half_z);
            beside_[i] = above(2 * (half_x * bent_x + half_y * bent_y + half_z * off));
            tilt_u_[i] = above(u_radius * way_s);
            tilt_v_[i] = above(v_radius * way_s);
            turn_[i] = above(2 * way_s * (u_size * half_x + v_size * half_y + half_z));
            turn_off_[i] = above(2 * way_s *
                                 (u_size * bent_x + v_size * bent_y + off + u_radius * half_x +
                                  v_radius * half_y));
            aside_x_[i] = above(u_radius + 16 * unit * u_size);
            aside_y_[i] = above(v_radius + 16 * unit * v_size);
            aside_[i] = above(u_size * half_x + v_size * half_y + half_z);
        }
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
        q.middle = hn::Mul(
            hn::MulAdd(from.x, from.x, hn::MulAdd(from.y, from.y, hn::Mul(from.z, from.z))),
            per_square);
        const Place steep{twice(from.x), twice(from.y), twice(from.z)};
        q.linear_u = hn::Mul(steep.x, lane(way_u_));
        q.linear_v = hn::Mul(steep.y, lane(way_v_));
        q.linear_s = hn::Mul(hn::MulAdd(steep.x, lane(u_),
                                        hn::MulAdd(steep.y, lane(v_), steep.z)),
                             lane(way_s_));
        const Vector size_x = hn::Abs(steep.x);
        const Vector size_y = hn::Abs(steep.y);
        const Vector sizes = hn::Add(hn::Add(size_x, size_y), hn::Abs(steep.z));
        q.linear = hn::Mul(hn::Add(hn::Abs(q.linear_u),
                                   hn::Add(hn::Abs(q.linear_v), hn::Abs(q.linear_s))),
                           number(1 + 16 * unit));
        const Vector tilted = hn::MulAdd(size_x, lane(tilt_u_),
                                         hn::Mul(size_y, lane(tilt_v_)));
        const Vector off = hn::Mul(sizes, lane(off_));
        q.beside = hn::MulAdd(per_square, lane(beside_), off);
        q.rest = hn::MulAdd(lane(square_), per_square, hn::Add(tilted, off));
        q.turn = hn::MulAdd(lane(turn_), per_square, tilted);
        q.change = hn::Add(q.linear, q.rest);
        const auto gap = [&](Vector a, Vector half) {
            return hn::Max(hn::Sub(hn::Abs(a), half), zero());
        };
        const Place gaps{gap(from.x, lane(half_x_)), gap(from.y, lane(half_y_)), gap(from.z, lane(half_z_))};
        const Vector nearest =
            hn::MulAdd(gaps.x, gaps.x, hn::MulAdd(gaps.y, gaps.y, hn::Mul(gaps.z, gaps.z)));
        // Differences of far larger numbers are known to the digits of these.
        const Vector spare = hn::Mul(number(16 * unit), q.middle);
        const Vector lo = hn::Sub(q.middle, hn::Add(q.linear, hn::Add(tilted, off)));
        q.lo = hn::Max(hn::Sub(hn::Max(hn::Mul(nearest, per_square), lo), spare),
                       hn::Zero(d<Real>));
        q.hi = hn::Add(hn::Add(q.middle, q.change), spare);
        return q;
    }

    HWY_INLINE void add(std::size_t i) {
        const Vector reach = number(facts.reach);
        const Vector z = hn::Sub(lane(at_), same(balls_.z[i]));
        const Place from{
            hn::MulAdd(number(bin_.u), z, hn::Sub(lane(start_x_), same(balls_.x[i]))),
            hn::MulAdd(number(bin_.v), z, hn::Sub(lane(start_y_), same(balls_.y[i]))), z};
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
        const Vector sizes = hn::MulAdd(
            hn::Mul(half, curves.most), square,
            hn::MulAdd(number(facts.bend), q.change, number(facts.top)));
        const Vector beyond = hn::MulAdd(number(4 * facts.tail), q.change, number(facts.tail));
        const Vector rounded = hn::MulAdd(number(64 * unit), sizes, beyond);
        add_to(third_, hn::Mul(size, third));
        add_to(rounding_, hn::Mul(size, rounded));
        const Vector along = hn::Abs(q.linear_s);
        const Vector turning = hn::MulAdd(
            unsure, hn::Mul(q.change, along),
            hn::MulAdd(curve, hn::Mul(q.rest, along),
                       hn::Mul(hn::Mul(curves.most, q.change), q.turn)));
        const Vector beside = hn::Mul(flat, hn::MulAdd(per_square, lane(turn_off_), zero()));
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
        const Vector along = hn::MulAdd(
            lane(u_), from.x, hn::MulAdd(lane(v_), from.y, from.z));
        const Vector half = hn::MulAdd(
            hn::Abs(from.x), lane(aside_x_),
            hn::MulAdd(hn::Abs(from.y), lane(aside_y_),
                       hn::MulAdd(hn::Abs(from.z), number(16 * unit), lane(aside_))));
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

    HWY_INLINE void load() {
        for (Vector* const sum : {&c_, &along_u_, &along_v_, &along_s_, &round_, &bend_uu_,
                                  &bend_vv_, &bend_ss_, &bend_uv_, &bend_us_, &bend_vs_, &third_,
                                  &turning_, &range_lo_, &range_hi_, &rounding_, &slope_lo_,
                                  &slope_hi_, &slope_size_})
            *sum = zero();
    }
    HWY_INLINE void store() {
        std::size_t at = 0;
        for (const Vector* const sum : {&c_, &along_u_, &along_v_, &along_s_, &round_, &bend_uu_,
                                        &bend_vv_, &bend_ss_, &bend_uv_, &bend_us_, &bend_vs_,
                                        &third_, &turning_, &range_lo_, &range_hi_, &rounding_,
                                        &slope_lo_, &slope_hi_, &slope_size_})
            hn::Store(*sum, d<Real>, sums_[at++]);
    }
    /// The places of the sums in sums_.
    enum Sum : std::uint8_t {
        C, AlongU, AlongV, AlongS, Round, BendUU, BendVV, BendSS, BendUV, BendUS, BendVS, Third,
        Turning, RangeLo, RangeHi, Rounding, SlopeLo, SlopeHi, SlopeSize, SumCount
    };
    [[nodiscard]] double sum(Sum of, std::size_t i) const {
        return static_cast<double>(sums_[of][i]);
    }

    [[nodiscard]] BallForm result(std::size_t i) const {
        const auto count = static_cast<double>(bin_.count);
        const double spare = of_.tail + (1 + count / 64) * sum(Rounding, i) +
                             64 * unit * std::abs(of_.level);
        BallForm form{.c = sum(C, i) - of_.level,
                      .along = {sum(AlongU, i), sum(AlongV, i), sum(AlongS, i)},
                      .error = sum(Third, i) + spare};
        add_bends(form, i);
        const double slope_spare = (64 + count) * unit * sum(SlopeSize, i) + of_.slope_tail;
        form.slope_lo = std::max(form.slope_lo, sum(SlopeLo, i)) - slope_spare;
        form.slope_hi = std::min(form.slope_hi, sum(SlopeHi, i)) + slope_spare;
        // Over large cells the heights' ranges tell more.
        const double lo = sum(RangeLo, i) - of_.level;
        const double hi = sum(RangeHi, i) - of_.level;
        const double radius = 0.5 * (hi - lo);
        const double spread = std::abs(form.along[0]) + std::abs(form.along[1]) +
                              std::abs(form.along[2]) + form.error;
        const bool rejects = lo > 4 * spare || hi < -4 * spare;
        if (radius + 2 * spare < (rejects ? spread : 0.5 * spread)) {
            form.c = 0.5 * (lo + hi);
            form.error = radius + 2 * spare;
            for (double& k : form.along)
                k = 0;
        }
        return form;
    }
    /// Adds what is quadratic in the place, and bounds slopes by it.
    void add_bends(BallForm& form, std::size_t i) const {
        const std::size_t cell = first_ + i;
        const double u = cells_.u[cell];
        const double v = cells_.v[cell];
        const double way_s = cells_.s_radius[cell];
        const double w = of_.distance + cells_.s[cell];
        const double way_u = w * cells_.u_radius;
        const double way_v = w * cells_.v_radius;
        const double round = sum(Round, i);
        const double tilt = way_s / w;
        const double uu = sum(BendUU, i) + round * way_u * way_u;
        const double vv = sum(BendVV, i) + round * way_v * way_v;
        const double ss = sum(BendSS, i) + round * (1 + u * u + v * v) * way_s * way_s;
        const double uv = 2 * sum(BendUV, i);
        const double us =
            2 * sum(BendUS, i) + 2 * round * way_u * u * way_s + form.along[0] * tilt;
        const double vs =
            2 * sum(BendVS, i) + 2 * round * way_v * v * way_s + form.along[1] * tilt;
        const double turn = 2 * std::abs(ss) + std::abs(us) + std::abs(vs) +
                            (1 + 0x1p-10) * sum(Turning, i);
        form.slope_lo = -std::numeric_limits<double>::infinity();
        form.slope_hi = -form.slope_lo;
        if (way_s > 0) {
            form.slope_lo = (form.along[2] - turn) / way_s;
            form.slope_hi = (form.along[2] + turn) / way_s;
        }
        form.c += 0.5 * (uu + vv + ss);
        form.error += 0.5 * (std::abs(uu) + std::abs(vv) + std::abs(ss)) + std::abs(uv) +
                      std::abs(us) + std::abs(vs);
    }

    const BallForms& of_;
    const BallBin& bin_;
    const BinColumns<Real>& balls_;
    const BallCells& cells_;
    std::size_t first_, count_;
    // Of each cell: its middle; how far it reaches to both sides of that; bounds of these ways and
    // of their products.
    alignas(64) Lanes u_, v_, at_, start_x_, start_y_, way_u_, way_v_, way_s_;
    alignas(64) Lanes off_, half_x_, half_y_, half_z_, square_, beside_, tilt_u_, tilt_v_;
    alignas(64) Lanes turn_, turn_off_, aside_x_, aside_y_, aside_;
    Vector c_, along_u_, along_v_, along_s_;
    Vector round_;  ///< of h' / r^2
    Vector bend_uu_, bend_vv_, bend_ss_, bend_uv_, bend_us_, bend_vs_;
    Vector third_, turning_;  ///< of third order: of f, and of its slope
    Vector range_lo_, range_hi_, rounding_;
    Vector slope_lo_, slope_hi_, slope_size_;
    alignas(64) Lanes sums_[SumCount];
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
