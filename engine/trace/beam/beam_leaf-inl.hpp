// The roots of a small tile on which f is monotone along the rays: all its pixels at once.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_LEAF_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_LEAF_INL
#undef ZEROSET_BEAM_LEAF_INL
#else
#define ZEROSET_BEAM_LEAF_INL
#endif

#include "engine/trace/beam/beam_clip-inl.hpp"
#include "engine/trace/beam/beam_roots-inl.hpp"
#include "engine/trace/beam/leaf_run.hpp"

#include <optional>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Solves leaves of `pixels` x `pixels` pixels: guesses from the forms, Newton's method in the
/// cells' type, then one value in double that certifies. What that leaves open goes to the root
/// finder.
template <class Real, int pixels>
class LeafSolver {
public:
    LeafSolver(const TraceFrame& frame, const Tile& tile, const BeamView& view, Found<Real>& found,
               RootFinder<Real>& roots, Counters& counters)
        : frame_(frame),
          tile_(tile),
          view_(view),
          found_(found),
          roots_(roots),
          counters_(counters) {}

    /// One more leaf, behind those that were added before of the same pixels.
    void add(const Leaf<Real>& leaf) {
        if (run_ && run_->continues_with(leaf)) {
            run_->add(leaf);
            place<false>(leaf);
        } else {
            solve();
            run_.emplace(leaf);
            place<true>(leaf);
        }
    }
    /// Works off what has been added.
    void solve();

private:
    static constexpr std::size_t side = pixels;
    static constexpr std::size_t items = side * side;
    static constexpr int most_steps = 4;
    using D = hn::CappedTag<Real, side>;
    using V = hn::Vec<D>;
    using M = hn::Mask<D>;
    static constexpr D d{};
    static constexpr int lanes = hn::MaxLanes(d);

    /// What the interval Newton operator makes of a vector of rays.
    struct Judged {
        M proved, wanted, wide;  ///< wide: where more steps may help
        V lo, hi;                ///< where the root is
        V s;                     ///< near it
    };

    /// The stretches of a leaf's rays, empty where from > to; joined to those before.
    template <bool first_of_run>
    void place(const Leaf<Real>& leaf);
    /// Leaves out rows without stretches; false when none is left.
    bool compact();
    void find_roots();
    /// Newton's method in the cells' type.
    void take_steps();
    /// f in double, after so many more steps.
    void evaluate(int steps);
    /// Certifies what it can and leaves out rows in which no more steps would help; the rest of
    /// them, and the last time all that is not proved, goes to the root finder.
    void certify(bool last);
    /// Makes a row the next of those that remain.
    void keep(int slot);
    [[nodiscard]] HWY_INLINE Judged judge(std::size_t pixel, int i) const;
    HWY_INLINE void record(std::size_t pixel, int i, M proved, V s);
    /// Leaves the gradients of these rays to be found: Newton's method may have seen another
    /// branch.
    void add_pending(std::size_t pixel, int i, LaneBits rays);
    void hand_over(std::size_t pixel, int i, const Judged& judged, LaneBits rays);
    [[nodiscard]] Judged clipped(int i, Judged judged) const;
    HWY_INLINE static std::pair<V, V> bounds_of(const double* x);
    /// The gradients of the rays in the mask.
    void store_gradients(std::size_t pixel, int i, M rays) {
        if constexpr (std::is_same_v<Real, float>) {
            // A masked store costs more than these on many processors.
            for (std::size_t k = 0; k < 3; ++k) {
                float* const to = found_.gradients(k, pixel);
                const V before = hn::LoadU(d, to);
                hn::StoreU(hn::IfThenElse(rays, hn::Load(d, gradient_[k] + i), before), d, to);
            }
        } else {
            for (LaneBits bits = bits_of(d, rays); bits != 0; bits &= bits - 1) {
                const int at = i + std::countr_zero(bits);
                const auto gradient =
                    float_gradient({gradient_[0][at], gradient_[1][at], gradient_[2][at]});
                for (std::size_t k = 0; k < 3; ++k)
                    found_.gradients(k, pixel)[at - i] = gradient[k];
            }
        }
    }
    static M mask_of(LaneBits bits) {
        std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits)};
        return hn::LoadMaskBits(d, bytes);
    }
    /// The end of a stretch that is not wanted.
    static V nothing() { return hn::Set(d, -std::numeric_limits<Real>::infinity()); }
    [[nodiscard]] std::size_t first_pixel(int row) const {
        return static_cast<std::size_t>((run_->row + row) * tile_size + run_->col);
    }
    /// Repeats the first row up to a whole batch.
    template <class Number>
    void pad(Number* column) const {
        for (std::size_t i = used(); i < count(); i += side)
            std::copy_n(column, side, column + i);
    }
    [[nodiscard]] std::size_t used() const { return static_cast<std::size_t>(slots_) * side; }
    [[nodiscard]] std::size_t count() const { return padded(used(), run_->kernel->lane_multiple); }

    const TraceFrame& frame_;
    const Tile& tile_;
    const BeamView& view_;
    Found<Real>& found_;
    RootFinder<Real>& roots_;
    Counters& counters_;
    std::optional<LeafRun<Real>> run_;

    int slots_ = 0;  ///< rows that have stretches
    int rows_[side];
    Real error_ = 0;      ///< of f in double
    Real tolerance_ = 0;  ///< of brackets
    Real per_least_ = 0;  ///< not below 1 / |df/ds|
    Real per_most_ = 0;   ///< not above it
    alignas(64) Real from_[items], to_[items], guess_[items];
    alignas(64) float col_[items], row_[items];
    alignas(64) Real gradient_[3][items], per_slope_[items];
    alignas(64) float float_per_slope_[items];
    alignas(64) double depth_[items], f_[items];
};

