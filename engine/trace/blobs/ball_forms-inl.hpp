// The sum of balls over a cell of a beam, a ball a lane, by Taylor's formula about the middle.
//   d      from the ball's middle to the cell's
//   q      the square of d by the ball's radius; over the cell it is
//            q + linear + rest,  |linear| <= 2 |d . way|, rest in [-beside, beside + square]
//   h(q)   the ball's height: convex, falling, with a continuous derivative
// So h is h(q) + h'(q) linear, and more by what is between h'(q) (beside + square) and
// -h'(q) beside + 1/2 max h'' change^2, where |linear + rest| <= change.
//
// What is proved: places and directions are known to an error, `off_`, by which the cell is taken
// to be larger; each result is rounded a few times, which `rounding` bounds by its size.
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

/// The largest h'' from q on.
template <BlobKind kind, class D, class Vector>
HWY_INLINE Vector most_curve(D tag, Vector q) {
    const auto number = [&](double x) { return hn::Set(tag, static_cast<hn::TFromD<D>>(x)); };
    if constexpr (kind == BlobKind::Wyvill) {
        return hn::NegMulAdd(q, number(1.0 / 12), number(17.0 / 36));
    } else if constexpr (kind == BlobKind::Metaball) {
        const Vector outside = hn::Max(q, number(4.0 / 9));
        return hn::Div(number(1), hn::Mul(outside, hn::Sqrt(outside)));
    } else {
        return hn::Mul(number(4), height_at<kind, Rounds::Once>(tag, q).value);
    }
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
        Vector beside, square, change;
    };
    HWY_INLINE Squares squares_of(Vector dx, Vector dy, Vector dz, Vector per_square) const {
        const auto twice = [&](Vector a) { return hn::Mul(hn::Add(a, a), per_square); };
        Squares q{};
        q.middle = hn::Mul(hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz))), per_square);
        const Vector steep_x = twice(dx);
        const Vector steep_y = twice(dy);
        const Vector steep_z = twice(dz);
        q.linear_u = hn::Mul(steep_x, number(way_u_));
        q.linear_v = hn::Mul(steep_y, number(way_v_));
        q.linear_s =
            hn::Mul(hn::MulAdd(steep_x, number(cell_.u),
                               hn::MulAdd(steep_y, number(cell_.v), steep_z)),
                    number(cell_.s_radius));
        q.beside = hn::MulAdd(
            hn::Abs(steep_x), above(cell_.u_radius * cell_.s_radius + off_),
            hn::MulAdd(hn::Abs(steep_y), above(cell_.v_radius * cell_.s_radius + off_),
                       hn::Mul(hn::Abs(steep_z), above(off_))));
        q.square = hn::Mul(above(square_), per_square);
        const Vector linear = hn::Add(hn::Abs(q.linear_u),
                                      hn::Add(hn::Abs(q.linear_v), hn::Abs(q.linear_s)));
        const Vector sides = hn::Mul(hn::Add(linear, q.beside), number(1 + 16 * unit));
        q.change = hn::Add(sides, q.square);
        const auto gap = [&](Vector a, double half) {
            return hn::Max(hn::Sub(hn::Abs(a), above(half)), hn::Zero(d<Real>));
        };
        const Vector gap_x = gap(dx, half_x_);
        const Vector gap_y = gap(dy, half_y_);
        const Vector gap_z = gap(dz, half_z_);
        const Vector gaps = hn::MulAdd(gap_x, gap_x, hn::MulAdd(gap_y, gap_y,
                                                                hn::Mul(gap_z, gap_z)));
        // Differences of numbers far larger than they are known to their own digits only.
        const Vector spare = hn::Mul(number(16 * unit), q.middle);
        const Vector nearest = hn::Max(hn::Mul(gaps, per_square), hn::Sub(q.middle, sides));
        q.lo = hn::Max(hn::Sub(nearest, spare), hn::Zero(d<Real>));
        q.hi = hn::Add(hn::Add(q.middle, q.change), spare);
        return q;
    }

    HWY_INLINE void add(std::size_t i) {
        const Vector reach = number(facts.reach);
        const Vector zero = hn::Zero(d<Real>);
        const Vector dz = hn::Sub(number(at_), column(balls_.z, i));
        const Vector dx = hn::MulAdd(number(bin_.u), dz,
                                     hn::Sub(number(start_x_), column(balls_.x, i)));
        const Vector dy = hn::MulAdd(number(bin_.v), dz,
                                     hn::Sub(number(start_y_), column(balls_.y, i)));
        const Vector per_square = column(balls_.per_square, i);
        const Squares q = squares_of(dx, dy, dz, per_square);
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
        const Mask hollow = hn::Lt(strength, zero);
        // What is not reached may overflow.
        const auto add_to = [&](Vector& sum, Vector term) {
            sum = hn::Add(sum, hn::IfThenElseZero(reached, term));
        };
        const auto add_between = [&](Vector& lo, Vector& hi, Vector least, Vector most) {
            const Vector a = hn::Mul(strength, least);
            const Vector b = hn::Mul(strength, most);
            add_to(lo, hn::IfThenElse(hollow, b, a));
            add_to(hi, hn::IfThenElse(hollow, a, b));
        };
        add_to(c_, hn::Mul(strength, middle.value));
        const Vector steep = hn::Mul(strength, middle.slope);
        add_to(along_u_, hn::Mul(steep, q.linear_u));
        add_to(along_v_, hn::Mul(steep, q.linear_v));
        add_to(along_s_, hn::Mul(steep, q.linear_s));
        const Vector curve = hn::Mul(hn::Mul(number(0.5), most_curve<kind>(d<Real>, q.lo)),
                                     hn::Mul(q.change, q.change));
        const Vector least = hn::Mul(middle.slope, hn::Add(q.beside, q.square));
        const Vector most = hn::NegMulAdd(middle.slope, q.beside, curve);
        add_between(rest_lo_, rest_hi_, least, most);
        add_between(range_lo_, range_hi_, end.value, top.value);
        // The largest numbers that were rounded; and how far heights beyond the reach are from 0.
        const Vector sizes = hn::MulAdd(number(facts.bend), q.change,
                                        hn::Add(hn::Sub(most, least), number(facts.top)));
        const Vector beyond = hn::MulAdd(number(4 * facts.tail), q.change, number(facts.tail));
        add_to(rounding_, hn::Mul(hn::Abs(strength),
                                  hn::MulAdd(number(64 * unit), sizes, beyond)));
        add_slope({dx, dy, dz}, top.slope, end.slope, hn::Mul(strength, per_square), reached);
    }

    /// The slope along the rays is 2 s h'(q) / r^2 times how far along its direction a place is
    /// from the ball.
    HWY_INLINE void add_slope(const Place& from, Vector steepest, Vector flattest, Vector weight,
                              Mask reached) {
        const Vector zero = hn::Zero(d<Real>);
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
        const Vector least = hn::Mul(hn::IfThenElse(hn::Gt(far, zero), steepest, flattest), far);
        const Vector most = hn::Mul(hn::IfThenElse(hn::Lt(near, zero), steepest, flattest), near);
        const Vector twice = hn::Add(weight, weight);
        const Vector a = hn::Mul(twice, least);
        const Vector b = hn::Mul(twice, most);
        const Mask hollow = hn::Lt(weight, zero);
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
        const double rest_lo = sum_of(rest_lo_);
        const double rest_hi = sum_of(rest_hi_);
        const double spare = of_.tail + (1 + count / 64) * sum_of(rounding_) +
                             64 * unit * std::abs(of_.level);
        BallForm form{.c = sum_of(c_) - of_.level + 0.5 * (rest_lo + rest_hi),
                      .along_u = sum_of(along_u_),
                      .along_v = sum_of(along_v_),
                      .along_s = sum_of(along_s_),
                      .error = 0.5 * (rest_hi - rest_lo) + spare};
        const double slope_spare =
            (64 + count) * unit * sum_of(slope_size_) + of_.slope_tail;
        form.slope_lo = sum_of(slope_lo_) - slope_spare;
        form.slope_hi = sum_of(slope_hi_) + slope_spare;
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

    const BallForms& of_;
    const BallBin& bin_;
    const BinColumns<Real>& balls_;
    const BallCell& cell_;
    double at_ = 0, start_x_ = 0, start_y_ = 0;
    double way_u_ = 0, way_v_ = 0;  ///< across the cell, to both sides of its middle
    double off_ = 0;
    double half_x_ = 0, half_y_ = 0, half_z_ = 0, square_ = 0;
    Vector c_ = number(0), along_u_ = number(0), along_v_ = number(0), along_s_ = number(0);
    Vector rest_lo_ = number(0), rest_hi_ = number(0), range_lo_ = number(0),
           range_hi_ = number(0);
    Vector rounding_ = number(0);
    Vector slope_lo_ = number(0), slope_hi_ = number(0), slope_size_ = number(0);
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
