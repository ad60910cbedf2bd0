// Roots in stretches of rays, for vectors of rays.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_ROOT_SEARCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_ROOT_SEARCH_INL
#undef ZEROSET_ROOT_SEARCH_INL
#else
#define ZEROSET_ROOT_SEARCH_INL
#endif

#include "engine/antialias/ray_stretches.hpp"
#include "engine/antialias/ray_values-inl.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The search for the roots of some stretches. Plain data, nothing of it set at first.
class RootSearch {
public:
    static constexpr std::size_t capacity = 64;
    /// The number of samples that show the roots of a stretch that may hold several.
    static constexpr std::size_t several_samples = 8;

    /// Finds the roots of these indices; `samples`: of each stretch.
    void search(const TraceFrame& frame, const TileRays& rays, std::span<RayRoot> roots,
                std::span<const std::uint32_t> some, std::size_t samples, Counters& counters);

private:
    /// Sets the first bracket that samples show; whether any of a vector's stretches has one.
    HWY_INLINE bool bracket(std::size_t i, std::size_t size, std::size_t samples);
    [[nodiscard]] HWY_INLINE V<double> sample_at(std::size_t i, std::size_t sample,
                                                 std::size_t samples) const;
    /// Takes f at the next places, and goes on by Newton's method; where that leaves the bracket,
    /// or one end has stood still, to its middle. Whether any of a vector's searches goes on.
    HWY_INLINE bool take(std::size_t i, const TileLines& tile, const LinesOfRays& lines,
                         std::size_t point);
    /// Takes the gradients right before the roots.
    HWY_INLINE void end(std::size_t i, const TileLines& tile, const LinesOfRays& lines);
    void write(std::span<RayRoot> roots, std::span<const std::uint32_t> some) const;

    using Column = double[capacity];

    alignas(64) Column u_, v_, from_, to_;
    alignas(64) Column lo_, hi_, f_lo_, f_hi_, next_;
    alignas(64) Column stood_;       ///< steps in a row that kept the same end
    alignas(64) Column was_before_;  ///< the last one kept the far end
    alignas(64) Column open_, found_, falls_;
    alignas(64) Column s_, gradient_[3], by_col_, by_row_, cosine_;
    RayPoints points_;
    static_assert(capacity * several_samples <= RayPoints::capacity);
};

HWY_INLINE V<double> RootSearch::sample_at(std::size_t i, std::size_t sample,
                                           std::size_t samples) const {
    const V<double> from = load(from_ + i);
    const V<double> step =
        hn::Mul(hn::Sub(load(to_ + i), from), number(1.0 / static_cast<double>(samples - 1)));
    return hn::MulAdd(number(static_cast<double>(sample)), step, from);
}

HWY_INLINE bool RootSearch::bracket(std::size_t i, std::size_t size, std::size_t samples) {
    const V<double> zero = hn::Zero(d<double>);
    const V<double> first = points_.f_at(i);
    M<double> found = hn::Lt(first, hn::Neg(hn::Inf(d<double>)));
    V<double> before = first;
    V<double> lo = load(from_ + i);
    V<double> hi = load(to_ + i);
    V<double> f_lo = first;
    V<double> f_hi = first;
    // Find the first two samples between which f changes its sign.
    for (std::size_t k = 1; k < samples; ++k) {
        const V<double> f = points_.f_at(k * size + i);
        const M<double> here = hn::AndNot(found, hn::Lt(hn::Mul(before, f), zero));
        lo = hn::IfThenElse(here, sample_at(i, k - 1, samples), lo);
        hi = hn::IfThenElse(here, sample_at(i, k, samples), hi);
        f_lo = hn::IfThenElse(here, before, f_lo);
        f_hi = hn::IfThenElse(here, f, f_hi);
        found = hn::Or(found, here);
        before = f;
    }
    // Begin where the secant vanishes.
    const V<double> part = hn::Div(f_lo, hn::Sub(f_lo, f_hi));
    const M<double> inner = hn::And(hn::Gt(part, zero), hn::Lt(part, number(1.0)));
    const V<double> within = hn::IfThenElse(inner, part, number(0.5));
    store(hn::MulAdd(within, hn::Sub(hi, lo), lo), next_ + i);
    store(lo, lo_ + i);
    store(hi, hi_ + i);
    store(f_lo, f_lo_ + i);
    store(f_hi, f_hi_ + i);
    store(zero, stood_ + i);
    store(zero, was_before_ + i);
    store(flags(found), open_ + i);
    store(flags(found), found_ + i);
    store(flags(hn::Gt(first, zero)), falls_ + i);
    store(load(to_ + i), s_ + i);
    return !hn::AllFalse(d<double>, found);
}

