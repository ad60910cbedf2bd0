// The roots of a small tile on which f is monotone along the rays: all its pixels at once.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_LEAF_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_LEAF_INL
#undef ZEROSET_BEAM_LEAF_INL
#else
#define ZEROSET_BEAM_LEAF_INL
#endif

#include "engine/trace/beam_roots-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A smooth cell.
struct Leaf {
    int col, row;  ///< first pixel in the tile
    bool inside;   ///< all rays are inside the clip box in the slab
    // f is c + ku x - kv y + kt t + [-e, e] at x pixels right and y below the tile's middle, at
    // the depth s + reach t.
    float c, ku, kv, kt, e;
    float s, reach;
    float from, to;             ///< the slab
    float slope_lo, slope_hi;   ///< of df/ds, of one sign
    float r;                    ///< see FormBatchOf
};

/// Solves leaves of `pixels` x `pixels` pixels: guesses from the form, Newton's method in float,
/// then one step in double that certifies. What that leaves open goes to the root finder.
template <int pixels>
class LeafSolver {
public:
    LeafSolver(const TraceFrame& frame, const Tile& tile, const BeamView& view, Found& found,
               RootFinder& roots, Counters& counters);
    void solve(const Leaf& leaf);

private:
    static constexpr std::size_t side = pixels;
    static constexpr std::size_t items = side * side;
    static constexpr int most_float_steps = 4;
    using DF = hn::CappedTag<float, side>;
    using DD = hn::CappedTag<double, 4>;
    using VF = hn::Vec<DF>;
    using VD = hn::Vec<DD>;
    static constexpr DF df{};
    static constexpr DD dd{};

    /// Stretches of the rays; rows without any are left out. False when there is none.
    bool place(const Leaf& leaf);
    void make_rays(const Leaf& leaf);
    /// The largest step taken, or +inf where one was not a number.
    float step_in_float();
    void evaluate_in_double();
    void certify(const Leaf& leaf);
    [[nodiscard]] LaneBits wanted(const Leaf& leaf, int slot) const;
    /// Hands on the proved roots of one row, all of whose pixels are wanted.
    void record_row(const Leaf& leaf, int slot);
    /// Hands on one row of results, and what they leave open.
    void record(const Leaf& leaf, int slot);
    [[nodiscard]] int count() const {
        return (slots_ * pixels + static_cast<int>(batch_multiple) - 1) /
               static_cast<int>(batch_multiple) * static_cast<int>(batch_multiple);
    }

    const TraceFrame& frame_;
    const Tile& tile_;
    const BeamView& view_;
    Found& found_;
    RootFinder& roots_;
    Counters& counters_;
    float small_step_;  ///< a step behind which the next one is below the tolerance

    int slots_ = 0;  ///< rows that have stretches
    int rows_[side];
    LaneBits valid_[side];   ///< of each such row, the rays that have one
    LaneBits proved_[side];  ///< of each such row, the brackets that prove a root
    alignas(64) float from_[items], to_[items];
    alignas(64) double guess_[items];
    alignas(64) double origin_[3][items];
    alignas(64) double direction_[3][items];
    alignas(64) float x_[3][items];
    alignas(64) float f_[items];
    alignas(64) float gradient_[3][items];
    alignas(64) double x_double_[3][items];
    alignas(64) double f_double_[items];
    alignas(64) double gradient_double_[3][items];
    alignas(64) double lo_[items], hi_[items], next_[items];  ///< brackets, and roots in them
};

template <int pixels>
LeafSolver<pixels>::LeafSolver(const TraceFrame& frame, const Tile& tile, const BeamView& view,
                               Found& found, RootFinder& roots, Counters& counters)
    : frame_(frame),
      tile_(tile),
      view_(view),
      found_(found),
      roots_(roots),
      counters_(counters),
      small_step_(static_cast<float>(frame.scene.clip.size() * 0x1p-14)) {}