template <class Real, int pixels>
template <bool first_of_run>
void LeafSolver<Real, pixels>::place(const Leaf<Real>& leaf) {
    const Real steepness = std::max(std::abs(leaf.kt), std::numeric_limits<Real>::min());
    const Real scale = leaf.reach / std::copysign(steepness, leaf.kt);
    const Real error =
        leaf.e + static_cast<Real>(0x1p-10 * tile_size) * (std::abs(leaf.ku) + std::abs(leaf.kv));
    const Real rounding =
        8 * std::numeric_limits<Real>::epsilon() * (std::abs(leaf.s) + leaf.reach);
    const V radius = hn::Set(d, error * std::abs(scale) + rounding);
    const V from = hn::Set(d, leaf.from);
    const V to = hn::Set(d, leaf.to);
    const V by_col = hn::Set(d, leaf.ku * scale);
    for (int row = 0; row < pixels; ++row) {
        const Real first = leaf.s - (leaf.c - leaf.kv * static_cast<Real>(row)) * scale;
        for (int col = 0; col < pixels; col += lanes) {
            const int i = row * pixels + col;
            const V x = hn::Iota(d, static_cast<Real>(col));
            const V middle = hn::NegMulAdd(x, by_col, hn::Set(d, first));
            const V ray_from = hn::Max(hn::Sub(middle, radius), from);  // `from` where NaN
            const V ray_to = hn::Min(hn::Add(middle, radius), to);
            const V guess = hn::Min(hn::Max(middle, ray_from), ray_to);
            if constexpr (first_of_run) {
                hn::Store(ray_from, d, from_ + i);
                hn::Store(ray_to, d, to_ + i);
                hn::Store(guess, d, guess_ + i);
                continue;
            }
            const M some = hn::Le(ray_from, ray_to);
            const V before_from = hn::Load(d, from_ + i);
            const V before_to = hn::Load(d, to_ + i);
            const M only = hn::AndNot(hn::Le(before_from, before_to), some);
            const M better = hn::Or(only, hn::And(some, hn::Ge(middle, from)));
            const auto join = [&](V before, V both, V alone) {
                return hn::IfThenElse(only, alone, hn::IfThenElse(some, both, before));
            };
            hn::Store(join(before_from, hn::Min(before_from, ray_from), ray_from), d, from_ + i);
            hn::Store(join(before_to, hn::Max(before_to, ray_to), ray_to), d, to_ + i);
            hn::Store(hn::IfThenElse(better, guess, hn::Load(d, guess_ + i)), d, guess_ + i);
        }
    }
}

