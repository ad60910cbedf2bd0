// Newton's method on a piece of a leaf in float, and Krawczyk's test in double: zero_test
// (patch_sight.hpp) for a vector of rays. Included once for each instruction set, after Highway.

#if defined(ZEROSET_PATCH_SOLVER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_PATCH_SOLVER_INL
#undef ZEROSET_PATCH_SOLVER_INL
#else
#define ZEROSET_PATCH_SOLVER_INL
#endif

#include "engine/trace/patch/patch_newton-inl.hpp"

#include <hwy/highway.h>

#include <array>
#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// (a, b, s) at places.
template <int degree>
HWY_INLINE InAxes<V<double>> values_of(const SightTerms& terms, V<double> p, V<double> q) {
    const auto term = [&](int i, int j, int k) HWY_ATTR {
        return number(terms[patch_term(i, j)][static_cast<std::size_t>(k)]);
    };
    const auto row_of = [&](int i, int k) HWY_ATTR {
        V<double> row = term(i, degree - i, k);
        for (int j = degree - i - 1; j >= 0; --j)
            row = hn::MulAdd(row, q, term(i, j, k));
        return row;
    };
    InAxes<V<double>> all{
        .x = term(degree, 0, 0), .y = term(degree, 0, 1), .z = term(degree, 0, 2)};
    for (int i = degree - 1; i >= 0; --i) {
        all.x = hn::MulAdd(all.x, p, row_of(i, 0));
        all.y = hn::MulAdd(all.y, p, row_of(i, 1));
        all.z = hn::MulAdd(all.z, p, row_of(i, 2));
    }
    return all;
}

/// The results of zero_test for a vector of rays at (p, q).
struct Test {
    M<double> none;             ///< no zero within `inner`
    M<double> found;            ///< one, and its depth is known well enough
    M<double> wide;             ///< one, but that is not
    M<double> inside, outside;  ///< of the unit square, the places of the zeros
    RealBall<V<double>> depth;

    /// Whether nothing is to be learnt from a better place.
    [[nodiscard]] HWY_INLINE M<double> settled() const {
        return hn::Or(hn::Or(none, wide), hn::And(found, hn::Or(inside, outside)));
    }
};

/// The rays of one vector of doubles, half of a vector of floats.
struct HalfRays {
    SightLine<V<double>> line;
    Vector2<V<double>> place;
    Vector2<V<double>> g;
    Test test;
};

/// The rays of a vector of floats, with the slopes by (p, q) where Newton's method ended.
struct SolverEnd {
    std::array<HalfRays, 2> halves;
    SightLine<V<float>> line;
    FloatPoint at;
};

/// Rays on a piece, until Krawczyk's test has decided.
class Solver {
public:
    HWY_INLINE Solver(const Piece& piece, const FloatTerms& floats, const SightAxes& axes,
                      double tolerance)
        : piece_(piece), axes_(axes), tolerance_(tolerance), floats_(floats) {
        const auto is_within = [](double middle, double radius) {
            return middle - radius > 0x1p-40 && middle + radius < 1.0 - 0x1p-40;
        };
        is_within_ = is_within(piece.box.u, piece.box.u_radius) &&
                     is_within(piece.box.v, piece.box.v_radius);
    }

    /// `end`: with u, v and where the search begins of each half.
    template <int degree>
    HWY_INLINE void solve(SolverEnd& end) const {
        find<degree>(end);
        constexpr int most_tests = 3;
        for (int test = 1;; ++test) {
            bool is_settled = true;
            for (HalfRays& half : end.halves) {
                test_at<degree>(half);
                is_settled = is_settled && hn::AllTrue(d<double>, half.test.settled());
            }
            if (is_settled || test == most_tests) return;
            improve(end);
        }
    }

private:
    /// Newton's method in float.
    template <int degree>
    HWY_INLINE void find(SolverEnd& end) const {
        const auto& [lower, upper] = end.halves;
        Vector2<V<float>> at{.p = clamped(floats_of(lower.place.p, upper.place.p), 1.0),
                             .q = clamped(floats_of(lower.place.q, upper.place.q), 1.0)};
        end.line = {.u = floats_of(lower.line.u, upper.line.u),
                    .v = floats_of(lower.line.v, upper.line.v)};
        // Add the terms that are constant on a ray in double: they are large.
        const auto& constant = piece_.terms[0];
        const V<double> far = number(axes_.distance + constant[2]);
        const auto beside = [&](V<double> along, double from)
                                HWY_ATTR { return hn::NegMulAdd(along, far, number(from)); };
        const V<float> first1 =
            floats_of(beside(lower.line.u, constant[0]), beside(upper.line.u, constant[0]));
        const V<float> first2 =
            floats_of(beside(lower.line.v, constant[1]), beside(upper.line.v, constant[1]));
        constexpr int most_steps = 5;
        for (int step = 1;; ++step) {
            end.at =
                point_of([&](int k) HWY_ATTR { return slopes_of<degree>(floats_, k, at.p, at.q); });
            const auto& [a, b, s] = end.at.value;
            const Vector2<V<float>> g =
                end.line.across({.x = hn::Add(first1, a), .y = hn::Add(first2, b), .z = s});
            const Slopes2 by(slopes_of_g(end.line, end.at));
            const Vector2<V<float>> next = moved(at, by.step(g), 1.0);
            const V<float> small = number<float>(0x1p-11);
            const auto is_small = hn::And(hn::Le(hn::Abs(hn::Sub(next.p, at.p)), small),
                                          hn::Le(hn::Abs(hn::Sub(next.q, at.q)), small));
            at = next;
            if (step == most_steps || hn::AllTrue(d<float>, is_small)) break;
        }
        const auto ps = doubles_of(at.p);
        const auto qs = doubles_of(at.q);
        for (std::size_t i = 0; i < 2; ++i)
            end.halves[i].place = {.p = ps[i], .q = qs[i]};
    }