template <int pixels>
bool LeafSolver<pixels>::place(const Leaf& leaf) {
    constexpr float half = 0.5F * (pixels - 1);
    const float steepness = std::max(std::abs(leaf.kt), std::numeric_limits<float>::min());
    const float scale = leaf.reach / std::copysign(steepness, leaf.kt);
    const float error = leaf.e + 0x1p-10F * half * (std::abs(leaf.ku) + std::abs(leaf.kv));
    const float rounding =
        8 * std::numeric_limits<float>::epsilon() * (std::abs(leaf.s) + leaf.reach);
    const VF radius = hn::Set(df, error * std::abs(scale) + rounding);
    const VF from = hn::Set(df, leaf.from);
    const VF to = hn::Set(df, leaf.to);
    const int cols = std::min(pixels, tile_.cols - leaf.col);
    const int rows = std::min(pixels, tile_.rows - leaf.row);
    slots_ = 0;
    for (int row = 0; row < rows; ++row) {
        const float row_c = leaf.c - leaf.kv * (static_cast<float>(row) - half);
        LaneBits valid = 0;
        for (int col = 0; col < pixels; col += static_cast<int>(hn::Lanes(df))) {
            const VF x = hn::Iota(df, static_cast<float>(col) - half);
            const VF c = hn::MulAdd(x, hn::Set(df, leaf.ku), hn::Set(df, row_c));
            const VF middle = hn::NegMulAdd(c, hn::Set(df, scale), hn::Set(df, leaf.s));
            const VF ray_from = hn::Max(hn::Sub(middle, radius), from);  // `from` where NaN
            const VF ray_to = hn::Min(hn::Add(middle, radius), to);
            valid |= bits_of(df, hn::Le(ray_from, ray_to)) << col;
            const VF guess = hn::Min(hn::Max(middle, ray_from), ray_to);
            const int at = slots_ * pixels + col;
            hn::Store(ray_from, df, from_ + at);
            hn::Store(ray_to, df, to_ + at);
            hn::Store(guess, df, f_ + at);
        }
        valid &= (1U << cols) - 1U;
        if (valid == 0) continue;
        for (int i = slots_ * pixels; i < (slots_ + 1) * pixels; ++i)
            guess_[i] = static_cast<double>(f_[i]);
        rows_[slots_] = row;
        valid_[slots_++] = valid;
    }
    return slots_ > 0;
}

template <int pixels>
void LeafSolver<pixels>::make_rays(const Leaf& leaf) {
    const ViewFrame& axes = view_.axes();
    const double u = view_.u(leaf.col);
    for (int slot = 0; slot < slots_; ++slot) {
        const double v = view_.v(leaf.row + rows_[slot]);
        for (int k = 0; k < 3; ++k) {
            const VD right = hn::Set(dd, axes.right[k]);
            const VD up = hn::Set(dd, v * axes.up[k]);
            for (int col = 0; col < pixels; col += static_cast<int>(hn::Lanes(dd))) {
                const VD x = hn::MulAdd(hn::Iota(dd, static_cast<double>(col)),
                                        hn::Set(dd, view_.pixel()), hn::Set(dd, u));
                const VD across = hn::MulAdd(x, right, up);
                const int at = slot * pixels + col;
                hn::Store(hn::MulAdd(hn::Set(dd, view_.distance()), across,
                                     hn::Set(dd, view_.base()[k])),
                          dd, origin_[k] + at);
                hn::Store(hn::Add(across, hn::Set(dd, axes.forward[k])), dd, direction_[k] + at);
            }
        }
    }
    for (int i = slots_ * pixels; i < count(); ++i) {
        guess_[i] = guess_[0];
        for (int k = 0; k < 3; ++k) {
            origin_[k][i] = origin_[k][0];
            direction_[k][i] = direction_[k][0];
        }
    }
}

template <int pixels>
float LeafSolver<pixels>::step_in_float() {
    const hn::Rebind<float, DD> d_narrow;
    const int size = count();
    for (int i = 0; i < size; i += static_cast<int>(hn::Lanes(dd))) {
        const VD s = hn::Load(dd, guess_ + i);
        for (int k = 0; k < 3; ++k) {
            const VD x = hn::MulAdd(s, hn::Load(dd, direction_[k] + i),
                                    hn::Load(dd, origin_[k] + i));
            hn::Store(hn::DemoteTo(d_narrow, x), d_narrow, x_[k] + i);
        }
    }
    counters_.value += static_cast<std::uint64_t>(slots_ * pixels);
    frame_.kernel.value({static_cast<std::size_t>(size),
                         {x_[0], x_[1], x_[2]},
                         frame_.scene.uniforms.points<float>(),
                         f_,
                         {gradient_[0], gradient_[1], gradient_[2]}});
    VD largest = hn::Zero(dd);
    for (int slot = 0; slot < slots_; ++slot) {
        for (int col = 0; col < pixels; col += static_cast<int>(hn::Lanes(dd))) {
            const int i = slot * pixels + col;
            VD slope = hn::Zero(dd);
            for (int k = 0; k < 3; ++k) {
                slope = hn::MulAdd(hn::PromoteTo(dd, hn::Load(d_narrow, gradient_[k] + i)),
                                   hn::Load(dd, direction_[k] + i), slope);
            }
            const VD f = hn::PromoteTo(dd, hn::Load(d_narrow, f_ + i));
            const VD s = hn::Load(dd, guess_ + i);
            const VD from = hn::PromoteTo(dd, hn::Load(d_narrow, from_ + i));
            const VD to = hn::PromoteTo(dd, hn::Load(d_narrow, to_ + i));
            // `from` where NaN.
            const VD next = hn::Min(hn::Max(hn::Sub(s, hn::Div(f, slope)), from), to);
            hn::Store(next, dd, guess_ + i);
            const auto used = hn::Le(from, to);
            largest = hn::Max(largest, hn::IfThenElseZero(used, hn::Abs(hn::Sub(next, s))));
        }
    }
    return static_cast<float>(hn::GetLane(hn::MaxOfLanes(dd, largest)));
}

