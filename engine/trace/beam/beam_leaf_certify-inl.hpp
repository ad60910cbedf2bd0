// Certificates for the roots of a small tile: the interval Newton operator on all its pixels at
// once. Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_LEAF_CERTIFY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_LEAF_CERTIFY_INL
#undef ZEROSET_BEAM_LEAF_CERTIFY_INL
#else
#define ZEROSET_BEAM_LEAF_CERTIFY_INL
#endif

#include "engine/trace/beam/beam_leaf-inl.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real, int pixels>
void LeafSolver<Real, pixels>::certify(bool last) {
    const int slots = std::exchange(slots_, 0);
    for (int slot = 0; slot < slots; ++slot) {
        bool again = false;
        for (int col = 0; col < pixels; col += lanes) {
            const int i = slot * pixels + col;
            const std::size_t pixel = first_pixel(rows_[slot]) + static_cast<std::size_t>(col);
            // Find brackets, inside the clip box.
            Judged judged = judge(pixel, i);
            if (!run_->inside) judged = clipped(i, judged);
            // Record proved roots; where f has kinks their gradients are asked for once more.
            const M proved = hn::And(judged.proved, judged.wanted);
            if (!hn::AllFalse(d, proved)) {
                record(pixel, i, proved, judged.s);
                if (run_->kinked) add_pending(pixel, i, bits_of(d, proved));
            }
            // Leave the vector where nothing is open.
            const M left = hn::AndNot(proved, judged.wanted);
            if (hn::AllFalse(d, left)) {
                hn::Store(nothing(), d, newton_.to + i);
                continue;
            }
            // Take more steps where brackets are wide, hand over the others.
            const M wide = last ? hn::FirstN(d, 0) : hn::And(left, judged.wide);
            again = again || !hn::AllFalse(d, wide);
            const Judged open = judged;  // in memory only here
            push_open_brackets(pixel, i, open, bits_of(d, hn::AndNot(wide, left)));
            hn::Store(hn::IfThenElse(wide, hn::Load(d, newton_.to + i), nothing()), d,
                      newton_.to + i);
        }
        if (again) keep_row(slot);
    }
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::keep_row(int slot) {
    const int to = slots_++;
    if (to == slot) return;
    rows_[to] = rows_[slot];
    const auto copy = [&](auto* column) {
        std::copy_n(column + slot * pixels, pixels, column + to * pixels);
    };
    for (Real* column : {newton_.from, newton_.to, newton_.guess, newton_.gradient[0],
                         newton_.gradient[1], newton_.gradient[2]})
        copy(column);
    for (float* column : {newton_.col, newton_.row, newton_.float_per_slope})
        copy(column);
    copy(newton_.s);
}

template <class Real, int pixels>
HWY_INLINE auto LeafSolver<Real, pixels>::bounds_of(const double* x) -> std::pair<V, V> {
    if constexpr (std::is_same_v<Real, double>) {
        const V v = hn::Load(d, x);
        return {v, hn::Neg(v)};
    } else {
        const hn::Half<D> half;
        const hn::Rebind<double, hn::Half<D>> dd;
        const auto low = hn::Load(dd, x);
        const auto high = hn::Load(dd, x + hn::MaxLanes(dd));
        return {
            hn::Combine(d, hn::DemoteTo(half, high), hn::DemoteTo(half, low)),
            hn::Combine(d, hn::DemoteTo(half, hn::Neg(high)), hn::DemoteTo(half, hn::Neg(low)))};
    }
}

/// The interval Newton operator, see RootFinder::step; all rounded outward.
template <class Real, int pixels>
HWY_INLINE auto LeafSolver<Real, pixels>::judge(std::size_t pixel, int i) const -> Judged {
    // Enclose f, as if it were rising.
    const V zero = hn::Zero(d);
    const V error = hn::Set(d, error_);
    const auto [f_above, f_neg_below] = bounds_of(newton_.f + i);
    const V f_hi = hn::Add(f_above, error);
    const V f_neg_lo = hn::Add(f_neg_below, error);
    const V hi_of_rising = run_->falls() ? f_neg_lo : f_hi;
    const V neg_lo_of_rising = run_->falls() ? f_hi : f_neg_lo;
    // Divide by the slopes, rounded upward.
    const auto quotient_up = [&](V f) {
        const V factor =
            hn::IfThenElse(hn::Gt(f, zero), hn::Set(d, per_least_), hn::Set(d, per_most_));
        return hn::Mul(f, factor);
    };
    const V before = quotient_up(hi_of_rising);
    const V behind = quotient_up(neg_lo_of_rising);
    // The root is in [lo, hi] if the slopes hold there.
    const auto [s, neg_s] = bounds_of(newton_.s + i);
    const V lo = hn::Neg(hn::Add(before, neg_s));
    const V hi = hn::Add(behind, s);
    const V tolerance = hn::Set(d, tolerance_);
    const M narrow = hn::Le(hn::Add(before, behind), tolerance);
    const M within = hn::And(hn::Ge(lo, hn::Set(d, run_->lo)), hn::Le(hi, hn::Set(d, run_->hi)));
    // Leave out what is beside the bracket so far, or behind a root.
    const V found = hn::LoadU(d, &nearest_.s[pixel]);
    const V from = hn::Load(d, newton_.from + i);
    const V to = hn::Load(d, newton_.to + i);
    const M beside = hn::Or(hn::Lt(hi, from), hn::Gt(lo, hn::Min(to, found)));
    return {.proved = hn::And(narrow, within),
            .wanted = hn::AndNot(beside, hn::Le(from, to)),
            .wide = hn::Not(narrow),
            .lo = lo,
            .hi = hi,
            .s = hn::Min(hn::Max(s, lo), hi)};
}

template <class Real, int pixels>
auto LeafSolver<Real, pixels>::clipped(int i, Judged judged) const -> Judged {
    alignas(64) Real lo[side], hi[side];
    hn::Store(judged.lo, d, lo);
    hn::Store(judged.hi, d, hi);
    LaneBits inside = 0;
    LaneBits outside = 0;
    for (int lane = 0; lane < lanes; lane += clip_lanes) {
        const ClipDepths depths(rays_, newton_.col + i + lane, newton_.row + i + lane);
        inside |= depths.surely_inside(lo + lane, hi + lane) << lane;
        outside |= depths.surely_outside(lo + lane, hi + lane) << lane;
    }
    judged.proved = hn::And(judged.proved, mask_of(d, inside));
    judged.wanted = hn::And(judged.wanted, mask_of(d, ~outside));
    return judged;
}

template <class Real, int pixels>
HWY_INLINE void LeafSolver<Real, pixels>::record(std::size_t pixel, int i, M proved, V s) {
    const V before = hn::LoadU(d, &nearest_.s[pixel]);
    const M nearest = hn::And(proved, hn::Lt(s, before));
    if constexpr (std::is_same_v<Real, float>) {
        if (hn::AllTrue(d, nearest)) {
            hn::StoreU(s, d, &nearest_.s[pixel]);
            for (std::size_t k = 0; k < 3; ++k)
                hn::StoreU(hn::Load(d, newton_.gradient[k] + i), d, nearest_.gradients(k, pixel));
            nearest_.template certify<lanes>(pixel);
            return;
        }
    }
    hn::StoreU(hn::IfThenElse(nearest, s, before), d, &nearest_.s[pixel]);
    store_gradients(pixel, i, nearest);
    nearest_.template certify<lanes>(pixel, bits_of(d, nearest));
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::add_pending(std::size_t pixel, int i, LaneBits rays) {
    for (; rays != 0; rays &= rays - 1) {
        const int lane = std::countr_zero(rays);
        nearest_.pending.push_back(
            {static_cast<std::uint32_t>(pixel) + static_cast<std::uint32_t>(lane),
             newton_.s[i + lane], run_->falls() ? Trend::Falling : Trend::Rising});
    }
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::push_open_brackets(std::size_t pixel, int i, const Judged& judged,
                                                  LaneBits rays) {
    if (rays == 0) return;
    alignas(64) Real lo[side], hi[side], s[side];
    hn::Store(judged.lo, d, lo);
    hn::Store(judged.hi, d, hi);
    hn::Store(judged.s, d, s);
    for (; rays != 0; rays &= rays - 1) {
        const int lane = std::countr_zero(rays);
        const int at = i + lane;
        const bool known = lo[lane] <= hi[lane];
        const Real from = known ? std::max(newton_.from[at], lo[lane]) : newton_.from[at];
        const Real to = known ? std::min(newton_.to[at], hi[lane]) : newton_.to[at];
        const Real guess = known ? s[lane] : newton_.guess[at];
        roots_.push({.pixel = static_cast<std::uint32_t>(pixel) + static_cast<std::uint32_t>(lane),
                     .inside = run_->inside,
                     .from = static_cast<double>(from),
                     .to = static_cast<double>(to),
                     .lo = static_cast<double>(run_->lo),
                     .hi = static_cast<double>(run_->hi),
                     .guess = static_cast<double>(std::clamp(guess, from, to)),
                     .slope_lo = static_cast<double>(run_->slope_lo),
                     .slope_hi = static_cast<double>(run_->slope_hi),
                     .r = static_cast<double>(run_->r),
                     .kernel = run_->kernel,
                     .kinked = run_->kinked,
                     .again = true});
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