HWY_INLINE bool RootSearch::take(std::size_t i, const TileLines& tile, const LinesOfRays& lines,
                                 std::size_t point) {
    const V<double> zero = hn::Zero(d<double>);
    const M<double> open = flags_at(open_ + i);
    const V<double> next = load(next_ + i);
    const V<double> f = points_.f_at(point);
    const V<double> slope = dot(points_.gradient_at(point), lines.direction);
    const M<double> before = hn::Not(hn::Xor(hn::Gt(f, zero), hn::Gt(load(f_lo_ + i), zero)));
    const V<double> lo = hn::IfThenElse(before, next, load(lo_ + i));
    const V<double> hi = hn::IfThenElse(before, load(hi_ + i), next);
    store_in(hn::And(open, before), f, f_lo_ + i);
    const M<double> same = hn::Not(hn::Xor(before, flags_at(was_before_ + i)));
    const V<double> stood = hn::IfThenElseZero(same, hn::Add(load(stood_ + i), number(1.0)));
    // Go on by Newton's method, or in the middle of the bracket.
    const V<double> newton = hn::Sub(next, hn::Div(f, slope));
    const M<double> fits =
        hn::And(hn::And(hn::Gt(newton, lo), hn::Lt(newton, hi)), hn::Lt(stood, number(3.0)));
    const V<double> half = number(0.5);
    const V<double> middle = hn::Add(hn::Mul(half, lo), hn::Mul(half, hi));
    const V<double> after = hn::IfThenElse(fits, newton, middle);
    store(lo, lo_ + i);
    store(hi, hi_ + i);
    store(stood, stood_ + i);
    store(flags(before), was_before_ + i);
    store(after, next_ + i);
    store_in(open, after, s_ + i);
    // End where the step or the bracket is short enough.
    const V<double> tolerance = tile.error_of_root(next);
    const M<double> is_near = hn::Le(hn::Abs(hn::Sub(after, next)), tolerance);
    const M<double> wide = hn::Gt(hn::Sub(hi, lo), tolerance);
    const M<double> still = hn::And(open, hn::AndNot(is_near, wide));
    store(flags(still), open_ + i);
    return !hn::AllFalse(d<double>, still);
}

HWY_INLINE void RootSearch::end(std::size_t i, const TileLines& tile, const LinesOfRays& lines) {
    const V<double> zero = hn::Zero(d<double>);
    const V<double> s = load(s_ + i);
    Vectors3 gradient = points_.gradient_at(i);
    const V<double> slope = dot(gradient, lines.direction);
    const V<double> per_slope = hn::Div(number(-1.0), slope);
    store(hn::Mul(tile.by_col(gradient, s), per_slope), by_col_ + i);
    store(hn::Mul(tile.by_row(gradient, s), per_slope), by_row_ + i);
    const V<double> along_square = dot(lines.direction, lines.direction);
    const V<double> sizes = hn::Sqrt(hn::Mul(dot(gradient, gradient), along_square));
    store(hn::Div(hn::Abs(slope), sizes), cosine_ + i);
    // Turn the gradient until it is upright on the ray, and a little more.
    const M<double> falls = flags_at(falls_ + i);
    const M<double> turned = hn::Xor(hn::Lt(slope, zero), falls);
    const V<double> least = hn::Mul(number(1e-3), sizes);
    const V<double> wanted = hn::IfThenElse(falls, hn::Neg(least), least);
    const V<double> change = hn::Div(hn::Sub(wanted, slope), along_square);
    gradient = along(gradient, hn::IfThenElseZero(turned, change), lines.direction);
    store(gradient.x, gradient_[0] + i);
    store(gradient.y, gradient_[1] + i);
    store(gradient.z, gradient_[2] + i);
}

inline void RootSearch::write(std::span<RayRoot> roots, std::span<const std::uint32_t> some) const {
    for (std::size_t i = 0; i < some.size(); ++i) {
        RayRoot& root = roots[some[i]];
        root.found = found_[i] != 0.0;
        root.s = s_[i];
        root.gradient = {gradient_[0][i], gradient_[1][i], gradient_[2][i]};
        root.by_col = by_col_[i];
        root.by_row = by_row_[i];
        root.cosine = cosine_[i];
    }
}

inline void RootSearch::search(const TraceFrame& frame, const TileRays& rays,
                               std::span<RayRoot> roots, std::span<const std::uint32_t> some,
                               std::size_t samples, Counters& counters) {
    constexpr int most_steps = 40;
    const TileLines tile(rays);
    const std::size_t size = padded(some.size());
    for (std::size_t i = 0; i < size; ++i) {
        const RayRoot& root = roots[some[std::min(i, some.size() - 1)]];
        u_[i] = rays.u(root.col);
        v_[i] = rays.v(root.row);
        from_[i] = root.from;
        to_[i] = root.to;
    }
    const auto lines_at = [&](std::size_t i) { return tile.at(load(u_ + i), load(v_ + i)); };
    const OpenParts<capacity> all(size);
    // Sample all stretches, and bracket their first roots.
    all.for_each([&](std::size_t i, std::size_t) {
        for (std::size_t k = 0; k < samples; ++k)
            points_.ask(k * size + i, lines_at(i), sample_at(i, k, samples));
    });
    points_.evaluate(frame, samples * size);
    counters.value += samples * some.size();
    OpenParts<capacity> open = all;
    open.keep([&](std::size_t i, std::size_t) { return bracket(i, size, samples); });
    // Narrow brackets until a step is shorter than the error that roots may have.
    for (int step = 0; step < most_steps && open.size() > 0 && !frame.stopped(); ++step) {
        open.for_each([&](std::size_t i, std::size_t point) {
            points_.ask(point, lines_at(i), load(next_ + i));
        });
        points_.evaluate(frame, open.size());
        counters.value += open.size();
        open.keep(
            [&](std::size_t i, std::size_t point) { return take(i, tile, lines_at(i), point); });
    }
    // Take the gradients a little before the roots: on the branch that leads there, and where the
    // gradient of an f that only comes to 0 does not vanish.
    constexpr double before = 1.0 / 64;  // in pixels
    all.for_each([&](std::size_t i, std::size_t) {
        const V<double> s = load(s_ + i);
        const V<double> step = hn::Mul(number(before), tile.pixel_at(s));
        const V<double> least = hn::IfThenZeroElse(flags_at(found_ + i), step);
        const V<double> back = hn::Max(least, hn::Mul(number(2.0), tile.error_of_root(s)));
        points_.ask(i, lines_at(i), hn::Sub(s, back));
    });
    points_.evaluate(frame, size);
    counters.value += some.size();
    all.for_each([&](std::size_t i, std::size_t) { end(i, tile, lines_at(i)); });
    write(roots, some);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
