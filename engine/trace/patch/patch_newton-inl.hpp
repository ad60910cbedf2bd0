// Newton's method in float on a piece of a leaf, with a proof for each ray.
// Included once for each instruction set, after Highway.
//
// With Y near the inverse of g' at x, n = -Y g(x), and h = y - x for a zero y of g:
//   h = n + (I - Y g') h,   |I - Y g'| <= k0 + K |h| / 2,
// where g' is its mean between x and y, k0 is what rounding makes of g'(x), and K is a bound of Y
// times the second derivatives. All zeros of the piece are within a distance R of x, by its
// linear form; so with d = |n| and k = k0 + K R / 2 below 1
//   |h| <= d / (1 - k) = r,   |y - (x + n)| <= (k0 + K r / 2) r.
// There is a zero where the ball of radius r about x is in the piece [Krawczyk69]. Unlike
// Krawczyk's test of all of a piece this does not ask how the derivatives vary over it.

#if defined(ZEROSET_PATCH_NEWTON_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_PATCH_NEWTON_INL
#undef ZEROSET_PATCH_NEWTON_INL
#else
#define ZEROSET_PATCH_NEWTON_INL
#endif

#include "engine/trace/patch/patch_pieces-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A polynomial's value and slopes.
struct FloatSlopes {
    Floats value, by_p, by_q;
};

/// The terms of a piece in float: of (a, b, s). Those below degree 3 are 0 in `terms`.
struct FloatTerms {
    float terms[patch_terms][4];
    float by_p[4], by_q[4];              ///< p, q
    float by_pp[4], by_pq[4], by_qq[4];  ///< p^2, p q, q^2

    explicit FloatTerms(const Piece& piece) {
        const D4 d4;
        const hn::Rebind<float, D4> f4;
        for (std::size_t k = 0; k < 4; k += step4) {
            const auto put = [&](std::size_t i, float* to) HWY_ATTR {
                hn::StoreU(hn::DemoteTo(f4, hn::Load(d4, piece.terms[i].data() + k)), f4, to + k);
            };
            constexpr std::size_t first = patch_term(3, 0);
            for (std::size_t i = 0; i < first; ++i)
                hn::StoreU(hn::Zero(f4), f4, terms[i] + k);
            put(patch_term(1, 0), by_p);
            put(patch_term(0, 1), by_q);
            put(patch_term(2, 0), by_pp);
            put(patch_term(1, 1), by_pq);
            put(patch_term(0, 2), by_qq);
            for (std::size_t i = first; i < terms_of(piece.degree); ++i)
                put(i, terms[i]);
        }
    }
};

/// The terms of a coordinate from degree 3 on, and the slopes of all terms.
template <int degree>
HWY_INLINE FloatSlopes high_terms_of(const FloatTerms& f, int k, Floats p, Floats q) {
    const Floats pq = hn::Set(df, f.by_pq[k]);
    const auto twice = [&](const float* from) HWY_ATTR { return hn::Set(df, 2.0F * from[k]); };
    FloatSlopes low{
        .value = hn::Zero(df),
        .by_p = hn::MulAdd(twice(f.by_pp), p, hn::MulAdd(pq, q, hn::Set(df, f.by_p[k]))),
        .by_q = hn::MulAdd(twice(f.by_qq), q, hn::MulAdd(pq, p, hn::Set(df, f.by_q[k])))};
    if constexpr (degree <= 2) return low;
    const auto term = [&](int i, int j)
                          HWY_ATTR { return hn::Set(df, f.terms[patch_term(i, j)][k]); };
    FloatSlopes all{.value = term(degree, 0), .by_p = hn::Zero(df), .by_q = hn::Zero(df)};
    for (int i = degree - 1; i >= 0; --i) {
        // The terms with p^i, and their slope by q.
        Floats row = term(i, degree - i);
        Floats by_q = row;
        // Those below degree 3 are not there.
        const int lowest = std::max(0, 3 - i);
        for (int j = degree - i - 1; j >= 1; --j) {
            row = j >= lowest ? hn::MulAdd(row, q, term(i, j)) : hn::Mul(row, q);
            by_q = hn::MulAdd(by_q, q, row);
        }
        row = lowest > 0 ? hn::Mul(row, q) : hn::MulAdd(row, q, term(i, 0));
        all.by_p = i == degree - 1 ? all.value : hn::MulAdd(all.by_p, p, all.value);
        all.value = hn::MulAdd(all.value, p, row);
        all.by_q = i == degree - 1 ? by_q : hn::MulAdd(all.by_q, p, by_q);
    }
    all.by_p = hn::Add(all.by_p, low.by_p);
    all.by_q = hn::Add(all.by_q, low.by_q);
    return all;
}