template <int pixels>
void LeafSolver<pixels>::evaluate_in_double() {
    const int size = count();
    for (int i = 0; i < size; i += static_cast<int>(hn::Lanes(dd))) {
        const VD s = hn::Load(dd, guess_ + i);
        for (int k = 0; k < 3; ++k) {
            hn::Store(hn::MulAdd(s, hn::Load(dd, direction_[k] + i), hn::Load(dd, origin_[k] + i)),
                      dd, x_double_[k] + i);
        }
    }
    counters_.value += static_cast<std::uint64_t>(slots_ * pixels);
    frame_.kernel.value(
        ValueBatchOf<double>{static_cast<std::size_t>(size),
                             {x_double_[0], x_double_[1], x_double_[2]},
                             frame_.scene.uniforms.points<double>(),
                             f_double_,
                             {gradient_double_[0], gradient_double_[1], gradient_double_[2]}});
}

/// The interval Newton operator, see RootFinder::step_in_double; both ends rounded outward.
template <int pixels>
void LeafSolver<pixels>::certify(const Leaf& leaf) {
    const bool falling = leaf.slope_hi < 0;
    const auto least = static_cast<double>(falling ? -leaf.slope_hi : leaf.slope_lo);
    const auto most = static_cast<double>(falling ? -leaf.slope_lo : leaf.slope_hi);
    const VD per_least = hn::Set(dd, 1.0 / least);
    const VD per_most = hn::Set(dd, -(-1.0 / most));
    const VD error = hn::Set(dd, value_error(static_cast<double>(leaf.r)));
    const VD sign = hn::Set(dd, falling ? -1.0 : 1.0);
    const VD zero = hn::Zero(dd);
    const auto quotient_up = [&](VD f) {
        return hn::Mul(f, hn::IfThenElse(hn::Gt(f, zero), per_least, per_most));
    };
    const VD tolerance = hn::Set(dd, view_.tolerance());
    const VD cell_lo = hn::Set(dd, static_cast<double>(leaf.s) - static_cast<double>(leaf.reach));
    const VD cell_hi = hn::Set(dd, static_cast<double>(leaf.s) + static_cast<double>(leaf.reach));
    for (int slot = 0; slot < slots_; ++slot) {
        proved_[slot] = 0;
        for (int col = 0; col < pixels; col += static_cast<int>(hn::Lanes(dd))) {
            const int i = slot * pixels + col;
            const VD f = hn::Mul(hn::Load(dd, f_double_ + i), sign);
            const VD s = hn::Load(dd, guess_ + i);
            const VD neg_lo = hn::Sub(quotient_up(hn::Add(f, error)), s);
            const VD lo = hn::Neg(neg_lo);
            const VD hi = hn::Add(quotient_up(hn::Sub(error, f)), s);
            VD slope = zero;
            for (int k = 0; k < 3; ++k) {
                slope = hn::MulAdd(hn::Load(dd, gradient_double_[k] + i),
                                   hn::Load(dd, direction_[k] + i), slope);
            }
            const VD newton = hn::Sub(s, hn::Div(f, hn::Mul(slope, sign)));
            hn::Store(lo, dd, lo_ + i);
            hn::Store(hi, dd, hi_ + i);
            hn::Store(hn::Min(hn::Max(newton, lo), hi), dd, next_ + i);
            const auto narrow = hn::Le(hn::Add(hi, neg_lo), tolerance);
            const auto within = hn::And(hn::Ge(lo, cell_lo), hn::Le(hi, cell_hi));
            proved_[slot] |= bits_of(dd, hn::And(narrow, within)) << col;
        }
    }
}

