// The sum of balls over a cell of a beam, a ball a lane, by Taylor's formula about the middle.
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

template <class Real, BlobKind kind>
class CellSums {
public:
    CellSums(const BallForms& of, const BallBin& bin, const BallCell& cell)
        : of_(of), bin_(bin), balls_(bin.columns<Real>()), cell_(cell) {}

    BallForm form() {
        measure();
        sum_up();
        return result();
    }

private:
    using Vector = V<Real>;
    using Mask = M<Real>;
    static constexpr BlobFacts facts = blob_facts(kind);
    static constexpr double unit = std::numeric_limits<Real>::epsilon();

    static HWY_INLINE Vector number(double x) { return hn::Set(d<Real>, static_cast<Real>(x)); }
    static HWY_INLINE Vector zero() { return hn::Zero(d<Real>); }
    /// No smaller than x.
    static HWY_INLINE Vector above(double x) { return number(x * (1 + 4 * unit)); }
    static HWY_INLINE double sum_of(Vector terms) {
        return static_cast<double>(hn::GetLane(hn::SumOfLanes(d<Real>, terms)));
    }
    static HWY_INLINE Vector column(const std::vector<Real>& numbers, std::size_t i) {
        return hn::LoadU(d<Real>, &numbers[i]);
    }

    /// Sets what all balls have in common.
    void measure() {
        const double w = of_.distance + cell_.s;
        at_ = cell_.s - bin_.depth;
        start_x_ = w * (cell_.u - bin_.u);
        start_y_ = w * (cell_.v - bin_.v);
        const double u_size = std::abs(cell_.u) + cell_.u_radius;
        const double v_size = std::abs(cell_.v) + cell_.v_radius;
        way_u_ = w * cell_.u_radius;
        way_v_ = w * cell_.v_radius;
        const double size = std::abs(way_u_) + std::abs(way_v_) +
                            (1 + u_size + v_size) * cell_.s_radius;
        off_ = of_.place_error +
               16 * unit *
                   (std::abs(start_x_) + std::abs(start_y_) + std::abs(at_) + size +
                    (2 + u_size + v_size) * (bin_.most_support + size));
        half_x_ = std::abs(way_u_) + u_size * cell_.s_radius + off_;
        half_y_ = std::abs(way_v_) + v_size * cell_.s_radius + off_;
        half_z_ = cell_.s_radius + off_;
        square_ = half_x_ * half_x_ + half_y_ * half_y_ + half_z_ * half_z_;
        // By so much the way is not linear in the place.
        const double bent_x = std::abs(cell_.u_radius) * cell_.s_radius + off_;
        const double bent_y = std::abs(cell_.v_radius) * cell_.s_radius + off_;
        beside_ = 2 * (half_x_ * bent_x + half_y_ * bent_y + half_z_ * off_);
        turn_ = 2 * cell_.s_radius * (u_size * half_x_ + v_size * half_y_ + half_z_);
        turn_off_ = 2 * cell_.s_radius *
                    (u_size * bent_x + v_size * bent_y + off_ + std::abs(cell_.u_radius) * half_x_ +
                     std::abs(cell_.v_radius) * half_y_);
    }

