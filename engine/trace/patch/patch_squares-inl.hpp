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
        by_pp_ = in_axes<V<float>>(pp);
        by_pq_ = in_axes<V<float>>(pq);
        by_qq_ = in_axes<V<float>>(qq);
        const glm::dvec3 squares = glm::abs(pp) + glm::abs(qq);
        const glm::dvec3 sizes = glm::abs(sight.c) + glm::abs(sight.kp) + glm::abs(sight.kq) +
                                 squares + glm::abs(pq) + glm::dvec3(0.0, 0.0, axes.distance);
        // Take half of each square and all of p q, known here, from the linear form's error.
        rest_ = in_axes<V<float>>((sight.e - 0.5 * squares - glm::abs(pq)) +
                                  LinearForm::float_rounding * sizes);
        squares_ = in_axes<V<float>>((squares + glm::abs(pq)) * (1.0 + 0x1p-20));
    }

    /// The zeros by the linear form, or by a step with the squares where that is better.
    HWY_INLINE Zeros zeros(const SightLine<V<float>>& ray) const {
        Zeros zeros = linear_.zeros(ray);
        const Step to = step(ray, zeros);
        const V<float> better = radius(ray, zeros, to);
        const M<float> is_better = hn::And(to.is_safe, hn::Lt(better, zeros.radius));
        zeros.p = hn::IfThenElse(is_better, to.p, zeros.p);
        zeros.q = hn::IfThenElse(is_better, to.q, zeros.q);
        zeros.radius = hn::IfThenElse(is_better, better, zeros.radius);
        const V<float> limit = hn::Add(zeros.radius, number<float>(inner));
        const M<float> beyond = hn::Gt(hn::Max(hn::Abs(zeros.p), hn::Abs(zeros.q)), limit);
        zeros.none = hn::Or(zeros.none, hn::And(is_better, beyond));
        return zeros;
    }

private:
    /// Where a step leads.
    struct Step {
        V<float> p, q;
        V<float> g;        ///< the larger size of g where it begins
        V<float> norm;     ///< M
        V<float> lost;     ///< a bound of the error of the determinant, relative to it
        M<float> is_safe;  ///< the inverse is known to 2^-9
    };
    /// The terms of degree 2 of g, about the middle of what p^2 and q^2 are.
    struct Squares {
        Vector2<V<float>> pp, pq, qq;

        HWY_INLINE Vector2<V<float>> value(V<float> p, V<float> q) const {
            const V<float> half = number<float>(0.5);
            const V<float> p2 = hn::Sub(hn::Mul(p, p), half);
            const V<float> q2 = hn::Sub(hn::Mul(q, q), half);
            const V<float> product = hn::Mul(p, q);
            const auto sum = [&](V<float> by_p, V<float> by_pq, V<float> by_q) HWY_ATTR {
                return hn::MulAdd(by_p, p2, hn::MulAdd(by_pq, product, hn::Mul(by_q, q2)));
            };
            return {.p = sum(pp.p, pq.p, qq.p), .q = sum(pp.q, pq.q, qq.q)};
        }
        /// The slopes of g at a place.
        HWY_INLINE Matrix2<V<float>> slopes(V<float> p, V<float> q,
                                            const Matrix2<V<float>>& linear) const {
            const auto slope = [](V<float> square, V<float> at, V<float> mixed, V<float> other,
                                  V<float> by) HWY_ATTR {
                return hn::MulAdd(hn::Add(square, square), at, hn::MulAdd(mixed, other, by));
            };
            return {.pp = slope(pp.p, p, pq.p, q, linear.pp),
                    .pq = slope(qq.p, q, pq.p, p, linear.pq),
                    .qp = slope(pp.q, p, pq.q, q, linear.qp),
                    .qq = slope(qq.q, q, pq.q, p, linear.qq)};
        }
    };

    static HWY_INLINE V<float> sum(V<float> a, V<float> b) {
        return hn::Add(hn::Abs(a), hn::Abs(b));
    }

    HWY_INLINE Step step(const SightLine<V<float>>& ray, const Zeros& at) const {
        const Squares squares{
            .pp = ray.across(by_pp_), .pq = ray.across(by_pq_), .qq = ray.across(by_qq_)};
        const Vector2<V<float>> g = squares.value(at.p, at.q);
        const Divisor2<V<float>> by = divisor_of(squares.slopes(at.p, at.q, at.slopes));
        const Vector2<V<float>> to = zero_by_determinant(by.m, g);
        return {.p = hn::MulAdd(to.p, by.inverse, at.p),
                .q = hn::MulAdd(to.q, by.inverse, at.q),
                .g = size_of(g),
                .norm = hn::Mul(hn::Max(sum(by.m.qq, by.m.pq), sum(by.m.pp, by.m.qp)), by.most()),
                .lost = hn::Add(by.lost(), by.lost()),
                .is_safe = hn::And(at.known, by.is_safe())};
    }

    /// How far zeros are from where a step leads at most.
    HWY_INLINE V<float> radius(const SightLine<V<float>>& ray, const Zeros& from,
                               const Step& to) const {
        const V<float> squares = larger(ray.most(squares_));
        const V<float> linear = norm_of(from.slopes);
        const V<float> out = hn::Add(number<float>(1.0), sum(from.p, from.q));
        // A generous bound of the rounding errors of the place, the slopes and the step.
        const V<float> sizes =
            hn::MulAdd(hn::MulAdd(number<float>(4.0), hn::Mul(squares, out), linear), from.radius,
                       hn::Mul(hn::Mul(hn::Add(squares, squares), out), out));
        const V<float> tiny = number<float>(LinearForm::float_rounding);
        const V<float> rounded = hn::MulAdd(linear, from.lost, hn::Mul(tiny, sizes));
        const V<float> terms = hn::MulAdd(
            to.lost, to.g,
            hn::MulAdd(hn::Mul(squares, from.radius), from.radius, larger(ray.most(rest_))));
        return hn::MulAdd(to.norm, hn::Add(terms, rounded),
                          hn::Mul(tiny, hn::Add(out, sum(to.p, to.q))));
    }

    LinearForm linear_;
    InAxes<V<float>> by_pp_, by_pq_, by_qq_;
    InAxes<V<float>> rest_, squares_;  ///< bounds: of all other terms, of these
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
