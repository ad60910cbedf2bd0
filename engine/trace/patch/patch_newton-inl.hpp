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

#include "engine/real/unbounded.hpp"
#include "engine/trace/patch/patch_bounds-inl.hpp"
#include "engine/trace/patch/patch_floats-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Terms of degree 2 that are larger, relative to the tolerance, are added in double.
constexpr double most_in_float = 0x1p16;
/// More than what rounding takes from a place as floats, or from Y g relative to its terms.
constexpr double rounding_of_places = 0x1p-21;

/// The rays that are solved at once, twice as many as vectors of doubles have numbers.
struct RaysOnPiece {
    std::array<V<double>, 2> u, v;
    V<float> p, q;    ///< where the search begins
    V<float> spread;  ///< from where all zeros of the piece are within this
};

/// The result of Newton's method on RaysOnPiece.
struct NewtonEnd {
    M<float> none;   ///< no zero within `inner`
    M<float> found;  ///< one, in the unit square, and its depth is known well enough
    std::array<V<double>, 2> s;
    FloatPoint at;  ///< where the search ended: terms of high degree, all slopes
};

/// Newton's method for rays on a piece.
class Newton {
public:
    /// `rays`: those around all that are solved.
    HWY_INLINE Newton(const Piece& piece, const FloatTerms& floats, const SightAxes& axes,
                      double tolerance, const SightRays& rays)
        : piece_(piece), floats_(floats), distance_(axes.distance) {
        with_squares_ = needs_squares(piece, tolerance);
        const NewtonBounds bounds(piece, with_squares_);
        const PatchSight& sight = piece.sight;
        const glm::dvec3 most = glm::abs(sight.c) + sight.spread();
        const SightLine<double> around{.u = std::abs(rays.middle.u) + rays.u_radius,
                                       .v = std::abs(rays.middle.v) + rays.v_radius};
        // Products of slopes as large as this overflow in float: no error is a bound of theirs.
        const bool fits = larger(around.most(in_axes<double>(most))) < 0x1p50;
        const double error = fits ? sight.value_error + piece.first_error : unbounded;
        // Bound each coordinate's error, its slopes' error and its second derivatives.
        const auto vector = [](const double* of) { return glm::dvec3(of[0], of[1], of[2]); };
        const glm::dvec3 lost =
            vector(bounds.error) + error + rounding * (most + glm::dvec3(0.0, 0.0, distance_));
        const glm::dvec3 bend = 0.5 * vector(bounds.bend);
        const glm::dvec3 square = bend + 0.5 * vector(bounds.square);
        const auto most_of = [&](const glm::dvec3& of) {
            return float_above(larger(around.most(in_axes<double>(of))));
        };
        const auto bounds_of = [&](const glm::dvec3& of, const glm::dvec3& all) {
            return Bounds{.by = {float_above(of.x), float_above(of.y), float_above(of.z)},
                          .all = most_of(all)};
        };
        lost_ = bounds_of(lost, lost);
        flat_ = bounds_of(vector(bounds.slope_error), vector(bounds.slope_error));
        bend_ = bounds_of(bend, square);
        s_lost_ = float_above(error + bounds.error[2] + rounding * most.z);
        s_bend_ = float_above(square.z);
        tolerance_ = static_cast<float>(tolerance * (1.0 - 0x1p-20));
        const auto is_within = [](double middle, double radius) {
            return middle - radius > 0x1p-40 && middle + radius < 1.0 - 0x1p-40;
        };
        const UvBox& box = piece.box;
        is_within_ = is_within(box.u, box.u_radius) && is_within(box.v, box.v_radius);
    }

    /// Whether the terms of degree 2 have to be added in double: those of large pieces.
    [[nodiscard]] bool with_squares() const { return with_squares_; }

