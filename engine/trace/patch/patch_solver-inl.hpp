// Newton's method on a piece of a leaf, and Krawczyk's test: zero_test (patch_sight.hpp) for a
// vector of rays. Included once for each instruction set, after Highway.

#if defined(ZEROSET_PATCH_SOLVER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_PATCH_SOLVER_INL
#undef ZEROSET_PATCH_SOLVER_INL
#else
#define ZEROSET_PATCH_SOLVER_INL
#endif

#include "engine/trace/patch/patch_pieces-inl.hpp"

#include <hwy/highway.h>

#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// What zero_test says of rays at (p, q).
struct Test {
    Mask none;   ///< no zero within `inner`
    Mask found;  ///< one, and its depth is known well enough
    Mask wide;   ///< one, but that is not
    Vector step_p, step_q, radius, s_radius;
};

/// Newton's method on the rays of a vector, until Krawczyk's test has decided.
class Solver {
public:
    HWY_INLINE Solver(const Piece& piece, const SightAxes& axes, double tolerance)
        : piece_(piece), axes_(axes), tolerance_(tolerance) {
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

    /// Where the search ended.
    struct End {
        Vector u, v, p, q;
        Slopes f1, f2;
        Test test;
        Mask inside, outside;  ///< of the unit square, the places of the zeros
    };

    HWY_INLINE End solve(Vector u, Vector v, Vector from_p, Vector from_q) const {
        const D d;
        const Vector one = number(1.0);
        End end;
        end.u = u;
        end.v = v;
        end.p = hn::Min(hn::Max(from_p, hn::Neg(one)), one);
        end.q = hn::Min(hn::Max(from_q, hn::Neg(one)), one);
        Polynomial g1;
        Polynomial g2;
        for (std::size_t i = 0; i < patch_terms; ++i) {
            const auto& term = piece_.terms[i];
            g1.terms[i] = hn::NegMulAdd(u, number(term[2]), number(term[0]));
            g2.terms[i] = hn::NegMulAdd(v, number(term[2]), number(term[1]));
        }
        g1.terms[0] = hn::NegMulAdd(u, number(axes_.distance), g1.terms[0]);
        g2.terms[0] = hn::NegMulAdd(v, number(axes_.distance), g2.terms[0]);
        constexpr int most_steps = 4;
        for (int step = 1;; ++step) {
            end.f1 = slopes_of(g1, end.p, end.q);
            end.f2 = slopes_of(g2, end.p, end.q);
            test_at(end);
            const Mask known = hn::Or(end.inside, end.outside);
            const Mask settled =
                hn::Or(hn::Or(end.test.none, end.test.wide), hn::And(end.test.found, known));
            if (step == most_steps || hn::AllTrue(d, settled)) return end;
            const Slopes& f1 = end.f1;
            const Slopes& f2 = end.f2;
            const Vector determinant = hn::NegMulAdd(f1.by_q, f2.by_p, hn::Mul(f1.by_p, f2.by_q));
            const Vector inverse = hn::Div(one, determinant);
            const Vector dp =
                hn::Mul(hn::NegMulAdd(f2.by_q, f1.value, hn::Mul(f1.by_q, f2.value)), inverse);
            const Vector dq =
                hn::Mul(hn::NegMulAdd(f1.by_p, f2.value, hn::Mul(f2.by_p, f1.value)), inverse);
            const auto moved = [&](Vector at, Vector by) HWY_ATTR {
                const Vector to = hn::Min(hn::Max(hn::Add(at, by), hn::Neg(one)), one);
                return hn::IfThenElse(hn::Or(settled, hn::IsNaN(by)), at, to);
            };
            end.p = moved(end.p, dp);
            end.q = moved(end.q, dq);
        }
    }

private:
    HWY_INLINE void test_at(End& end) const {
        const PatchSight& sight = piece_.sight;
        Test& test = end.test;
        const auto error_of = [&](Vector at, double most, Vector g) HWY_ATTR {
            const Vector size = hn::Abs(at);
            const Vector terms = hn::MulAdd(size, number(axes_.distance + s_most_), number(most));
            const Vector lost = hn::Mul(hn::Add(terms, hn::Abs(g)), number(rounding));
            return hn::MulAdd(hn::Add(number(1.0), size), number(sight.value_error), lost);
        };
        const Vector g1 = end.f1.value;
        const Vector g2 = end.f2.value;
        const Vector e1 = error_of(end.u, a_most_, g1);
        const Vector e2 = error_of(end.v, b_most_, g2);
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
        const Vector out = hn::Max(hn::Abs(end.p), hn::Abs(end.q));
        const Vector far = hn::Min(reach, hn::Add(number(1.0), out));
        test.radius = hn::Add(hn::MulAdd(number(norm), far, lost), number(0x1p-50));
        const Vector along = hn::MulAdd(number(sight.dp_radius.z), size_p,
                                        hn::Mul(number(sight.dq_radius.z), size_q));
        test.s_radius = hn::Add(hn::MulAdd(number(by_radius_), test.radius, along),
                                number(sight.value_error + rounding * s_most_));
        const Vector to_p = hn::Add(end.p, test.step_p);
        const Vector to_q = hn::Add(end.q, test.step_q);
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
        end.inside = hn::Eq(u_zero(), u_zero());
        end.outside = hn::Ne(u_zero(), u_zero());
        if (is_within_) return;
        const Side in_u = side_of(to_p, test.radius, piece_.box.u, piece_.box.u_radius);
        const Side in_v = side_of(to_q, test.radius, piece_.box.v, piece_.box.v_radius);
        end.inside = hn::And(in_u.inside, in_v.inside);
        end.outside = hn::Or(in_u.outside, in_v.outside);
    }

    static HWY_INLINE Vector u_zero() { return number(0.0); }

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
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
