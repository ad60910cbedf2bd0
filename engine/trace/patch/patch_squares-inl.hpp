// A step of Newton's method with the terms of degree 2 of a piece, from where its linear form has
// the zeros. Included once for each instruction set, after Highway.
//
// With J and Q the linear and the quadratic terms of g, about the middle of what Q is, all others
// within E, z the place and h = y - z for a zero y of g:
//   (J + Q'(z)) h = -(g(z) of these terms) - Q(h) - (what is in E),
// so that with |h| <= R, H the sum of the sizes of Q and M the norm of the inverse, zeros are
// within
//   M (E + H R^2)
// of where the step leads.

#if defined(ZEROSET_PATCH_SQUARES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_PATCH_SQUARES_INL
#undef ZEROSET_PATCH_SQUARES_INL
#else
#define ZEROSET_PATCH_SQUARES_INL
#endif

#include "engine/trace/patch/patch_pieces-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The terms up to degree 2 of a piece in float. In upward rounding.
class QuadraticForm {
public:
    HWY_INLINE QuadraticForm(const Piece& piece, const SightAxes& axes)
        : linear_(piece.sight, axes) {
        const PatchSight& sight = piece.sight;
        const auto term = [&](int i, int j) {
            const auto& of = piece.terms[patch_term(i, j)];
            return glm::dvec3(of[0], of[1], of[2]);
        };
        const glm::dvec3 pp = term(2, 0);
        const glm::dvec3 pq = term(1, 1);
        const glm::dvec3 qq = term(0, 2);
        by_pp_ = LinearForm::spread(pp);
        by_pq_ = LinearForm::spread(pq);
        by_qq_ = LinearForm::spread(qq);
        const glm::dvec3 squares = glm::abs(pp) + glm::abs(qq);
        const glm::dvec3 sizes = glm::abs(sight.c) + glm::abs(sight.kp) + glm::abs(sight.kq) +
                                 squares + glm::abs(pq) + glm::dvec3(0.0, 0.0, axes.distance);
        // Take half of each square and all of p q, known here, from the linear form's error.
        rest_ = LinearForm::spread((sight.e - 0.5 * squares - glm::abs(pq)) +
                                   LinearForm::float_rounding * sizes);
        squares_ = LinearForm::spread((squares + glm::abs(pq)) * (1.0 + 0x1p-20));
    }

    /// The zeros by the linear form, or by a step with the squares where that is better.
    HWY_INLINE Zeros zeros(Floats u, Floats v) const {
        Zeros zeros = linear_.zeros(u, v);
        const Step to = step(u, v, zeros);
        const Floats better = radius(u, v, zeros, to);
        const FloatMask is_better = hn::And(to.is_safe, hn::Lt(better, zeros.radius));
        zeros.p = hn::IfThenElse(is_better, to.p, zeros.p);
        zeros.q = hn::IfThenElse(is_better, to.q, zeros.q);
        zeros.radius = hn::IfThenElse(is_better, better, zeros.radius);
        const Floats limit = hn::Add(zeros.radius, float_number(inner));
        const FloatMask beyond = hn::Gt(hn::Max(hn::Abs(zeros.p), hn::Abs(zeros.q)), limit);
        zeros.none = hn::Or(zeros.none, hn::And(is_better, beyond));
        return zeros;
    }

private:
    /// Where a step leads.
    struct Step {
        Floats p, q;
        Floats g;           ///< the larger size of g where it begins
        Floats norm;        ///< M
        Floats lost;        ///< a bound of the error of the determinant, relative to it
        FloatMask is_safe;  ///< the inverse is known to 2^-9
    };
    /// The terms of degree 2 of one of g, about the middle of what p^2 and q^2 are.
    struct Squares {
        Floats pp, pq, qq;

        HWY_INLINE Floats value(Floats p, Floats q) const {
            const Floats half = float_number(0.5);
            return hn::MulAdd(
                pp, hn::Sub(hn::Mul(p, p), half),
                hn::MulAdd(pq, hn::Mul(p, q), hn::Mul(qq, hn::Sub(hn::Mul(q, q), half))));
        }
        HWY_INLINE Floats by_p(Floats p, Floats q, Floats linear) const {
            return hn::MulAdd(hn::Add(pp, pp), p, hn::MulAdd(pq, q, linear));
        }
        HWY_INLINE Floats by_q(Floats p, Floats q, Floats linear) const {
            return hn::MulAdd(hn::Add(qq, qq), q, hn::MulAdd(pq, p, linear));
        }
    };