/// The valid rays of a row whose brackets meet their stretches, nearer than what was found before.
template <int pixels>
LaneBits LeafSolver<pixels>::wanted(const Leaf& leaf, int slot) const {
    const hn::Rebind<float, DD> d_narrow;
    const auto pixel = static_cast<std::size_t>((leaf.row + rows_[slot]) * tile_size + leaf.col);
    LaneBits bits = 0;
    for (int col = 0; col < pixels; col += static_cast<int>(hn::Lanes(dd))) {
        const int i = slot * pixels + col;
        const VD from = hn::PromoteTo(dd, hn::Load(d_narrow, from_ + i));
        const VD to = hn::PromoteTo(dd, hn::Load(d_narrow, to_ + i));
        const VD before = hn::LoadU(dd, &found_.depth[pixel + static_cast<std::size_t>(col)]);
        const auto meets =
            hn::And(hn::Ge(hn::Load(dd, hi_ + i), from), hn::Le(hn::Load(dd, lo_ + i), to));
        const auto nearer = hn::Lt(hn::Load(dd, next_ + i), before);
        bits |= bits_of(dd, hn::And(meets, nearer)) << col;
    }
    return bits & valid_[slot];
}

template <int pixels>
void LeafSolver<pixels>::record_row(const Leaf& leaf, int slot) {
    const hn::Rebind<float, DD> d_narrow;
    const auto pixel = static_cast<std::size_t>((leaf.row + rows_[slot]) * tile_size + leaf.col);
    for (int col = 0; col < pixels; col += static_cast<int>(hn::Lanes(dd))) {
        const int i = slot * pixels + col;
        const std::size_t at = pixel + static_cast<std::size_t>(col);
        hn::StoreU(hn::Load(dd, next_ + i), dd, &found_.depth[at]);
        for (std::size_t k = 0; k < 3; ++k) {
            hn::StoreU(hn::DemoteTo(d_narrow, hn::Load(dd, gradient_double_[k] + i)), d_narrow,
                       &found_.gradient[k][at]);
        }
    }
    std::fill_n(&found_.certificate[pixel], pixels, Certificate::Certified);
}

template <int pixels>
void LeafSolver<pixels>::record(const Leaf& leaf, int slot) {
    constexpr LaneBits all = (1U << pixels) - 1U;
    if (leaf.inside && (proved_[slot] & wanted(leaf, slot)) == all) {
        record_row(leaf, slot);
        return;
    }
    const double cell_lo = static_cast<double>(leaf.s) - static_cast<double>(leaf.reach);
    const double cell_hi = static_cast<double>(leaf.s) + static_cast<double>(leaf.reach);
    for (LaneBits bits = valid_[slot]; bits != 0; bits &= bits - 1) {
        const int col = std::countr_zero(bits);
        const int i = slot * pixels + col;
        const double lo = lo_[i];
        const double hi = hi_[i];
        const auto from = static_cast<double>(from_[i]);
        const auto to = static_cast<double>(to_[i]);
        if (hi < from || lo > to) continue;
        const auto pixel = static_cast<std::uint32_t>((leaf.row + rows_[slot]) * tile_size +
                                                      leaf.col + col);
        if (leaf.inside && (proved_[slot] >> col & 1U) != 0) {
            found_.add(pixel, next_[i], Certificate::Certified,
                       {static_cast<float>(gradient_double_[0][i]),
                        static_cast<float>(gradient_double_[1][i]),
                        static_cast<float>(gradient_double_[2][i])});
            continue;
        }
        const bool known = lo <= hi;
        const double ray_from = known ? std::max(from, lo) : from;
        const double ray_to = known ? std::min(to, hi) : to;
        const double guess = std::clamp(known ? next_[i] : guess_[i], ray_from, ray_to);
        roots_.push({pixel, leaf.inside, ray_from, ray_to, cell_lo, cell_hi, guess,
                     static_cast<double>(leaf.slope_lo), static_cast<double>(leaf.slope_hi),
                     static_cast<double>(leaf.r)});
    }
}

template <int pixels>
void LeafSolver<pixels>::solve(const Leaf& leaf) {
    if (!place(leaf)) return;
    make_rays(leaf);
    for (int step = 0; step < most_float_steps; ++step) {
        if (step_in_float() <= small_step_) break;
    }
    evaluate_in_double();
    certify(leaf);
    for (int slot = 0; slot < slots_; ++slot)
        record(leaf, slot);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
