// How near to 0 f comes in stretches of rays, for vectors of rays.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_LEAST_SEARCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_LEAST_SEARCH_INL
#undef ZEROSET_LEAST_SEARCH_INL
#else
#define ZEROSET_LEAST_SEARCH_INL
#endif

#include "engine/antialias/ray_stretches.hpp"
#include "engine/antialias/ray_values-inl.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Places on rays: f there, with the sign that it has at the stretch's near end, and df/ds.
struct Places {
    V<double> s, f, slope;
};

/// The depth at `part` of the way from a to b; halfway where that is not between them.
HWY_INLINE V<double> between(const Places& a, V<double> length, V<double> part) {
    const M<double> inner = hn::And(hn::Gt(part, hn::Zero(d<double>)), hn::Lt(part, number(1.0)));
    const V<double> within = hn::IfThenElse(inner, part, number(0.5));
    const V<double> clamped = hn::Min(hn::Max(within, number(0.02)), number(0.98));
    return hn::MulAdd(clamped, length, a.s);
}

/// Where the cubic through two places with these slopes is least.
HWY_INLINE V<double> least_of_cubic(const Places& a, const Places& b) {
    const V<double> length = hn::Sub(b.s, a.s);
    const V<double> chord = hn::Div(hn::Sub(b.f, a.f), length);
    const V<double> p = hn::NegMulAdd(number(3.0), chord, hn::Add(a.slope, b.slope));
    const V<double> square = hn::NegMulAdd(a.slope, b.slope, hn::Mul(p, p));
    const V<double> root = hn::Sqrt(hn::Max(square, hn::Zero(d<double>)));
    const V<double> change = hn::MulAdd(number(2.0), root, hn::Sub(b.slope, a.slope));
    const V<double> rest = hn::Div(hn::Sub(hn::Add(b.slope, root), p), change);
    return between(a, length, hn::Sub(number(1.0), rest));
}

/// Where the tangents at two places meet: where f is least if it has a kink between them, and is
/// straight on both sides.
HWY_INLINE V<double> meeting_of_tangents(const Places& a, const Places& b) {
    const V<double> length = hn::Sub(b.s, a.s);
    const V<double> rise = hn::NegMulAdd(b.slope, length, hn::Sub(b.f, a.f));
    return between(a, length, hn::Div(rise, hn::Mul(hn::Sub(a.slope, b.slope), length)));
}

/// Whether f is nowhere between two places more than `error` below its value `least`, if it bends
/// one way between them: it falls at the first and rises at the second.
HWY_INLINE M<double> is_least(const Places& a, const Places& b, V<double> least, V<double> error) {
    const V<double> zero = hn::Zero(d<double>);
    const V<double> length = hn::Sub(b.s, a.s);
    const V<double> turn = hn::Sub(b.slope, a.slope);
    // Test that four times the fall of a parabola from the flatter place is little: it falls by
    // slope^2 / (2 turn / length).
    const V<double> flatter = hn::Min(hn::Neg(a.slope), b.slope);
    const V<double> fall = hn::Mul(hn::Mul(number(2.0), length), hn::Mul(flatter, flatter));
    const M<double> flat = hn::Le(fall, hn::Mul(error, turn));
    // Test that the tangents meet between the places: a.f - a.slope rise / turn >= lower
    const V<double> rise = hn::NegMulAdd(b.slope, length, hn::Sub(b.f, a.f));
    const M<double> inner =
        hn::And(hn::Le(rise, zero), hn::Ge(hn::MulAdd(turn, length, rise), zero));
    const V<double> lower = hn::Sub(least, error);
    const M<double> above = hn::Ge(hn::Mul(hn::Sub(a.f, lower), turn), hn::Mul(a.slope, rise));
    return hn::Or(flat, hn::And(inner, above));
}

/// The bend of f along rays, by cubics: d^2 f/ds^2, and how far it may be off, in parts of it, up
/// to `length` away.
struct Bends {
    V<double> curvature, doubt, length;
};

/// How far the least f may be off, in parts of it.
inline constexpr double most_error_of_least = 1.0 / 8192;

/// The search in some stretches. Plain data, nothing of it set at first.
class LeastSearch {
public:
    static constexpr std::size_t capacity = 128;