    static HWY_INLINE Floats sum(Floats a, Floats b) { return hn::Add(hn::Abs(a), hn::Abs(b)); }
    /// The larger one of bounds for g by those for (a, b, s).
    static HWY_INLINE Floats most_of(const LinearForm::Place& of, Floats u, Floats v) {
        return hn::Max(hn::MulAdd(hn::Abs(u), of.z, of.x), hn::MulAdd(hn::Abs(v), of.z, of.y));
    }

    HWY_INLINE Step step(Floats u, Floats v, const Zeros& at) const {
        const auto of_u = [&](const LinearForm::Place& of)
                              HWY_ATTR { return hn::NegMulAdd(u, of.z, of.x); };
        const auto of_v = [&](const LinearForm::Place& of)
                              HWY_ATTR { return hn::NegMulAdd(v, of.z, of.y); };
        const Squares first{.pp = of_u(by_pp_), .pq = of_u(by_pq_), .qq = of_u(by_qq_)};
        const Squares second{.pp = of_v(by_pp_), .pq = of_v(by_pq_), .qq = of_v(by_qq_)};
        const Floats g1 = first.value(at.p, at.q);
        const Floats g2 = second.value(at.p, at.q);
        const Floats pp = first.by_p(at.p, at.q, at.pp);
        const Floats pq = first.by_q(at.p, at.q, at.pq);
        const Floats qp = second.by_p(at.p, at.q, at.qp);
        const Floats qq = second.by_q(at.p, at.q, at.qq);
        const Floats product = hn::Mul(pp, qq);
        const Floats other = hn::Mul(pq, qp);
        const Floats determinant = hn::Sub(product, other);
        const Floats inverse = hn::Div(float_number(1.0), determinant);
        const Floats size = sum(product, other);
        const Floats is = hn::Abs(determinant);
        return {.p = hn::MulAdd(hn::NegMulAdd(qq, g1, hn::Mul(pq, g2)), inverse, at.p),
                .q = hn::MulAdd(hn::NegMulAdd(pp, g2, hn::Mul(qp, g1)), inverse, at.q),
                .g = hn::Max(hn::Abs(g1), hn::Abs(g2)),
                .norm = hn::Mul(hn::Mul(hn::Max(sum(qq, pq), sum(pp, qp)), hn::Abs(inverse)),
                                float_number(1.0 + 0x1p-8)),
                .lost = hn::Mul(hn::Mul(size, hn::Abs(inverse)),
                                float_number(2.0 * LinearForm::float_rounding)),
                // The limits of LinearForm::zeros.
                .is_safe = hn::And(hn::And(at.known, hn::Lt(size, float_number(0x1p120))),
                                   hn::And(hn::Gt(is, float_number(0x1p-80)),
                                           hn::Gt(is, hn::Mul(float_number(0x1p-10), size))))};
    }

    /// How far zeros are from where a step leads at most.
    HWY_INLINE Floats radius(Floats u, Floats v, const Zeros& from, const Step& to) const {
        const Floats squares = most_of(squares_, u, v);
        const Floats linear = hn::Max(sum(from.pp, from.pq), sum(from.qp, from.qq));
        const Floats out = hn::Add(float_number(1.0), sum(from.p, from.q));
        // A generous bound of the rounding errors of the place, the slopes and the step.
        const Floats sizes =
            hn::MulAdd(hn::MulAdd(float_number(4.0), hn::Mul(squares, out), linear), from.radius,
                       hn::Mul(hn::Mul(hn::Add(squares, squares), out), out));
        const Floats tiny = float_number(LinearForm::float_rounding);
        const Floats rounded = hn::MulAdd(linear, from.lost, hn::Mul(tiny, sizes));
        const Floats terms = hn::MulAdd(
            to.lost, to.g,
            hn::MulAdd(hn::Mul(squares, from.radius), from.radius, most_of(rest_, u, v)));
        return hn::MulAdd(to.norm, hn::Add(terms, rounded),
                          hn::Mul(tiny, hn::Add(out, sum(to.p, to.q))));
    }

    LinearForm linear_;
    LinearForm::Place by_pp_, by_pq_, by_qq_;
    LinearForm::Place rest_, squares_;  ///< bounds: of all other terms, of these
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