    void sum_up() {
        const double first = at_ - half_z_;
        const double last = at_ + half_z_;
        for (std::size_t part = 0; part < bin_.parts(); ++part) {
            if (static_cast<double>(bin_.from[part]) > last) break;
            if (static_cast<double>(bin_.to[part]) < first) continue;
            for (std::size_t i = part * BallBin::widest; i < (part + 1) * BallBin::widest;
                 i += lanes<Real>)
                add(i);
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
        q.linear_u = hn::Mul(steep.x, number(way_u_));
        q.linear_v = hn::Mul(steep.y, number(way_v_));
        q.linear_s = hn::Mul(hn::MulAdd(steep.x, number(cell_.u),
                                        hn::MulAdd(steep.y, number(cell_.v), steep.z)),
                             number(cell_.s_radius));
        const Vector size_x = hn::Abs(steep.x);
        const Vector size_y = hn::Abs(steep.y);
        const Vector sizes = hn::Add(hn::Add(size_x, size_y), hn::Abs(steep.z));
        q.linear = hn::Mul(hn::Add(hn::Abs(q.linear_u),
                                   hn::Add(hn::Abs(q.linear_v), hn::Abs(q.linear_s))),
                           number(1 + 16 * unit));
        const Vector tilted = hn::MulAdd(size_x, above(cell_.u_radius * cell_.s_radius),
                                         hn::Mul(size_y, above(cell_.v_radius * cell_.s_radius)));
        const Vector off = hn::Mul(sizes, above(off_));
        q.beside = hn::MulAdd(per_square, above(beside_), off);
        q.rest = hn::MulAdd(above(square_), per_square, hn::Add(tilted, off));
        q.turn = hn::MulAdd(above(turn_), per_square, tilted);
        q.change = hn::Add(q.linear, q.rest);
        const auto gap = [&](Vector a, double half) {
            return hn::Max(hn::Sub(hn::Abs(a), above(half)), hn::Zero(d<Real>));
        };
        const Place gaps{gap(from.x, half_x_), gap(from.y, half_y_), gap(from.z, half_z_)};
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
        const Vector z = hn::Sub(number(at_), column(balls_.z, i));
        const Place from{
            hn::MulAdd(number(bin_.u), z, hn::Sub(number(start_x_), column(balls_.x, i))),
            hn::MulAdd(number(bin_.v), z, hn::Sub(number(start_y_), column(balls_.y, i))), z};
        const Vector per_square = column(balls_.per_square, i);
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
        const Vector strength = column(balls_.strength, i);
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
        const Vector beside = hn::Mul(flat, hn::MulAdd(per_square, above(turn_off_), zero()));
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
            number(cell_.u), from.x, hn::MulAdd(number(cell_.v), from.y, from.z));
        const double u_size = std::abs(cell_.u) + cell_.u_radius;
        const double v_size = std::abs(cell_.v) + cell_.v_radius;
        const Vector half = hn::MulAdd(
            hn::Abs(from.x), above(cell_.u_radius + 16 * unit * u_size),
            hn::MulAdd(hn::Abs(from.y), above(cell_.v_radius + 16 * unit * v_size),
                       hn::MulAdd(hn::Abs(from.z), above(16 * unit),
                                  above(u_size * half_x_ + v_size * half_y_ + half_z_))));
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

    [[nodiscard]] BallForm result() const {
        const double count = static_cast<double>(bin_.parts() * BallBin::widest);
        const double spare = of_.tail + (1 + count / 64) * sum_of(rounding_) +
                             64 * unit * std::abs(of_.level);
        BallForm form{.c = sum_of(c_) - of_.level,
                      .along_u = sum_of(along_u_),
                      .along_v = sum_of(along_v_),
                      .along_s = sum_of(along_s_),
                      .error = sum_of(third_) + spare};
        add_bends(form);
        const double slope_spare = (64 + count) * unit * sum_of(slope_size_) + of_.slope_tail;
        form.slope_lo = std::max(form.slope_lo, sum_of(slope_lo_)) - slope_spare;
        form.slope_hi = std::min(form.slope_hi, sum_of(slope_hi_)) + slope_spare;
        // Over large cells the heights' ranges tell more.
        const double lo = sum_of(range_lo_) - of_.level;
        const double hi = sum_of(range_hi_) - of_.level;
        const double radius = 0.5 * (hi - lo);
        const double spread =
            std::abs(form.along_u) + std::abs(form.along_v) + std::abs(form.along_s) + form.error;
        if (radius + spare < spread && (lo > spare || hi < -spare || radius + spare < 0.5 * spread)) {
            form.c = 0.5 * (lo + hi);
            form.error = radius + 2 * spare;
            form.along_u = form.along_v = form.along_s = 0;
        }
        return form;
    }

    /// Adds what is quadratic in the place, and bounds slopes by it.
    void add_bends(BallForm& form) const {
        const double way_s = cell_.s_radius;
        const double round = sum_of(round_);
        const double w = of_.distance + cell_.s;
        const double tilt = way_s / w;
        const double square = 1 + cell_.u * cell_.u + cell_.v * cell_.v;
        const double uu = sum_of(bend_uu_) + round * way_u_ * way_u_;
        const double vv = sum_of(bend_vv_) + round * way_v_ * way_v_;
        const double ss = sum_of(bend_ss_) + round * square * way_s * way_s;
        const double uv = 2 * sum_of(bend_uv_);
        const double us =
            2 * sum_of(bend_us_) + 2 * round * way_u_ * cell_.u * way_s + form.along_u * tilt;
        const double vs =
            2 * sum_of(bend_vs_) + 2 * round * way_v_ * cell_.v * way_s + form.along_v * tilt;
        const double turn = 2 * std::abs(ss) + std::abs(us) + std::abs(vs) +
                            (1 + 0x1p-10) * sum_of(turning_);
        form.slope_lo = (form.along_s - turn) / way_s;
        form.slope_hi = (form.along_s + turn) / way_s;
        if (!(way_s > 0)) {
            form.slope_lo = -std::numeric_limits<double>::infinity();
            form.slope_hi = -form.slope_lo;
        }
        form.c += 0.5 * (uu + vv + ss);
        form.error += 0.5 * (std::abs(uu) + std::abs(vv) + std::abs(ss)) + std::abs(uv) +
                      std::abs(us) + std::abs(vs);
    }

    const BallForms& of_;
    const BallBin& bin_;
    const BinColumns<Real>& balls_;
    const BallCell& cell_;
    double at_ = 0, start_x_ = 0, start_y_ = 0;
    double way_u_ = 0, way_v_ = 0;  ///< across the cell, to both sides of its middle
    double off_ = 0;
    double half_x_ = 0, half_y_ = 0, half_z_ = 0, square_ = 0;
    double beside_ = 0, turn_ = 0, turn_off_ = 0;
    Vector c_ = zero(), along_u_ = zero(), along_v_ = zero(), along_s_ = zero();
    Vector round_ = zero();  ///< of h' / r^2
    Vector bend_uu_ = zero(), bend_vv_ = zero(), bend_ss_ = zero();
    Vector bend_uv_ = zero(), bend_us_ = zero(), bend_vs_ = zero();
    Vector third_ = zero(), turning_ = zero();  ///< of third order: of f, and of its slope
    Vector range_lo_ = zero(), range_hi_ = zero();
    Vector rounding_ = zero();
    Vector slope_lo_ = zero(), slope_hi_ = zero(), slope_size_ = zero();
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