    /// A step of Newton's method in double, with the slopes of before.
    static HWY_INLINE void improve(SolverEnd& end) {
        const Slopes2 by(slopes_of_g(end.line, end.at));
        const auto pp = doubles_of(by.m.pp);
        const auto pq = doubles_of(by.m.pq);
        const auto qp = doubles_of(by.m.qp);
        const auto qq = doubles_of(by.m.qq);
        const auto inverse = doubles_of(by.inverse);
        const V<double> one = number(1.0);
        for (std::size_t i = 0; i < 2; ++i) {
            HalfRays& half = end.halves[i];
            const Matrix2<V<double>> slopes{.pp = pp[i], .pq = pq[i], .qp = qp[i], .qq = qq[i]};
            const Vector2<V<double>> step = zero_by_determinant(slopes, half.g);
            const M<double> settled = half.test.settled();
            const auto moved = [&](V<double> at, V<double> by_determinant) HWY_ATTR {
                const V<double> by_step = hn::Mul(by_determinant, inverse[i]);
                const V<double> to = hn::Min(hn::Max(hn::Add(at, by_step), hn::Neg(one)), one);
                return hn::IfThenElse(hn::Or(settled, hn::IsNaN(by_step)), at, to);
            };
            half.place = {.p = moved(half.place.p, step.p), .q = moved(half.place.q, step.q)};
        }
    }

    template <int degree>
    HWY_INLINE void test_at(HalfRays& rays) const {
        Test& test = rays.test;
        // Take Krawczyk's step from the places.
        const auto& [p, q] = rays.place;
        const InAxes<V<double>> at = values_of<degree>(piece_.terms, p, q);
        const auto g = rays.line.g(at, number(axes_.distance), number(piece_.sight.value_error));
        rays.g = {.p = g.p.middle, .q = g.q.middle};
        const KrawczykStep<V<double>> step =
            krawczyk_step(piece_.contraction, piece_.sight, g, rays.place, at.z);
        test.depth = step.depth;
        const V<double> to_p = hn::Add(p, step.by.p);
        const V<double> to_q = hn::Add(q, step.by.q);
        // Mark rays with no zero in the share, and with one that is known well enough.
        const auto beyond = [&](V<double> to) HWY_ATTR {
            return hn::Gt(hn::Sub(hn::Abs(to), step.radius), number(inner));
        };
        test.none = hn::And(step.known, hn::Or(beyond(to_p), beyond(to_q)));
        const M<double> one =
            hn::And(step.known, hn::Le(hn::Add(size_of(rays.place), step.reach), number(1.0)));
        const M<double> narrow =
            hn::Le(hn::Mul(number(2.0), test.depth.radius), number(tolerance_));
        test.found = hn::AndNot(test.none, hn::And(one, narrow));
        // More steps do not help where most of it is the model's error.
        const M<double> settled = hn::Le(size_of(step.by), hn::Mul(number(4.0), step.lost));
        test.wide = hn::And(hn::AndNot(hn::Or(test.none, narrow), one), settled);
        // Tell zeros inside of the unit square from those outside.
        test.inside = hn::Eq(number(0.0), number(0.0));
        test.outside = hn::Ne(number(0.0), number(0.0));
        if (is_within_) return;
        const Side in_u = side_of(to_p, step.radius, piece_.box.u, piece_.box.u_radius);
        const Side in_v = side_of(to_q, step.radius, piece_.box.v, piece_.box.v_radius);
        test.inside = hn::And(in_u.inside, in_v.inside);
        test.outside = hn::Or(in_u.outside, in_v.outside);
    }

    /// Where places are in [0, 1].
    struct Side {
        M<double> inside, outside;
    };
    static HWY_INLINE Side side_of(V<double> place, V<double> radius, double middle,
                                   double box_radius) {
        const V<double> at = hn::MulAdd(place, number(box_radius), number(middle));
        // Middles of halves are rounded.
        const V<double> error = hn::MulAdd(radius, number(box_radius), number(0x1p-48));
        const V<double> lo = hn::Sub(at, error);
        const V<double> hi = hn::Add(at, error);
        const V<double> zero = number(0.0);
        const V<double> one = number(1.0);
        return {.inside = hn::And(hn::Ge(lo, zero), hn::Le(hi, one)),
                .outside = hn::Or(hn::Lt(hi, zero), hn::Gt(lo, one))};
    }

    const Piece& piece_;
    const SightAxes& axes_;
    double tolerance_;
    bool is_within_;  ///< the piece does not touch the ends of the ranges
    const FloatTerms& floats_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