/// A coordinate, but for its constant.
template <int degree>
HWY_INLINE FloatSlopes slopes_of(const FloatTerms& f, int k, Floats p, Floats q) {
    FloatSlopes all = high_terms_of<degree>(f, k, p, q);
    const auto set = [&](const float* from) HWY_ATTR { return hn::Set(df, from[k]); };
    const Floats by_p = hn::MulAdd(set(f.by_pp), p, hn::MulAdd(set(f.by_pq), q, set(f.by_p)));
    const Floats by_q = hn::MulAdd(set(f.by_qq), q, set(f.by_q));
    all.value = hn::Add(all.value, hn::MulAdd(by_p, p, hn::Mul(by_q, q)));
    return all;
}

/// The derivatives of g, and 1 over their determinant.
struct Slopes2 {
    Floats pp, pq, qp, qq, inverse;

    HWY_INLINE Slopes2(const FloatSlopes& a, const FloatSlopes& b, const FloatSlopes& s, Floats u,
                       Floats v) {
        pp = hn::NegMulAdd(u, s.by_p, a.by_p);
        pq = hn::NegMulAdd(u, s.by_q, a.by_q);
        qp = hn::NegMulAdd(v, s.by_p, b.by_p);
        qq = hn::NegMulAdd(v, s.by_q, b.by_q);
        const Floats determinant = hn::NegMulAdd(pq, qp, hn::Mul(pp, qq));
        inverse = hn::Div(float_number(1.0), determinant);
    }
    /// Newton's step where g is (g1, g2).
    [[nodiscard]] HWY_INLINE Floats step_p(Floats g1, Floats g2) const {
        return hn::Mul(hn::NegMulAdd(qq, g1, hn::Mul(pq, g2)), inverse);
    }
    [[nodiscard]] HWY_INLINE Floats step_q(Floats g1, Floats g2) const {
        return hn::Mul(hn::NegMulAdd(pp, g2, hn::Mul(qp, g1)), inverse);
    }
};

/// Where Newton's method may go, and bounds of polynomials hold: |p|, |q| <= newton_limit.
constexpr double newton_limit = 1.125;

/// Bounds for the polynomials of a piece in each of (a, b, s), by the sums of the sizes of their
/// terms of each degree. In upward rounding.
struct NewtonBounds {
    /// Of the sum of second derivatives, but for those of the terms of degree 2, and of what
    /// rounding in float makes of the slopes.
    double bend[4], slope_error[4];
    double square[4];  ///< of the second derivatives of the terms of degree 2
    /// Of what rounding makes of the terms from degree 3 on, where |p|, |q| <= 1. A term of degree
    /// n is rounded n + 4 times at most, each time by 2^-23 of it.
    double error[4];

    explicit NewtonBounds(const Piece& piece) {
        const D4 d4;
        for (std::size_t k = 0; k < 4; k += step4) {
            V4 all[3] = {hn::Zero(d4), hn::Zero(d4), hn::Zero(d4)};
            double power = 1.0;  // newton_limit^(n - 1)
            for (int n = 1; n <= piece.first_degree; ++n, power *= newton_limit) {
                const V4 size = size_of_degree(piece.terms, n, k);
                const auto add = [&](V4& to, double factor)
                                     HWY_ATTR { to = hn::MulAdd(size, hn::Set(d4, factor), to); };
                if (n == 2) hn::StoreU(hn::Add(size, size), d4, square + k);
                // Products with the second derivatives are rounded, too.
                add(all[0], n * (n - 1) * power / newton_limit * (n == 2 ? 0x1p-19 : 1.0));
                if (n > 2) add(all[1], 0x1p-23 * (n + 5));
                add(all[2], 0x1p-20 * n * (n + 2) * power);
            }
            hn::StoreU(all[0], d4, bend + k);
            hn::StoreU(all[1], d4, error + k);
            hn::StoreU(all[2], d4, slope_error + k);
        }
    }
};