    template <int degree, bool with_squares>
    HWY_INLINE NewtonEnd solve(const RaysOnPiece& rays) const {
        // Add the terms that are constant on a ray in double: they are large.
        const auto& constant = piece_.terms[0];
        const V<double> far = number(distance_ + constant[2]);
        const auto beside = [&](V<double> along, double at)
                                HWY_ATTR { return hn::NegMulAdd(along, far, number(at)); };
        const Search search{
            .rays = rays,
            .line = {.u = floats_of(rays.u[0], rays.u[1]), .v = floats_of(rays.v[0], rays.v[1])},
            .first1 = {beside(rays.u[0], constant[0]), beside(rays.u[1], constant[0])},
            .first2 = {beside(rays.v[0], constant[1]), beside(rays.v[1], constant[1])}};
        // Take a first step with the terms of low degree alone.
        Vector2<V<float>> at{.p = clamped(rays.p, newton_limit),
                             .q = clamped(rays.q, newton_limit)};
        at = moved(at, first_step<std::min(degree, 3)>(search, at), newton_limit);
        NewtonEnd end;
        constexpr int most_tests = 3;
        for (int tests = 1;; ++tests) {
            constexpr int first = with_squares ? 3 : 2;
            end.at = point_of([&](int k) HWY_ATTR {
                return high_terms_of<degree, first>(floats_, k, at.p, at.q);
            });
            const Low low = low_terms<with_squares>(search, at);
            const Slopes2 slopes(slopes_of_g(search.line, end.at));
            Step by = step_from(search, at, low, slopes, end);
            // Test by bounds for all rays; where that is not enough, by each ray's own.
            Proof proof = test(by, at, end);
            if (!hn::AllTrue(d<float>, hn::Or(end.none, end.found))) {
                bound_closely(search.line, slopes, by);
                proof = test(by, at, end);
            }
            // Go on from the better place while that may settle a ray.
            if (tests < most_tests && !hn::AllFalse(d<float>, proof.may_help)) {
                at = moved(at, by.to, newton_limit);
                continue;
            }
            finish(by, at, low, proof, end);
            return end;
        }
    }

private:
    /// Bounds of a quantity in each of (a, b, s), and of the larger one in g.
    struct Bounds {
        float by[3];
        float all;
    };
    /// Rays and what is constant on them: g but for the other terms.
    struct Search {
        const RaysOnPiece& rays;
        SightLine<V<float>> line;
        std::array<V<double>, 2> first1, first2;
    };
    /// The terms of degree 1, or up to 2: of s, without the constant, and of g.
    struct Low {
        std::array<V<double>, 2> s, g1, g2;
    };
    /// A step of Newton's method, and bounds of what it leaves.
    struct Step {
        Vector2<V<float>> to;  ///< from where it begins
        Vector2<V<float>> g;
        V<float> out;    ///< the larger size of where it begins
        V<float> lost;   ///< a bound of its error by errors of g
        V<float> flat;   ///< k0
        V<float> bend;   ///< K / 2
        V<float> far;    ///< R
        M<float> usual;  ///< the inverse of the slopes is no huge number
    };
    struct Proof {
        M<float> may_help;  ///< a better place may settle a ray that is open
        V<float> radius;    ///< of all zeros about where the step leads
    };

    static bool needs_squares(const Piece& piece, double tolerance) {
        const auto& sizes = piece.sizes[2];
        return std::max({sizes[0], sizes[1], sizes[2]}) > most_in_float * tolerance;
    }

    /// A float that is not below a number, in upward rounding.
    static float float_above(double number) { return static_cast<float>(number * (1.0 + 0x1p-22)); }
    static HWY_INLINE V<float> set(float number) { return hn::Set(d<float>, number); }

    /// A step with the terms up to a degree.
    template <int degree>
    HWY_INLINE Vector2<V<float>> first_step(const Search& search,
                                            const Vector2<V<float>>& at) const {
        const FloatPoint point =
            point_of([&](int k) HWY_ATTR { return slopes_of<degree>(floats_, k, at.p, at.q); });
        const V<float> c1 = floats_of(search.first1[0], search.first1[1]);
        const V<float> c2 = floats_of(search.first2[0], search.first2[1]);
        const auto& [a, b, s] = point.value;
        const Vector2<V<float>> g =
            search.line.across({.x = hn::Add(c1, a), .y = hn::Add(c2, b), .z = s});
        return Slopes2(slopes_of_g(search.line, point)).step(g);
    }