    void search(const TraceFrame& frame, const TileRays& rays, std::span<RayStretch> stretches,
                Counters& counters);
    /// Searches the first stretches that were loaded; up to a multiple of batch_multiple there must
    /// be some.
    void search_loaded(const TraceFrame& frame, const TileRays& rays, std::size_t count,
                       Counters& counters);
    HWY_INLINE void load_ray(std::size_t i, V<double> u, V<double> v, V<double> from,
                             V<double> to) {
        store(u, u_ + i);
        store(v, v_ + i);
        store(from, lo_s_ + i);
        store(to, hi_s_ + i);
    }
    /// Loads a stretch again in other places.
    void repeat_ray(std::size_t i, std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) {
            u_[k] = u_[i];
            v_[k] = v_[i];
            lo_s_[k] = lo_s_[i];
            hi_s_[k] = hi_s_[i];
        }
    }
    /// Results of the search, of the stretches from i on.
    [[nodiscard]] HWY_INLINE V<double> near_at(std::size_t i) const { return load(near_ + i); }
    [[nodiscard]] HWY_INLINE V<double> least_at(std::size_t i) const { return load(f_ + i); }
    [[nodiscard]] HWY_INLINE V<double> place_at(std::size_t i) const { return load(s_ + i); }
    [[nodiscard]] HWY_INLINE M<double> inner_at(std::size_t i) const {
        return flags_at(inner_ + i);
    }
    /// 1 where f is at least 0 at the near ends, else -1.
    [[nodiscard]] HWY_INLINE V<double> sign_at(std::size_t i) const { return load(sign_ + i); }
    /// How much f changes at the same depth from the near ends a pixel to the side, at most.
    [[nodiscard]] HWY_INLINE V<double> near_change_at(std::size_t i) const {
        return load(near_change_ + i);
    }
    /// Whether f falls at both ends, to its least at the far one, but so steeply that the cubic
    /// through the ends may rise between them [Fritsch and Carlson 1980].
    [[nodiscard]] HWY_INLINE M<double> wavers_at(std::size_t i) const;
    /// How f bends where it is least within.
    [[nodiscard]] HWY_INLINE Bends bends_at(std::size_t i) const;
    /// Writes what was found of a stretch.
    void write(std::size_t i, RayStretch& stretch) const;

private:
    void load_rays(const TileRays& rays, std::span<const RayStretch> stretches, std::size_t size);
    /// Takes f at the ends; whether df/ds changes its sign in any of a vector's stretches.
    HWY_INLINE bool begin(std::size_t i, const LinesOfRays& lines, const TileLines& tile,
                          std::size_t far_end);
    /// Chooses the next places.
    [[nodiscard]] HWY_INLINE V<double> choose(std::size_t i, int step) const;
    /// Takes f there; whether any of a vector's searches goes on.
    HWY_INLINE bool take(std::size_t i, const LinesOfRays& lines, std::size_t point);
    [[nodiscard]] HWY_INLINE Places lo_at(std::size_t i) const {
        return {.s = load(lo_s_ + i), .f = load(lo_f_ + i), .slope = load(lo_slope_ + i)};
    }
    [[nodiscard]] HWY_INLINE Places hi_at(std::size_t i) const {
        return {.s = load(hi_s_ + i), .f = load(hi_f_ + i), .slope = load(hi_slope_ + i)};
    }
    HWY_INLINE void keep_best(std::size_t i, M<double> lanes, V<double> s, V<double> f,
                              const Vectors3& gradient);

    using Column = double[capacity];

    alignas(64) Column u_, v_;
    /// The stretches; df/ds is below 0 at the one end, and above at the other one.
    alignas(64) Column lo_s_, lo_f_, lo_slope_, hi_s_, hi_f_, hi_slope_;
    alignas(64) Column near_, far_, near_change_, sign_, tolerance_, open_;
    alignas(64) Column kinked_;  ///< f seems to have a kink where it is least
    /// Where f is least so far.
    alignas(64) Column s_, f_, gradient_[3], inner_, by_col_, by_row_;
    alignas(64) Column next_;
    RayPoints points_;
};

inline void LeastSearch::load_rays(const TileRays& rays, std::span<const RayStretch> stretches,
                                   std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
        const RayStretch& stretch = stretches[std::min(i, stretches.size() - 1)];
        u_[i] = rays.u(stretch.col);
        v_[i] = rays.v(stretch.row);
        lo_s_[i] = stretch.from;
        hi_s_[i] = stretch.to;
    }
}

inline void LeastSearch::write(std::size_t i, RayStretch& stretch) const {
    stretch.near = near_[i];
    stretch.far = far_[i];
    stretch.least = f_[i];
    stretch.at = s_[i];
    stretch.inner = inner_[i] != 0.0;
    stretch.by_col = by_col_[i];
    stretch.by_row = by_row_[i];
}

