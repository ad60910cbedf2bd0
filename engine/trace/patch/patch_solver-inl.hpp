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
struct Values {
    Vector a, b, s;
};

template <int degree>
HWY_INLINE Values values_of(const SightTerms& terms, Vector p, Vector q) {
    const auto term = [&](int i, int j, int k) HWY_ATTR {
        return number(terms[patch_term(i, j)][static_cast<std::size_t>(k)]);
    };
    const auto row_of = [&](int i, int k) HWY_ATTR {
        Vector row = term(i, degree - i, k);
        for (int j = degree - i - 1; j >= 0; --j)
            row = hn::MulAdd(row, q, term(i, j, k));
        return row;
    };
    Values all{.a = term(degree, 0, 0), .b = term(degree, 0, 1), .s = term(degree, 0, 2)};
    for (int i = degree - 1; i >= 0; --i) {
        all.a = hn::MulAdd(all.a, p, row_of(i, 0));
        all.b = hn::MulAdd(all.b, p, row_of(i, 1));
        all.s = hn::MulAdd(all.s, p, row_of(i, 2));
    }
    return all;
}

/// The results of zero_test for a vector of rays at (p, q).
struct Test {
    Mask none;             ///< no zero within `inner`
    Mask found;            ///< one, and its depth is known well enough
    Mask wide;             ///< one, but that is not
    Mask inside, outside;  ///< of the unit square, the places of the zeros
    Vector step_p, step_q, radius, s_radius;

    /// Whether nothing is to be learnt from a better place.
    [[nodiscard]] HWY_INLINE Mask settled() const {
        return hn::Or(hn::Or(none, wide), hn::And(found, hn::Or(inside, outside)));
    }
};

/// The rays of one vector of doubles, half of a vector of floats.
struct HalfRays {
    Vector u, v, p, q;
    Vector g1, g2;
    Values at;
    Test test;
};

/// The rays of a vector of floats, with the slopes by (p, q) where Newton's method ended.
struct SolverEnd {
    std::array<HalfRays, 2> halves;
    Floats u, v;
    FloatSlopes a, b, s;
};

/// Rays on a piece, until Krawczyk's test has decided.
class Solver {
public:
    HWY_INLINE Solver(const Piece& piece, const FloatTerms& floats, const SightAxes& axes,
                      double tolerance)
        : piece_(piece), axes_(axes), tolerance_(tolerance), floats_(floats) {
        const PatchSight& sight = piece.sight;
        const glm::dvec3 most = glm::abs(sight.c) + sight.spread();
        a_most_ = most.x;
        b_most_ = most.y;
        s_most_ = most.z;
        by_radius_ =
            std::abs(sight.dp.z) + sight.dp_radius.z + std::abs(sight.dq.z) + sight.dq_radius.z;
        const auto is_within = [](double middle, double radius) {
            return middle - radius > 0x1p-40 && middle + radius < 1.0 - 0x1p-40;
        };
        is_within_ = is_within(piece.box.u, piece.box.u_radius) &&
                     is_within(piece.box.v, piece.box.v_radius);
    }

