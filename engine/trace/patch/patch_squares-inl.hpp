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

#include <limits>

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
        // Of the linear form's error, half of each square and all of p q are known here.
        rest_ = LinearForm::spread((sight.e - 0.5 * squares - glm::abs(pq)) +
                                   LinearForm::float_rounding * sizes);
        squares_ = LinearForm::spread((squares + glm::abs(pq)) * (1.0 + 0x1p-20));
    }

    /// As of the linear form, or better.
    HWY_INLINE Zeros zeros(Floats u, Floats v) const {
        Zeros zeros = linear_.zeros(u, v);
        const auto of_u = [&](const LinearForm::Place& of)
                              HWY_ATTR { return hn::NegMulAdd(u, of.z, of.x); };
        const auto of_v = [&](const LinearForm::Place& of)
                              HWY_ATTR { return hn::NegMulAdd(v, of.z, of.y); };
        const Floats p = zeros.p;
        const Floats q = zeros.q;
        const Floats half = float_number(0.5);
        const Floats pp = hn::Sub(hn::Mul(p, p), half);
        const Floats pq = hn::Mul(p, q);
        const Floats qq = hn::Sub(hn::Mul(q, q), half);
        const auto value = [&](Floats by_pp, Floats by_pq, Floats by_qq) HWY_ATTR {
            return hn::MulAdd(by_pp, pp, hn::MulAdd(by_pq, pq, hn::Mul(by_qq, qq)));
        };
        const Floats u_pp = of_u(by_pp_);
        const Floats u_pq = of_u(by_pq_);
        const Floats u_qq = of_u(by_qq_);
        const Floats v_pp = of_v(by_pp_);
        const Floats v_pq = of_v(by_pq_);
        const Floats v_qq = of_v(by_qq_);
        const Floats g1 = value(u_pp, u_pq, u_qq);
        const Floats g2 = value(v_pp, v_pq, v_qq);
        const auto slope = [&](Floats linear, Floats square, Floats at, Floats mixed,
                               Floats other) HWY_ATTR {
            return hn::MulAdd(hn::Add(square, square), at, hn::MulAdd(mixed, other, linear));
        };
        const Floats g1_p = slope(zeros.pp, u_pp, p, u_pq, q);
        const Floats g1_q = slope(zeros.pq, u_qq, q, u_pq, p);
        const Floats g2_p = slope(zeros.qp, v_pp, p, v_pq, q);
        const Floats g2_q = slope(zeros.qq, v_qq, q, v_pq, p);
        const Floats first = hn::Mul(g1_p, g2_q);
        const Floats second = hn::Mul(g1_q, g2_p);
        const Floats determinant = hn::Sub(first, second);
        const Floats inverse = hn::Div(float_number(1.0), determinant);
        const Floats to_p = hn::MulAdd(hn::NegMulAdd(g2_q, g1, hn::Mul(g1_q, g2)), inverse, p);
        const Floats to_q = hn::MulAdd(hn::NegMulAdd(g1_p, g2, hn::Mul(g2_p, g1)), inverse, q);
        // All in sizes from here on.
        const auto sum = [](Floats a, Floats b)
                             HWY_ATTR { return hn::Add(hn::Abs(a), hn::Abs(b)); };
        const auto most_of = [&](const LinearForm::Place& of) HWY_ATTR {
            return hn::Max(hn::MulAdd(hn::Abs(u), of.z, of.x), hn::MulAdd(hn::Abs(v), of.z, of.y));
        };
        const Floats norm = hn::Mul(hn::Max(sum(g2_q, g1_q), sum(g1_p, g2_p)), hn::Abs(inverse));
        const Floats squares = most_of(squares_);
        const Floats linear = hn::Max(sum(zeros.pp, zeros.pq), sum(zeros.qp, zeros.qq));
        const Floats out = hn::Add(float_number(1.0), sum(p, q));
        const Floats radius = zeros.radius;
        // What rounding makes of the place, of the slopes and of the step, generously.
        const Floats rounded = hn::MulAdd(
            linear, zeros.lost,
            hn::Mul(float_number(LinearForm::float_rounding),
                    hn::MulAdd(hn::MulAdd(float_number(4.0), hn::Mul(squares, out), linear), radius,
                               hn::Mul(hn::Mul(hn::Add(squares, squares), out), out))));
        // And of the determinant, relative to it.
        const Floats size = hn::Add(hn::Abs(first), hn::Abs(second));
        const Floats lost = hn::Mul(hn::Mul(size, hn::Abs(inverse)),
                                    float_number(2.0 * LinearForm::float_rounding));
        const Floats terms =
            hn::MulAdd(lost, hn::Max(hn::Abs(g1), hn::Abs(g2)),
                       hn::MulAdd(hn::Mul(squares, radius), radius, most_of(rest_)));
        const FloatMask is_safe =
            hn::And(zeros.known,
                    hn::And(hn::Gt(hn::Abs(determinant), float_number(0x1p-80)),
                            hn::Gt(hn::Abs(determinant), hn::Mul(float_number(0x1p-10), size))));
        // The inverse is known to 2^-9.
        const Floats better = hn::MulAdd(
            hn::Mul(norm, float_number(1.0 + 0x1p-8)), hn::Add(terms, rounded),
            hn::Mul(float_number(LinearForm::float_rounding), hn::Add(out, sum(to_p, to_q))));
        const FloatMask is_better = hn::And(is_safe, hn::Lt(better, radius));
        zeros.p = hn::IfThenElse(is_better, to_p, p);
        zeros.q = hn::IfThenElse(is_better, to_q, q);
        zeros.radius = hn::IfThenElse(is_better, better, radius);
        const Floats limit = hn::Add(zeros.radius, float_number(inner));
        const FloatMask beyond = hn::Gt(hn::Max(hn::Abs(zeros.p), hn::Abs(zeros.q)), limit);
        zeros.none = hn::Or(zeros.none, hn::And(is_better, beyond));
        return zeros;
    }

private:
    LinearForm linear_;
    LinearForm::Place by_pp_, by_pq_, by_qq_;
    LinearForm::Place rest_, squares_;  ///< bounds: of all other terms, of these
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