template <class Real, int pixels>
bool LeafSolver<Real, pixels>::compact() {
    const int cols = std::min(pixels, tile_.cols - run_->col);
    const int rows = std::min(pixels, tile_.rows - run_->row);
    slots_ = 0;
    for (int row = 0; row < rows; ++row) {
        const std::size_t pixel = first_pixel(row);
        M any = hn::FirstN(d, 0);
        for (int col = 0; col < pixels; col += lanes) {
            const int in = row * pixels + col;
            const int out = slots_ * pixels + col;
            const V from = hn::Load(d, from_ + in);
            const V to = hn::Load(d, to_ + in);
            const V before = hn::LoadU(d, &found_.depth[pixel + static_cast<std::size_t>(col)]);
            const M in_tile =
                hn::FirstN(d, static_cast<std::size_t>(std::clamp(cols - col, 0, lanes)));
            const M valid = hn::And(in_tile, hn::Le(from, hn::Min(to, before)));
            any = hn::Or(any, valid);
            hn::Store(from, d, from_ + out);
            hn::Store(hn::IfThenElse(valid, to, nothing()), d, to_ + out);
            hn::Store(hn::Load(d, guess_ + in), d, guess_ + out);
        }
        if (hn::AllFalse(d, any)) continue;
        for (int col = 0; col < pixels; ++col) {
            col_[slots_ * pixels + col] = from_middle(run_->col + col);
            row_[slots_ * pixels + col] = from_middle(run_->row + row);
        }
        rows_[slots_++] = row;
    }
    return slots_ > 0;
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::take_steps() {
    pad(from_);
    pad(to_);
    pad(guess_);
    pad(col_);
    pad(row_);
    counters_.value += 2 * used();
    run_->kernel->newton(NewtonBatchOf<Real>{count(),
                                             col_,
                                             row_,
                                             from_,
                                             to_,
                                             view_.rays<Real>(),
                                             frame_.scene.uniforms.template points<Real>(),
                                             static_cast<Real>(view_.small_step()),
                                             most_steps - 1,
                                             guess_,
                                             {gradient_[0], gradient_[1], gradient_[2]},
                                             per_slope_});
    for (std::size_t i = 0; i < count(); ++i) {
        depth_[i] = static_cast<double>(guess_[i]);
        float_per_slope_[i] = static_cast<float>(per_slope_[i]);
    }
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::evaluate(int steps) {
    counters_.value += static_cast<std::size_t>(1 + steps) * used();
    // The slopes hold between lo and hi, and with them what certify() concludes.
    run_->kernel->ray_value(
        RayValueBatch{count(), col_, row_, float_per_slope_, steps, static_cast<double>(run_->lo),
                      static_cast<double>(run_->hi), depth_, view_.rays<double>(),
                      frame_.scene.uniforms.points<double>(), f_});
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::certify(bool last) {
    const int slots = std::exchange(slots_, 0);
    for (int slot = 0; slot < slots; ++slot) {
        bool again = false;
        for (int col = 0; col < pixels; col += lanes) {
            const int i = slot * pixels + col;
            const std::size_t pixel = first_pixel(rows_[slot]) + static_cast<std::size_t>(col);
            Judged judged = judge(pixel, i);
            if (!run_->inside) judged = clipped(i, judged);
            const M proved = hn::And(judged.proved, judged.wanted);
            if (!hn::AllFalse(d, proved)) {
                record(pixel, i, proved, judged.s);
                if (run_->kinked) add_pending(pixel, i, bits_of(d, proved));
            }
            const M rest = hn::AndNot(proved, judged.wanted);
            if (hn::AllFalse(d, rest)) {
                hn::Store(nothing(), d, to_ + i);
                continue;
            }
            const M wide = last ? hn::FirstN(d, 0) : hn::And(rest, judged.wide);
            again = again || !hn::AllFalse(d, wide);
            const Judged open = judged;  // in memory only here
            hand_over(pixel, i, open, bits_of(d, hn::AndNot(wide, rest)));
            hn::Store(hn::IfThenElse(wide, hn::Load(d, to_ + i), nothing()), d, to_ + i);
        }
        if (again) keep(slot);
    }
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::keep(int slot) {
    const int to = slots_++;
    if (to == slot) return;
    rows_[to] = rows_[slot];
    const auto copy = [&](auto* column) {
        std::copy_n(column + slot * pixels, pixels, column + to * pixels);
    };
    for (Real* column : {from_, to_, guess_, gradient_[0], gradient_[1], gradient_[2]})
        copy(column);
    for (float* column : {col_, row_, float_per_slope_})
        copy(column);
    copy(depth_);
}

/// Upper bounds of x and of -x in the cells' type.
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
    const V zero = hn::Zero(d);
    const V error = hn::Set(d, error_);
    const auto [f_above, f_neg_below] = bounds_of(f_ + i);
    const V f_hi = hn::Add(f_above, error);
    const V f_neg_lo = hn::Add(f_neg_below, error);
    const V hi_of_rising = run_->falls() ? f_neg_lo : f_hi;
    const V neg_lo_of_rising = run_->falls() ? f_hi : f_neg_lo;
    const auto quotient_up = [&](V f) {
        const V factor =
            hn::IfThenElse(hn::Gt(f, zero), hn::Set(d, per_least_), hn::Set(d, per_most_));
        return hn::Mul(f, factor);
    };
    const V before = quotient_up(hi_of_rising);
    const V behind = quotient_up(neg_lo_of_rising);
    const auto [s, neg_s] = bounds_of(depth_ + i);
    const V lo = hn::Neg(hn::Add(before, neg_s));
    const V hi = hn::Add(behind, s);
    const V tolerance = hn::Set(d, tolerance_);
    const M narrow = hn::Le(hn::Add(before, behind), tolerance);
    const M within = hn::And(hn::Ge(lo, hn::Set(d, run_->lo)), hn::Le(hi, hn::Set(d, run_->hi)));
    const V found = hn::LoadU(d, &found_.depth[pixel]);
    const V from = hn::Load(d, from_ + i);
    const V to = hn::Load(d, to_ + i);
    const M beside = hn::Or(hn::Lt(hi, from), hn::Gt(lo, hn::Min(to, found)));
    return {
        hn::And(narrow, within),    hn::AndNot(beside, hn::Le(from, to)), hn::Not(narrow), lo, hi,
        hn::Min(hn::Max(s, lo), hi)};
}

/// Drops roots that are surely outside the clip box; those that may be are not proved.
template <class Real, int pixels>
auto LeafSolver<Real, pixels>::clipped(int i, Judged judged) const -> Judged {
    alignas(64) Real lo[side], hi[side];
    hn::Store(judged.lo, d, lo);
    hn::Store(judged.hi, d, hi);
    LaneBits inside = 0;
    LaneBits outside = 0;
    for (int lane = 0; lane < lanes; lane += clip_lanes) {
        const ClipDepths depths(view_, col_ + i + lane, row_ + i + lane);
        inside |= depths.surely_inside(lo + lane, hi + lane) << lane;
        outside |= depths.surely_outside(lo + lane, hi + lane) << lane;
    }
    judged.proved = hn::And(judged.proved, mask_of(inside));
    judged.wanted = hn::And(judged.wanted, mask_of(~outside));
    return judged;
}

template <class Real, int pixels>
HWY_INLINE void LeafSolver<Real, pixels>::record(std::size_t pixel, int i, M proved, V s) {
    const V before = hn::LoadU(d, &found_.depth[pixel]);
    const M nearest = hn::And(proved, hn::Lt(s, before));
    if constexpr (std::is_same_v<Real, float>) {
        if (hn::AllTrue(d, nearest)) {
            hn::StoreU(s, d, &found_.depth[pixel]);
            for (std::size_t k = 0; k < 3; ++k)
                hn::StoreU(hn::Load(d, gradient_[k] + i), d, found_.gradients(k, pixel));
            found_.template certify<lanes>(pixel);
            return;
        }
    }
    hn::StoreU(hn::IfThenElse(nearest, s, before), d, &found_.depth[pixel]);
    store_gradients(pixel, i, nearest);
    found_.template certify<lanes>(pixel, bits_of(d, nearest));
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::add_pending(std::size_t pixel, int i, LaneBits rays) {
    for (; rays != 0; rays &= rays - 1) {
        const int lane = std::countr_zero(rays);
        found_.pending.push_back(
            {static_cast<std::uint32_t>(pixel) + static_cast<std::uint32_t>(lane), depth_[i + lane],
             run_->falls() ? Trend::Falling : Trend::Rising});
    }
}

/// What is not proved goes to the root finder.
template <class Real, int pixels>
void LeafSolver<Real, pixels>::hand_over(std::size_t pixel, int i, const Judged& judged,
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
        const Real from = known ? std::max(from_[at], lo[lane]) : from_[at];
        const Real to = known ? std::min(to_[at], hi[lane]) : to_[at];
        const Real guess = known ? s[lane] : guess_[at];
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

template <class Real, int pixels>
void LeafSolver<Real, pixels>::solve() {
    if (!run_) return;
    if (compact()) find_roots();
    run_.reset();
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::find_roots() {
    const Real least = run_->falls() ? -run_->slope_hi : run_->slope_lo;
    const Real most = run_->falls() ? -run_->slope_lo : run_->slope_hi;
    per_least_ = 1 / least;
    per_most_ = -(-1 / most);
    error_ = upper_end(Real{}, value_error(static_cast<double>(run_->r)));
    tolerance_ = static_cast<Real>(view_.tolerance());
    take_steps();
    evaluate(1);
    certify(false);
    if (slots_ == 0) return;
    pad(col_);
    pad(row_);
    evaluate(1);
    certify(true);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