HWY_INLINE void LeastSearch::keep_best(std::size_t i, M<double> lanes, V<double> s, V<double> f,
                                       const Vectors3& gradient) {
    const V<double> sign = load(sign_ + i);
    store_in(lanes, s, s_ + i);
    store_in(lanes, f, f_ + i);
    store_in(lanes, hn::Mul(sign, gradient.x), gradient_[0] + i);
    store_in(lanes, hn::Mul(sign, gradient.y), gradient_[1] + i);
    store_in(lanes, hn::Mul(sign, gradient.z), gradient_[2] + i);
}

HWY_INLINE M<double> LeastSearch::wavers_at(std::size_t i) const {
    const V<double> zero = hn::Zero(d<double>);
    const Places lo = lo_at(i);
    const Places hi = hi_at(i);
    const M<double> falls = hn::And(hn::Lt(lo.slope, zero), hn::Lt(hi.slope, zero));
    const V<double> fall = hn::Mul(number(3.0), hn::Sub(hi.f, lo.f));
    const V<double> by_slopes = hn::Mul(hn::Add(lo.slope, hi.slope), hn::Sub(hi.s, lo.s));
    return hn::AndNot(inner_at(i), hn::And(falls, hn::Lt(by_slopes, fall)));
}

HWY_INLINE Bends LeastSearch::bends_at(std::size_t i) const {
    const Places lo = lo_at(i);
    const Places hi = hi_at(i);
    const V<double> length = hn::Sub(hi.s, lo.s);
    const V<double> per_length = hn::Div(number(1.0), length);
    const V<double> chord = hn::Mul(number(3.0), hn::Mul(hn::Sub(hi.f, lo.f), per_length));
    const V<double> two = number(2.0);
    const V<double> scale = hn::Mul(two, per_length);
    const V<double> at_lo = hn::Mul(scale, hn::Sub(chord, hn::MulAdd(two, lo.slope, hi.slope)));
    const V<double> at_hi = hn::Mul(scale, hn::Sub(hn::MulAdd(two, hi.slope, lo.slope), chord));
    const V<double> curvature = hn::IfThenElse(hn::Eq(load(s_ + i), lo.s), at_lo, at_hi);
    return {.curvature = curvature,
            .doubt = hn::Abs(hn::Div(hn::Sub(at_hi, at_lo), curvature)),
            .length = length};
}

HWY_INLINE bool LeastSearch::begin(std::size_t i, const LinesOfRays& lines, const TileLines& tile,
                                   std::size_t far_end) {
    const V<double> zero = hn::Zero(d<double>);
    const V<double> near = points_.f_at(i);
    const V<double> far = points_.f_at(far_end + i);
    const Vectors3 near_gradient = points_.gradient_at(i);
    const Vectors3 far_gradient = points_.gradient_at(far_end + i);
    const V<double> sign = hn::IfThenElse(hn::Ge(near, zero), number(1.0), number(-1.0));
    const V<double> lo = hn::Mul(sign, near);
    const V<double> hi = hn::Mul(sign, far);
    const V<double> lo_slope = hn::Mul(sign, dot(near_gradient, lines.direction));
    const V<double> hi_slope = hn::Mul(sign, dot(far_gradient, lines.direction));
    store(near, near_ + i);
    store(far, far_ + i);
    const V<double> from = load(lo_s_ + i);
    store(hn::Add(hn::Abs(tile.by_col(near_gradient, from)),
                  hn::Abs(tile.by_row(near_gradient, from))),
          near_change_ + i);
    store(sign, sign_ + i);
    store(lo, lo_f_ + i);
    store(hi, hi_f_ + i);
    store(lo_slope, lo_slope_ + i);
    store(hi_slope, hi_slope_ + i);
    store(zero, inner_ + i);
    store(zero, kinked_ + i);
    store(hn::Mul(number(1e-7), hn::Max(hn::Abs(lo), hn::Abs(hi))), tolerance_ + i);
    // Begin with the end where f is less as the least place.
    const M<double> farther = hn::Lt(hi, lo);
    keep_best(i, hn::Not(farther), load(lo_s_ + i), lo, near_gradient);
    keep_best(i, farther, load(hi_s_ + i), hi, far_gradient);
    // Search on where f falls at the near end and rises at the far end.
    const M<double> open = hn::And(hn::Lt(lo_slope, zero), hn::Gt(hi_slope, zero));
    store(flags(open), open_ + i);
    return !hn::AllFalse(d<double>, open);
}