    template <bool with_squares>
    HWY_INLINE Low low_terms(const Search& search, const Vector2<V<float>>& at) const {
        const auto ps = doubles_of(at.p);
        const auto qs = doubles_of(at.q);
        Low low{};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto sum = [&](std::size_t k, V<double> from) HWY_ATTR {
                const auto term = [&](int by_p, int by_q) HWY_ATTR {
                    return number(piece_.terms[patch_term(by_p, by_q)][k]);
                };
                const V<double> p = ps[i];
                const V<double> q = qs[i];
                if constexpr (!with_squares)
                    return hn::MulAdd(term(1, 0), p, hn::MulAdd(term(0, 1), q, from));
                const V<double> by_p = hn::MulAdd(term(1, 1), q, term(1, 0));
                const V<double> by_q = hn::MulAdd(term(0, 2), q, term(0, 1));
                return hn::MulAdd(hn::MulAdd(term(2, 0), p, by_p), p, hn::MulAdd(by_q, q, from));
            };
            low.s[i] = sum(2, hn::Zero(d<double>));
            low.g1[i] = hn::NegMulAdd(search.rays.u[i], low.s[i], sum(0, search.first1[i]));
            low.g2[i] = hn::NegMulAdd(search.rays.v[i], low.s[i], sum(1, search.first2[i]));
        }
        return low;
    }

    /// Newton's step from a place, with bounds by one norm of Y and bounds for all rays.
    HWY_INLINE Step step_from(const Search& search, const Vector2<V<float>>& at, const Low& low,
                              const Slopes2& slopes, const NewtonEnd& end) const {
        const Matrix2<V<float>> y = slopes.inverse_matrix();
        const V<float> one = number<float>(1.0);
        const V<float> tiny = number<float>(rounding_of_places);
        const Vector2<V<float>> high = search.line.across(end.at.value);
        Step by{};
        by.g = {.p = hn::Add(floats_of(low.g1[0], low.g1[1]), high.p),
                .q = hn::Add(floats_of(low.g2[0], low.g2[1]), high.q)};
        by.out = size_of(at);
        // Beyond, rounding upward makes a finite number of an infinite one below 0.
        by.usual = hn::Lt(hn::Abs(slopes.inverse), number<float>(0x1p120));
        const Vector2<V<float>> back = y * by.g;
        by.to = {.p = hn::Neg(back.p), .q = hn::Neg(back.q)};
        const V<float> norm = norm_of(y);
        by.lost =
            outside_more(by.out, hn::Mul(norm, hn::MulAdd(size_of(by.g), tiny, set(lost_.all))));
        by.flat = hn::Mul(norm, set(flat_.all));
        by.bend = hn::Mul(norm, set(bend_.all));
        const V<float> moved_by =
            hn::Max(hn::Abs(hn::Sub(at.p, search.rays.p)), hn::Abs(hn::Sub(at.q, search.rays.q)));
        by.far = hn::Min(hn::Add(search.rays.spread, hn::MulAdd(moved_by, tiny, moved_by)),
                         hn::Add(one, by.out));
        return by;
    }
    /// A rounding error, enlarged where the place is outside of the box.
    static HWY_INLINE V<float> outside_more(V<float> out, V<float> lost) {
        constexpr double most_power = 2.3;  // newton_limit^patch_degree
        return hn::IfThenElse(hn::Gt(out, number<float>(1.0)),
                              hn::Mul(lost, number<float>(most_power)), lost);
    }

    /// Sets the bounds of a step by Y itself and what is known of each ray.
    HWY_INLINE void bound_closely(const SightLine<V<float>>& line, const Slopes2& slopes,
                                  Step& by) const {
        const Matrix2<V<float>> y = slopes.inverse_matrix();
        const Matrix2<V<float>> sizes = sizes_of(y);
        const auto most = [&](const Bounds& of) HWY_ATTR {
            return line.most({.x = set(of.by[0]), .y = set(of.by[1]), .z = set(of.by[2])});
        };
        const V<float> tiny = number<float>(rounding_of_places);
        const Vector2<V<float>> g = sizes_of(by.g);
        const Vector2<V<float>> lost = most(lost_);
        const Vector2<V<float>> errors{.p = hn::MulAdd(g.p, tiny, lost.p),
                                       .q = hn::MulAdd(g.q, tiny, lost.q)};
        by.lost = outside_more(by.out, larger(sizes * errors));
        by.flat = larger(sizes * most(flat_));
        // g'' of the terms of degree 2 is known with its sign.
        Vector2<V<float>> bend = sizes * most(bend_);
        for (const std::size_t i : {patch_term(2, 0), patch_term(1, 1), patch_term(0, 2)}) {
            const float* const term = floats_.terms[i];
            const Vector2<V<float>> more = sizes_of(
                y * line.across({.x = set(term[0]), .y = set(term[1]), .z = set(term[2])}));
            bend = {.p = hn::Add(bend.p, more.p), .q = hn::Add(bend.q, more.q)};
        }
        by.bend = larger(bend);
    }

    /// Tests what a step proves of the zeros, and sets end.none and end.found.
    HWY_INLINE Proof test(const Step& by, const Vector2<V<float>>& at, NewtonEnd& end) const {
        const V<float> one = number<float>(1.0);
        const V<float> size = size_of(by.to);
        // 1 - k, rounded downward.
        const V<float> rest = hn::Neg(hn::Sub(hn::MulAdd(by.bend, by.far, by.flat), one));
        const V<float> reach = hn::Div(hn::Add(size, by.lost), rest);
        const M<float> is_known = hn::And(by.usual, hn::Gt(rest, number<float>(0x1p-4)));
        const V<float> within = hn::MulAdd(
            hn::Add(hn::MulAdd(by.bend, reach, by.flat), number<float>(0x1p-20)), reach, by.lost);
        Proof proof{};
        proof.radius = hn::Add(within, number<float>(rounding_of_places));
        const V<float> limit = hn::Add(proof.radius, number<float>(inner));
        const V<float> to =
            size_of(Vector2<V<float>>{.p = hn::Add(at.p, by.to.p), .q = hn::Add(at.q, by.to.q)});
        // Mark rays that have no zero in the box's own share.
        end.none = hn::And(is_known, hn::Gt(to, limit));
        // Mark rays that have one zero, whose depth is known well enough.
        const M<float> is_one =
            hn::And(hn::And(is_known, hn::Le(reach, by.far)), hn::Le(hn::Add(by.out, reach), one));
        const V<float> slope = hn::Add(hn::Abs(end.at.by_p.z), hn::Abs(end.at.by_q.z));
        const V<float> s_radius = hn::MulAdd(hn::MulAdd(reach, set(s_bend_), set(flat_.by[2])),
                                             reach, hn::MulAdd(slope, within, set(s_lost_)));
        const M<float> narrow = hn::Le(hn::Add(s_radius, s_radius), set(tolerance_));
        end.found = hn::And(hn::AndNot(end.none, is_one), narrow);
        // A better place may help where the step is what makes the radius.
        proof.may_help =
            hn::And(hn::AndNot(hn::Or(end.none, end.found), is_known), hn::Gt(size, by.lost));
        return proof;
    }

    HWY_INLINE void finish(const Step& by, const Vector2<V<float>>& at, const Low& low,
                           const Proof& proof, NewtonEnd& end) const {
        if (!is_within_) {
            const UvBox& box = piece_.box;
            const M<float> in_p =
                in_unit(hn::Add(at.p, by.to.p), proof.radius, box.u, box.u_radius);
            const M<float> in_q =
                in_unit(hn::Add(at.q, by.to.q), proof.radius, box.v, box.v_radius);
            end.found = hn::And(end.found, hn::And(in_p, in_q));
        }
        const auto further = doubles_of(
            hn::MulAdd(end.at.by_p.z, by.to.p, hn::MulAdd(end.at.by_q.z, by.to.q, end.at.value.z)));
        for (std::size_t i = 0; i < 2; ++i)
            end.s[i] = hn::Add(hn::Add(low.s[i], number(piece_.terms[0][2])), further[i]);
    }

    /// Whether places are surely in [0, 1].
    static HWY_INLINE M<float> in_unit(V<float> place, V<float> radius, double middle,
                                       double box_radius) {
        const double lo = -middle / box_radius;
        const double hi = (1.0 - middle) / box_radius;
        // More than rounding may take from these, and from the middles of halves.
        const auto most = [&](double at) { return 0x1p-22 * std::abs(at) + 0x1p-48 / box_radius; };
        return hn::And(hn::Ge(hn::Sub(place, radius), number<float>(lo + most(lo))),
                       hn::Le(hn::Add(place, radius), number<float>(hi - most(hi))));
    }

    const Piece& piece_;
    const FloatTerms& floats_;
    double distance_;
    Bounds lost_, flat_,
        bend_;               ///< of errors, k0 and K / 2; bend_.by without the terms of degree 2
    float s_lost_, s_bend_;  ///< of s alone
    float tolerance_;
    bool with_squares_;
    bool is_within_;  ///< the piece does not touch the ends of the ranges
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