/// The rays that are solved at once, twice as many as vectors of doubles have numbers.
struct NewtonRays {
    std::array<Vector, 2> u, v;
    Floats p, q;    ///< where the search begins
    Floats spread;  ///< from where all zeros of the piece are within this
};

/// What is known of them.
struct NewtonEnd {
    FloatMask none;   ///< no zero within `inner`
    FloatMask found;  ///< one, in the unit square, and its depth is known well enough
    std::array<Vector, 2> s;
    FloatSlopes at_a, at_b, at_s;  ///< where the search ended: terms from degree 2 on, all slopes
};

/// Newton's method for rays on a piece.
class Newton {
public:
    HWY_INLINE Newton(const Piece& piece, const FloatTerms& floats, const SightAxes& axes,
                      double tolerance)
        : piece_(piece),
          floats_(floats),
          distance_(axes.distance),
          tolerance_(tolerance),
          bounds_(piece) {
        const PatchSight& sight = piece.sight;
        const glm::dvec3 most = glm::abs(sight.c) + sight.spread();
        const double error = sight.value_error + piece.first_error;
        a_error_ = error + bounds_.error[0] + rounding * most.x;
        b_error_ = error + bounds_.error[1] + rounding * most.y;
        along_error_ = error + bounds_.error[2] + rounding * (distance_ + most.z);
        s_error_ = error + bounds_.error[2] + rounding * most.z;
    }

    template <int degree>
    HWY_INLINE NewtonEnd solve(const NewtonRays& rays) const {
        const Floats u = floats_of(rays.u[0], rays.u[1]);
        const Floats v = floats_of(rays.v[0], rays.v[1]);
        Floats p = clamped(rays.p);
        Floats q = clamped(rays.q);
        // What is constant on a ray is large: in double.
        const auto& constant = piece_.terms[0];
        const Vector far = number(distance_ + constant[2]);
        const auto beside = [&](Vector along, double at)
                                HWY_ATTR { return hn::NegMulAdd(along, far, number(at)); };
        const std::array first1{beside(rays.u[0], constant[0]), beside(rays.u[1], constant[0])};
        const std::array first2{beside(rays.v[0], constant[1]), beside(rays.v[1], constant[1])};
        const Floats c1 = floats_of(first1[0], first1[1]);
        const Floats c2 = floats_of(first2[0], first2[1]);
        step<std::min(degree, 3)>(u, v, c1, c2, p, q);
        step<std::min(degree, 4)>(u, v, c1, c2, p, q);
        NewtonEnd end;
        constexpr int most_tests = 3;
        for (int tests = 1;; ++tests) {
            end.at_a = high_terms_of<degree>(floats_, 0, p, q);
            end.at_b = high_terms_of<degree>(floats_, 1, p, q);
            end.at_s = high_terms_of<degree>(floats_, 2, p, q);
            if (test(rays, u, v, first1, first2, tests == most_tests, p, q, end)) return end;
        }
    }

private:
    static HWY_INLINE Floats clamped(Floats at) {
        const Floats limit = float_number(newton_limit);
        return hn::Min(hn::Max(at, hn::Neg(limit)), limit);
    }
    /// A step from `at`, or none where it is not known.
    static HWY_INLINE Floats moved(Floats at, Floats by) {
        return hn::IfThenElse(hn::IsNaN(by), at, clamped(hn::Add(at, by)));
    }

    /// A step with the terms up to a degree.
    template <int degree>
    HWY_INLINE void step(Floats u, Floats v, Floats c1, Floats c2, Floats& p, Floats& q) const {
        const FloatSlopes a = slopes_of<degree>(floats_, 0, p, q);
        const FloatSlopes b = slopes_of<degree>(floats_, 1, p, q);
        const FloatSlopes s = slopes_of<degree>(floats_, 2, p, q);
        const Floats g1 = hn::NegMulAdd(u, s.value, hn::Add(c1, a.value));
        const Floats g2 = hn::NegMulAdd(v, s.value, hn::Add(c2, b.value));
        const Slopes2 by(a, b, s, u, v);
        p = moved(p, by.step_p(g1, g2));
        q = moved(q, by.step_q(g1, g2));
    }