HWY_INLINE V<double> LeastSearch::choose(std::size_t i, int step) const {
    const Places lo = lo_at(i);
    const Places hi = hi_at(i);
    if (step % 4 == 3) return meeting_of_tangents(lo, hi);
    const V<double> smooth = least_of_cubic(lo, hi);
    const M<double> kinked = flags_at(kinked_ + i);
    if (hn::AllFalse(d<double>, kinked)) return smooth;
    return hn::IfThenElse(kinked, meeting_of_tangents(lo, hi), smooth);
}

HWY_INLINE bool LeastSearch::take(std::size_t i, const LinesOfRays& lines, std::size_t point) {
    const M<double> open = flags_at(open_ + i);
    const V<double> sign = load(sign_ + i);
    const Vectors3 gradient = points_.gradient_at(point);
    const Places place{.s = load(next_ + i),
                       .f = hn::Mul(sign, points_.f_at(point)),
                       .slope = hn::Mul(sign, dot(gradient, lines.direction))};
    const M<double> better = hn::AndNot(hn::Gt(place.f, load(f_ + i)), open);
    keep_best(i, better, place.s, place.f, gradient);
    store_in(better, number(1.0), inner_ + i);
    const M<double> falls = hn::Lt(place.slope, hn::Zero(d<double>));
    // At a smooth least f is flat, at a kink it is not.
    const V<double> before = hn::IfThenElse(falls, load(lo_slope_ + i), load(hi_slope_ + i));
    const V<double> steep = hn::Mul(number(0.5), hn::Abs(before));
    store(flags(hn::Gt(hn::Abs(place.slope), steep)), kinked_ + i);
    const M<double> is_lo = hn::And(falls, open);
    const M<double> is_hi = hn::AndNot(falls, open);
    store_in(is_lo, place.s, lo_s_ + i);
    store_in(is_lo, place.f, lo_f_ + i);
    store_in(is_lo, place.slope, lo_slope_ + i);
    store_in(is_hi, place.s, hi_s_ + i);
    store_in(is_hi, place.f, hi_f_ + i);
    store_in(is_hi, place.slope, hi_slope_ + i);
    // Ask for more where f is near 0: it tells whether there is a root, and how wide a thread is.
    const V<double> least = load(f_ + i);
    const V<double> of_least = hn::Mul(number(most_error_of_least), hn::Abs(least));
    const V<double> error = hn::Max(load(tolerance_ + i), of_least);
    const M<double> still = hn::AndNot(is_least(lo_at(i), hi_at(i), least, error), open);
    store(flags(still), open_ + i);
    return !hn::AllFalse(d<double>, still);
}

inline void LeastSearch::search(const TraceFrame& frame, const TileRays& rays,
                                std::span<RayStretch> stretches, Counters& counters) {
    load_rays(rays, stretches, padded(stretches.size()));
    search_loaded(frame, rays, stretches.size(), counters);
    for (std::size_t i = 0; i < stretches.size(); ++i)
        write(i, stretches[i]);
}

inline void LeastSearch::search_loaded(const TraceFrame& frame, const TileRays& rays,
                                       std::size_t count, Counters& counters) {
    constexpr int most_steps = 16;
    const TileLines lines(rays);
    const std::size_t size = padded(count);
    const auto lines_at = [&](std::size_t i) { return lines.at(load(u_ + i), load(v_ + i)); };
    OpenParts<capacity> open(size);
    // Evaluate f at both ends of all stretches.
    open.for_each([&](std::size_t i, std::size_t) {
        points_.ask(i, lines_at(i), load(lo_s_ + i));
        points_.ask(size + i, lines_at(i), load(hi_s_ + i));
    });
    points_.evaluate(frame, 2 * size);
    counters.value += 2 * count;
    open.keep([&](std::size_t i, std::size_t) { return begin(i, lines_at(i), lines, size); });
    // Narrow the brackets until the least f is known well enough.
    for (int step = 0; step < most_steps && open.size() > 0 && !frame.stopped(); ++step) {
        open.for_each([&](std::size_t i, std::size_t point) {
            const V<double> next = choose(i, step);
            store(next, next_ + i);
            points_.ask(point, lines_at(i), next);
        });
        points_.evaluate(frame, open.size());
        counters.value += open.size();
        open.keep([&](std::size_t i, std::size_t point) { return take(i, lines_at(i), point); });
    }
    for (std::size_t i = 0; i < size; i += lanes<double>) {
        const Vectors3 gradient{
            .x = load(gradient_[0] + i), .y = load(gradient_[1] + i), .z = load(gradient_[2] + i)};
        store(lines.by_col(gradient, load(s_ + i)), by_col_ + i);
        store(lines.by_row(gradient, load(s_ + i)), by_row_ + i);
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