    /// `end`: with u, v and where the search begins of each half.
    template <int degree>
    HWY_INLINE void solve(SolverEnd& end) const {
        const D d;
        find<degree>(end);
        constexpr int most_tests = 3;
        for (int test = 1;; ++test) {
            bool is_settled = true;
            for (HalfRays& half : end.halves) {
                test_at<degree>(half);
                is_settled = is_settled && hn::AllTrue(d, half.test.settled());
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
        const Floats one = float_number(1.0);
        const auto clamped = [&](Floats at)
                                 HWY_ATTR { return hn::Min(hn::Max(at, hn::Neg(one)), one); };
        Floats p = clamped(floats_of(lower.p, upper.p));
        Floats q = clamped(floats_of(lower.q, upper.q));
        end.u = floats_of(lower.u, upper.u);
        end.v = floats_of(lower.v, upper.v);
        // Add the terms that are constant on a ray in double: they are large.
        const auto& constant = piece_.terms[0];
        const Vector far = number(axes_.distance + constant[2]);
        const auto beside = [&](Vector along, double at)
                                HWY_ATTR { return hn::NegMulAdd(along, far, number(at)); };
        const Floats first1 = floats_of(beside(lower.u, constant[0]), beside(upper.u, constant[0]));
        const Floats first2 = floats_of(beside(lower.v, constant[1]), beside(upper.v, constant[1]));
        constexpr int most_steps = 5;
        for (int step = 1;; ++step) {
            end.a = slopes_of<degree>(floats_, 0, p, q);
            end.b = slopes_of<degree>(floats_, 1, p, q);
            end.s = slopes_of<degree>(floats_, 2, p, q);
            const Floats g1 = hn::NegMulAdd(end.u, end.s.value, hn::Add(first1, end.a.value));
            const Floats g2 = hn::NegMulAdd(end.v, end.s.value, hn::Add(first2, end.b.value));
            const Slopes2 by(end.a, end.b, end.s, end.u, end.v);
            const Floats dp = by.step_p(g1, g2);
            const Floats dq = by.step_q(g1, g2);
            const auto moved = [&](Floats at, Floats step_by) HWY_ATTR {
                return hn::IfThenElse(hn::IsNaN(step_by), at, clamped(hn::Add(at, step_by)));
            };
            const Floats next_p = moved(p, dp);
            const Floats next_q = moved(q, dq);
            const Floats small = float_number(0x1p-11);
            const auto is_small = hn::And(hn::Le(hn::Abs(hn::Sub(next_p, p)), small),
                                          hn::Le(hn::Abs(hn::Sub(next_q, q)), small));
            p = next_p;
            q = next_q;
            if (step == most_steps || hn::AllTrue(df, is_small)) break;
        }
        const auto ps = doubles_of(p);
        const auto qs = doubles_of(q);
        for (std::size_t i = 0; i < 2; ++i) {
            end.halves[i].p = ps[i];
            end.halves[i].q = qs[i];
        }
    }

    /// A step of Newton's method in double, with the slopes of before.
    static HWY_INLINE void improve(SolverEnd& end) {
        const Slopes2 by(end.a, end.b, end.s, end.u, end.v);
        const auto pp = doubles_of(by.pp);
        const auto pq = doubles_of(by.pq);
        const auto qp = doubles_of(by.qp);
        const auto qq = doubles_of(by.qq);
        const auto inverse = doubles_of(by.inverse);
        const Vector one = number(1.0);
        for (std::size_t i = 0; i < 2; ++i) {
            HalfRays& half = end.halves[i];
            const Vector dp =
                hn::Mul(hn::NegMulAdd(qq[i], half.g1, hn::Mul(pq[i], half.g2)), inverse[i]);
            const Vector dq =
                hn::Mul(hn::NegMulAdd(pp[i], half.g2, hn::Mul(qp[i], half.g1)), inverse[i]);
            const Mask settled = half.test.settled();
            const auto moved = [&](Vector at, Vector by_step) HWY_ATTR {
                const Vector to = hn::Min(hn::Max(hn::Add(at, by_step), hn::Neg(one)), one);
                return hn::IfThenElse(hn::Or(settled, hn::IsNaN(by_step)), at, to);
            };
            half.p = moved(half.p, dp);
            half.q = moved(half.q, dq);
        }
    }

    template <int degree>
    HWY_INLINE void test_at(HalfRays& rays) const {
        const PatchSight& sight = piece_.sight;
        Test& test = rays.test;
        // Compute g at the places, and bounds of its error.
        rays.at = values_of<degree>(piece_.terms, rays.p, rays.q);
        const Vector distance = number(axes_.distance);
        rays.g1 = hn::NegMulAdd(rays.u, rays.at.s, hn::NegMulAdd(rays.u, distance, rays.at.a));
        rays.g2 = hn::NegMulAdd(rays.v, rays.at.s, hn::NegMulAdd(rays.v, distance, rays.at.b));
        const auto error_of = [&](Vector at, double most, Vector g) HWY_ATTR {
            const Vector size = hn::Abs(at);
            const Vector terms = hn::MulAdd(size, number(axes_.distance + s_most_), number(most));
            const Vector lost = hn::Mul(hn::Add(terms, hn::Abs(g)), number(rounding));
            return hn::MulAdd(hn::Add(number(1.0), size), number(sight.value_error), lost);
        };
        const Vector g1 = rays.g1;
        const Vector g2 = rays.g2;
        const Vector e1 = error_of(rays.u, a_most_, g1);
        const Vector e2 = error_of(rays.v, b_most_, g2);
        // Take the step -Y g, with a bound of its error.
        const Matrix2& y = piece_.contraction.inverse;
        const Matrix2& size = piece_.contraction.size;
        test.step_p = hn::Neg(hn::MulAdd(number(y.pp), g1, hn::Mul(number(y.pq), g2)));
        test.step_q = hn::Neg(hn::MulAdd(number(y.qp), g1, hn::Mul(number(y.qq), g2)));
        const Vector lost = hn::Max(hn::MulAdd(number(size.pp), e1, hn::Mul(number(size.pq), e2)),
                                    hn::MulAdd(number(size.qp), e1, hn::Mul(number(size.qq), e2)));
        const Vector size_p = hn::Abs(test.step_p);
        const Vector size_q = hn::Abs(test.step_q);
        const double norm = piece_.contraction.norm;
        // 1 / (1 - norm), with 1 - norm rounded downward.
        const double per_rest = 1.0 / -(norm - 1.0) * (1.0 + rounding);
        const Vector reach = hn::Mul(hn::Add(hn::Max(size_p, size_q), lost), number(per_rest));
        const Vector out = hn::Max(hn::Abs(rays.p), hn::Abs(rays.q));
        const Vector far = hn::Min(reach, hn::Add(number(1.0), out));
        test.radius = hn::Add(hn::MulAdd(number(norm), far, lost), number(0x1p-50));
        const Vector along = hn::MulAdd(number(sight.dp_radius.z), size_p,
                                        hn::Mul(number(sight.dq_radius.z), size_q));
        test.s_radius = hn::Add(hn::MulAdd(number(by_radius_), test.radius, along),
                                number(sight.value_error + rounding * s_most_));
        const Vector to_p = hn::Add(rays.p, test.step_p);
        const Vector to_q = hn::Add(rays.q, test.step_q);
        // Mark rays with no zero in the share, and with one that is known well enough.
        const auto beyond = [&](Vector at) HWY_ATTR {
            return hn::Gt(hn::Sub(hn::Abs(at), test.radius), number(inner));
        };
        test.none = hn::Or(beyond(to_p), beyond(to_q));
        const Mask one = hn::Le(hn::Add(out, reach), number(1.0));
        const Mask narrow = hn::Le(hn::Mul(number(2.0), test.s_radius), number(tolerance_));
        test.found = hn::AndNot(test.none, hn::And(one, narrow));
        // More steps do not help where most of it is the model's error.
        const Mask settled = hn::Le(hn::Max(size_p, size_q), hn::Mul(number(4.0), lost));
        test.wide = hn::And(hn::AndNot(hn::Or(test.none, narrow), one), settled);
        // Tell zeros inside of the unit square from those outside.
        test.inside = hn::Eq(number(0.0), number(0.0));
        test.outside = hn::Ne(number(0.0), number(0.0));
        if (is_within_) return;
        const Side in_u = side_of(to_p, test.radius, piece_.box.u, piece_.box.u_radius);
        const Side in_v = side_of(to_q, test.radius, piece_.box.v, piece_.box.v_radius);
        test.inside = hn::And(in_u.inside, in_v.inside);
        test.outside = hn::Or(in_u.outside, in_v.outside);
    }

    /// Where places are in [0, 1].
    struct Side {
        Mask inside, outside;
    };
    static HWY_INLINE Side side_of(Vector place, Vector radius, double middle, double box_radius) {
        const Vector at = hn::MulAdd(place, number(box_radius), number(middle));
        // Middles of halves are rounded.
        const Vector error = hn::MulAdd(radius, number(box_radius), number(0x1p-48));
        const Vector lo = hn::Sub(at, error);
        const Vector hi = hn::Add(at, error);
        const Vector zero = number(0.0);
        const Vector one = number(1.0);
        return {.inside = hn::And(hn::Ge(lo, zero), hn::Le(hi, one)),
                .outside = hn::Or(hn::Lt(hi, zero), hn::Gt(lo, one))};
    }

    const Piece& piece_;
    const SightAxes& axes_;
    double tolerance_;
    double a_most_, b_most_, s_most_;
    double by_radius_;
    bool is_within_;  ///< the piece does not touch the ends of the ranges
    const FloatTerms& floats_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