    /// Tests what `end` was evaluated at. Where that leaves a ray open which a better place may
    /// settle, goes there and returns false.
    HWY_INLINE bool test(const NewtonRays& rays, Floats u, Floats v,
                         const std::array<Vector, 2>& first1, const std::array<Vector, 2>& first2,
                         bool is_last, Floats& p, Floats& q, NewtonEnd& end) const {
        const auto ps = doubles_of(p);
        const auto qs = doubles_of(q);
        // The terms up to degree 2, in double.
        std::array<Vector, 2> s{};
        std::array<Vector, 2> low1{};
        std::array<Vector, 2> low2{};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto sum = [&](std::size_t k, Vector from) HWY_ATTR {
                const auto term = [&](int by_p, int by_q) HWY_ATTR {
                    return number(piece_.terms[patch_term(by_p, by_q)][k]);
                };
                const Vector by_p =
                    hn::MulAdd(term(2, 0), ps[i], hn::MulAdd(term(1, 1), qs[i], term(1, 0)));
                const Vector by_q = hn::MulAdd(term(0, 2), qs[i], term(0, 1));
                return hn::MulAdd(by_p, ps[i], hn::MulAdd(by_q, qs[i], from));
            };
            s[i] = sum(2, hn::Zero(D()));
            low1[i] = hn::NegMulAdd(rays.u[i], s[i], sum(0, first1[i]));
            low2[i] = hn::NegMulAdd(rays.v[i], s[i], sum(1, first2[i]));
        }
        const Floats g1 =
            hn::Add(floats_of(low1[0], low1[1]), hn::NegMulAdd(u, end.at_s.value, end.at_a.value));
        const Floats g2 =
            hn::Add(floats_of(low2[0], low2[1]), hn::NegMulAdd(v, end.at_s.value, end.at_b.value));
        const Slopes2 by(end.at_a, end.at_b, end.at_s, u, v);
        const Floats ypp = hn::Mul(by.qq, by.inverse);
        const Floats ypq = hn::Mul(by.pq, by.inverse);
        const Floats yqp = hn::Mul(by.qp, by.inverse);
        const Floats yqq = hn::Mul(by.pp, by.inverse);
        const Floats step_p = hn::NegMulAdd(ypp, g1, hn::Mul(ypq, g2));
        const Floats step_q = hn::NegMulAdd(yqq, g2, hn::Mul(yqp, g1));
        /// The larger element of |Y| (x1, x2).
        const auto norm = [&](Floats x1, Floats x2) HWY_ATTR {
            return hn::Max(hn::MulAdd(hn::Abs(ypp), x1, hn::Mul(hn::Abs(ypq), x2)),
                           hn::MulAdd(hn::Abs(yqp), x1, hn::Mul(hn::Abs(yqq), x2)));
        };
        const Floats size_u = hn::Abs(u);
        const Floats size_v = hn::Abs(v);
        const auto both = [&](Floats size, double across, double along) HWY_ATTR {
            return hn::MulAdd(size, float_number(along), float_number(across));
        };
        const Floats tiny = float_number(0x1p-21);
        const Floats one = float_number(1.0);
        const Floats out = hn::Max(hn::Abs(p), hn::Abs(q));
        Floats lost = norm(hn::MulAdd(hn::Abs(g1), tiny, both(size_u, a_error_, along_error_)),
                           hn::MulAdd(hn::Abs(g2), tiny, both(size_v, b_error_, along_error_)));
        // Outside of the box rounding makes more.
        constexpr double most_power = 2.3;  // newton_limit^patch_degree
        lost = hn::IfThenElse(hn::Gt(out, one), hn::Mul(lost, float_number(most_power)), lost);
        const Floats flat = norm(both(size_u, bounds_.slope_error[0], bounds_.slope_error[2]),
                                 both(size_v, bounds_.slope_error[1], bounds_.slope_error[2]));
        const Floats more = norm(both(size_u, bounds_.bend[0], bounds_.bend[2]),
                                 both(size_v, bounds_.bend[1], bounds_.bend[2]));
        // |Y g''| / 2, where g'' of the terms of degree 2 is known with its sign.
        Floats bend_p = hn::Mul(more, float_number(0.5));
        Floats bend_q = bend_p;
        for (const float* const at : {floats_.by_pp, floats_.by_pq, floats_.by_qq}) {
            const Floats s2 = hn::Set(df, at[2]);
            const Floats h1 = hn::NegMulAdd(u, s2, hn::Set(df, at[0]));
            const Floats h2 = hn::NegMulAdd(v, s2, hn::Set(df, at[1]));
            bend_p = hn::Add(bend_p, hn::Abs(hn::NegMulAdd(ypq, h2, hn::Mul(ypp, h1))));
            bend_q = hn::Add(bend_q, hn::Abs(hn::NegMulAdd(yqp, h1, hn::Mul(yqq, h2))));
        }
        const Floats bend = hn::Max(bend_p, bend_q);
        const Floats step = hn::Max(hn::Abs(step_p), hn::Abs(step_q));
        const Floats moved_by = hn::Max(hn::Abs(hn::Sub(p, rays.p)), hn::Abs(hn::Sub(q, rays.q)));
        const Floats far =
            hn::Min(hn::Add(rays.spread, hn::MulAdd(moved_by, tiny, moved_by)), hn::Add(one, out));
        // 1 - k, rounded downward.
        const Floats rest = hn::Neg(hn::Sub(hn::MulAdd(bend, far, flat), one));
        const Floats reach = hn::Div(hn::Add(step, lost), rest);
        const FloatMask is_known = hn::Gt(rest, float_number(0x1p-4));
        const FloatMask bounded = hn::And(is_known, hn::Le(reach, far));
        const Floats within =
            hn::MulAdd(hn::Add(hn::MulAdd(bend, reach, flat), float_number(0x1p-20)), reach, lost);
        const Floats to_p = hn::Add(p, step_p);
        const Floats to_q = hn::Add(q, step_q);
        const Floats radius = hn::Add(within, tiny);
        const auto beyond = [&](Floats at) HWY_ATTR {
            return hn::Gt(hn::Sub(hn::Abs(at), radius), float_number(inner));
        };
        end.none = hn::And(is_known, hn::Or(beyond(to_p), beyond(to_q)));
        const FloatMask is_one = hn::And(bounded, hn::Le(hn::Add(out, reach), one));
        const Floats slope = hn::Add(hn::Abs(end.at_s.by_p), hn::Abs(end.at_s.by_q));
        const Floats s_radius =
            hn::MulAdd(hn::MulAdd(reach, float_number(0.5 * (bounds_.bend[2] + bounds_.square[2])),
                                  float_number(bounds_.slope_error[2])),
                       reach, hn::MulAdd(slope, within, float_number(s_error_)));
        const FloatMask narrow =
            hn::Le(hn::Add(s_radius, s_radius), float_number(tolerance_ * (1.0 - 0x1p-20)));
        end.found = hn::And(hn::AndNot(end.none, is_one), narrow);
        // A better place may help where the step is what makes the radius.
        const FloatMask may_help =
            hn::And(hn::AndNot(hn::Or(end.none, end.found), is_known), hn::Gt(step, lost));
        if (!is_last && !hn::AllFalse(df, may_help)) {
            p = moved(p, step_p);
            q = moved(q, step_q);
            return false;
        }
        end.found =
            hn::And(end.found, hn::And(in_unit(to_p, radius, piece_.box.u, piece_.box.u_radius),
                                       in_unit(to_q, radius, piece_.box.v, piece_.box.v_radius)));
        const Floats bent =
            hn::MulAdd(end.at_s.by_p, step_p, hn::MulAdd(end.at_s.by_q, step_q, end.at_s.value));
        const auto further = doubles_of(bent);
        for (std::size_t i = 0; i < 2; ++i)
            end.s[i] = hn::Add(hn::Add(s[i], number(piece_.terms[0][2])), further[i]);
        return true;
    }

    /// Whether places are surely in [0, 1].
    static HWY_INLINE FloatMask in_unit(Floats place, Floats radius, double middle,
                                        double box_radius) {
        const double lo = -middle / box_radius;
        const double hi = (1.0 - middle) / box_radius;
        // More than rounding may take from these.
        const auto most = [](double at) { return 0x1p-22 * std::abs(at); };
        return hn::And(hn::Ge(hn::Sub(place, radius), float_number(lo + most(lo))),
                       hn::Le(hn::Add(place, radius), float_number(hi - most(hi))));
    }

    const Piece& piece_;
    const FloatTerms& floats_;
    double distance_, tolerance_;
    NewtonBounds bounds_;
    double a_error_, b_error_, along_error_, s_error_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
