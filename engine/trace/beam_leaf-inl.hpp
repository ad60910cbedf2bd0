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

/// A smooth cell of 8x8 or 4x4 pixels.
struct Leaf {
    int col, row;  ///< first pixel in the tile
    bool inside;   ///< all rays are inside the clip box in the slab
    // f is c + ku x - kv y + kt t + [-e, e] at x pixels right and y below the first pixel, at the
    // depth s + reach t.
    float c, ku, kv, kt, e;
    float s, reach;
    float from, to;            ///< the slab
    float slope_lo, slope_hi;  ///< of df/ds, of one sign
    float r;                   ///< see FormBatchOf
};

/// The rays of a row of pixels in a type: origin and direction at a pixel are `base` and `forward`
/// and what lies across, `row` + `step` x col.
template <class Real>
struct RowRays {
    std::array<Real, 3> base, forward, step;
    Real distance;

    explicit RowRays(const BeamView& view) : distance(static_cast<Real>(view.distance())) {
        for (int k = 0; k < 3; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            base[axis] = static_cast<Real>(view.base()[k]);
            forward[axis] = static_cast<Real>(view.axes().forward[k]);
            step[axis] = static_cast<Real>(view.pixel() * view.axes().right[k]);
        }
    }
    template <class D>
    HWY_INLINE hn::Vec<D> across(D d, std::size_t k, Real row, hn::Vec<D> col) const {
        return hn::MulAdd(col, hn::Set(d, step[k]), hn::Set(d, row));
    }
    template <class D>
    HWY_INLINE hn::Vec<D> direction(D d, std::size_t k, Real row, hn::Vec<D> col) const {
        return hn::Add(across(d, k, row, col), hn::Set(d, forward[k]));
    }
    template <class D>
    HWY_INLINE hn::Vec<D> point(D d, std::size_t k, Real row, hn::Vec<D> col, hn::Vec<D> s) const {
        const hn::Vec<D> aside = across(d, k, row, col);
        const hn::Vec<D> origin = hn::MulAdd(hn::Set(d, distance), aside, hn::Set(d, base[k]));
        return hn::MulAdd(s, hn::Add(aside, hn::Set(d, forward[k])), origin);
    }
};

/// Solves leaves of `pixels` x `pixels` pixels: guesses from the form, Newton's method in float,
/// then one step in double that certifies. What that leaves open goes to the root finder.
template <int pixels>
class LeafSolver {
public:
    LeafSolver(const TraceFrame& frame, const Tile& tile, const BeamView& view, Found<float>& found,
               RootFinder<float>& roots, Counters& counters);
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
    static constexpr hn::Rebind<float, DD> d_narrow{};
    static constexpr int lanes_float = hn::MaxLanes(df);
    static constexpr int lanes_double = hn::MaxLanes(dd);

    /// Stretches of the rays; rows without any are left out. False when there is none.
    bool place(const Leaf& leaf);
    /// The largest step taken, or +inf where one was not a number.
    float step_in_float();
    void evaluate_in_double();
    void certify(const Leaf& leaf);
    /// The rays of a row with roots proved, or that may be there, nearer than what was found.
    [[nodiscard]] LaneBits wanted(const Leaf& leaf, int slot) const;
    /// Hands on the proved roots of one row, all of whose pixels are wanted.
    void record_row(const Leaf& leaf, int slot);
    /// Hands on one row of results, and what they leave open.
    void record(const Leaf& leaf, int slot);
    /// The first pixel of a row, in the tile.
    [[nodiscard]] std::size_t first_pixel(const Leaf& leaf, int row) const {
        return static_cast<std::size_t>((leaf.row + row) * tile_size + leaf.col);
    }
    [[nodiscard]] std::size_t count() const {
        return padded(static_cast<std::size_t>(slots_ * pixels));
    }
    /// Repeats the first row up to a whole batch.
    template <class Real>
    void pad(Real (&columns)[3][items]) const {
        for (std::size_t i = static_cast<std::size_t>(slots_ * pixels); i < count(); ++i) {
            for (auto& column : columns)
                column[i] = column[0];
        }
    }

    const TraceFrame& frame_;
    const Tile& tile_;
    const BeamView& view_;
    Found<float>& found_;
    RootFinder<float>& roots_;
    Counters& counters_;
    RowRays<float> rays_;
    RowRays<double> exact_rays_;
    float small_step_;  ///< a step behind which the next one is below the tolerance

    int slots_ = 0;  ///< rows that have stretches
    int rows_[side];
    LaneBits valid_[side];    ///< of each such row, the rays that have one
    LaneBits proved_[side];   ///< of each such row, the brackets that prove a root
    double across_[3][side];  ///< of each such row, see RowRays
    alignas(64) float from_[items], to_[items], guess_[items];
    alignas(64) float x_[3][items];
    alignas(64) float f_[items];
    alignas(64) float gradient_[3][items];
    alignas(64) double exact_x_[3][items];
    alignas(64) double exact_f_[items];
    alignas(64) double exact_gradient_[3][items];
    alignas(64) double lo_[items], hi_[items], next_[items];  ///< brackets, and roots in them
};

template <int pixels>
LeafSolver<pixels>::LeafSolver(const TraceFrame& frame, const Tile& tile, const BeamView& view,
                               Found<float>& found, RootFinder<float>& roots, Counters& counters)
    : frame_(frame),
      tile_(tile),
      view_(view),
      found_(found),
      roots_(roots),
      counters_(counters),
      rays_(view),
      exact_rays_(view),
      small_step_(static_cast<float>(frame.scene.clip.size() * 0x1p-14)) {}

template <int pixels>
bool LeafSolver<pixels>::place(const Leaf& leaf) {
    const float steepness = std::max(std::abs(leaf.kt), std::numeric_limits<float>::min());
    const float scale = leaf.reach / std::copysign(steepness, leaf.kt);
    const float error =
        leaf.e + 0x1p-10F * static_cast<float>(tile_size) * (std::abs(leaf.ku) + std::abs(leaf.kv));
    const float rounding =
        8 * std::numeric_limits<float>::epsilon() * (std::abs(leaf.s) + leaf.reach);
    const VF radius = hn::Set(df, error * std::abs(scale) + rounding);
    const VF from = hn::Set(df, leaf.from);
    const VF to = hn::Set(df, leaf.to);
    const int cols = std::min(pixels, tile_.cols - leaf.col);
    const int rows = std::min(pixels, tile_.rows - leaf.row);
    slots_ = 0;
    for (int row = 0; row < rows; ++row) {
        const float row_c = leaf.c - leaf.kv * static_cast<float>(row);
        LaneBits valid = 0;
        for (int col = 0; col < pixels; col += lanes_float) {
            const VF x = hn::Iota(df, static_cast<float>(col));
            const VF c = hn::MulAdd(x, hn::Set(df, leaf.ku), hn::Set(df, row_c));
            const VF middle = hn::NegMulAdd(c, hn::Set(df, scale), hn::Set(df, leaf.s));
            const VF ray_from = hn::Max(hn::Sub(middle, radius), from);  // `from` where NaN
            const VF ray_to = hn::Min(hn::Add(middle, radius), to);
            const VF found = hn::LoadU(
                df, &found_.depth[first_pixel(leaf, row) + static_cast<std::size_t>(col)]);
            valid |= bits_of(df, hn::Le(ray_from, hn::Min(ray_to, found))) << col;
            const int at = slots_ * pixels + col;
            hn::Store(ray_from, df, from_ + at);
            hn::Store(ray_to, df, to_ + at);
            hn::Store(hn::Min(hn::Max(middle, ray_from), ray_to), df, guess_ + at);
        }
        valid &= (1U << cols) - 1U;
        if (valid == 0) continue;
        const double u = view_.u(leaf.col);
        const double v = view_.v(leaf.row + row);
        for (int k = 0; k < 3; ++k)
            across_[k][slots_] = u * view_.axes().right[k] + v * view_.axes().up[k];
        rows_[slots_] = row;
        valid_[slots_++] = valid;
    }
    return slots_ > 0;
}

template <int pixels>
float LeafSolver<pixels>::step_in_float() {
    for (int slot = 0; slot < slots_; ++slot) {
        for (int col = 0; col < pixels; col += lanes_float) {
            const int i = slot * pixels + col;
            const VF s = hn::Load(df, guess_ + i);
            const VF x = hn::Iota(df, static_cast<float>(col));
            for (std::size_t k = 0; k < 3; ++k) {
                const auto row = static_cast<float>(across_[k][slot]);
                hn::Store(rays_.point(df, k, row, x, s), df, x_[k] + i);
            }
        }
    }
    pad(x_);
    counters_.value += static_cast<std::uint64_t>(slots_ * pixels);
    frame_.kernel.value({count(),
                         {x_[0], x_[1], x_[2]},
                         frame_.scene.uniforms.points<float>(),
                         f_,
                         {gradient_[0], gradient_[1], gradient_[2]}});
    VF largest = hn::Zero(df);
    for (int slot = 0; slot < slots_; ++slot) {
        for (int col = 0; col < pixels; col += lanes_float) {
            const int i = slot * pixels + col;
            const VF x = hn::Iota(df, static_cast<float>(col));
            VF slope = hn::Zero(df);
            for (std::size_t k = 0; k < 3; ++k) {
                const auto row = static_cast<float>(across_[k][slot]);
                slope = hn::MulAdd(hn::Load(df, gradient_[k] + i), rays_.direction(df, k, row, x),
                                   slope);
            }
            const VF s = hn::Load(df, guess_ + i);
            const VF from = hn::Load(df, from_ + i);
            const VF to = hn::Load(df, to_ + i);
            const VF newton = hn::Sub(s, hn::Div(hn::Load(df, f_ + i), slope));
            const VF next = hn::Min(hn::Max(newton, from), to);  // `from` where NaN
            hn::Store(next, df, guess_ + i);
            const VF step = hn::IfThenElseZero(hn::Le(from, to), hn::Abs(hn::Sub(next, s)));
            largest = hn::Max(largest, step);
        }
    }
    return hn::GetLane(hn::MaxOfLanes(df, largest));
}

template <int pixels>
void LeafSolver<pixels>::evaluate_in_double() {
    for (int slot = 0; slot < slots_; ++slot) {
        for (int col = 0; col < pixels; col += lanes_double) {
            const int i = slot * pixels + col;
            const VD s = hn::PromoteTo(dd, hn::Load(d_narrow, guess_ + i));
            const VD x = hn::Iota(dd, static_cast<double>(col));
            for (std::size_t k = 0; k < 3; ++k)
                hn::Store(exact_rays_.point(dd, k, across_[k][slot], x, s), dd, exact_x_[k] + i);
        }
    }
    pad(exact_x_);
    counters_.value += static_cast<std::uint64_t>(slots_ * pixels);
    frame_.kernel.value(
        ValueBatchOf<double>{count(),
                             {exact_x_[0], exact_x_[1], exact_x_[2]},
                             frame_.scene.uniforms.points<double>(),
                             exact_f_,
                             {exact_gradient_[0], exact_gradient_[1], exact_gradient_[2]}});
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
    const VD tolerance = hn::Set(dd, view_.tolerance());
    const VD cell_lo = hn::Set(dd, static_cast<double>(leaf.s) - static_cast<double>(leaf.reach));
    const VD cell_hi = hn::Set(dd, static_cast<double>(leaf.s) + static_cast<double>(leaf.reach));
    const VD zero = hn::Zero(dd);
    const auto quotient_up = [&](VD f) {
        return hn::Mul(f, hn::IfThenElse(hn::Gt(f, zero), per_least, per_most));
    };
    for (int slot = 0; slot < slots_; ++slot) {
        proved_[slot] = 0;
        for (int col = 0; col < pixels; col += lanes_double) {
            const int i = slot * pixels + col;
            const VD f = hn::Mul(hn::Load(dd, exact_f_ + i), sign);
            const VD s = hn::PromoteTo(dd, hn::Load(d_narrow, guess_ + i));
            const VD neg_lo = hn::Sub(quotient_up(hn::Add(f, error)), s);
            const VD lo = hn::Neg(neg_lo);
            const VD hi = hn::Add(quotient_up(hn::Sub(error, f)), s);
            const VD x = hn::Iota(dd, static_cast<double>(col));
            VD slope = zero;
            for (std::size_t k = 0; k < 3; ++k) {
                slope = hn::MulAdd(hn::Load(dd, exact_gradient_[k] + i),
                                   exact_rays_.direction(dd, k, across_[k][slot], x), slope);
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

template <int pixels>
LaneBits LeafSolver<pixels>::wanted(const Leaf& leaf, int slot) const {
    const std::size_t pixel = first_pixel(leaf, rows_[slot]);
    LaneBits bits = 0;
    for (int col = 0; col < pixels; col += lanes_double) {
        const int i = slot * pixels + col;
        const VD from = hn::PromoteTo(dd, hn::Load(d_narrow, from_ + i));
        const VD to = hn::PromoteTo(dd, hn::Load(d_narrow, to_ + i));
        const VD before = hn::PromoteTo(
            dd, hn::LoadU(d_narrow, &found_.depth[pixel + static_cast<std::size_t>(col)]));
        // True where the bracket is NaN.
        const auto beside =
            hn::Or(hn::Lt(hn::Load(dd, hi_ + i), from), hn::Gt(hn::Load(dd, lo_ + i), to));
        const auto hidden = hn::Gt(hn::Load(dd, lo_ + i), before);
        bits |= bits_of(dd, hn::Not(hn::Or(beside, hidden))) << col;
    }
    return bits & valid_[slot];
}

template <int pixels>
void LeafSolver<pixels>::record_row(const Leaf& leaf, int slot) {
    const std::size_t pixel = first_pixel(leaf, rows_[slot]);
    for (int col = 0; col < pixels; col += lanes_double) {
        const int i = slot * pixels + col;
        const std::size_t at = pixel + static_cast<std::size_t>(col);
        hn::StoreU(hn::DemoteTo(d_narrow, hn::Load(dd, next_ + i)), d_narrow, &found_.depth[at]);
        for (std::size_t k = 0; k < 3; ++k) {
            hn::StoreU(hn::DemoteTo(d_narrow, hn::Load(dd, exact_gradient_[k] + i)), d_narrow,
                       &found_.gradient[k][at]);
        }
    }
    std::fill_n(&found_.certificate[pixel], pixels, Certificate::Certified);
}

template <int pixels>
void LeafSolver<pixels>::record(const Leaf& leaf, int slot) {
    constexpr LaneBits all = (1U << pixels) - 1U;
    const LaneBits rays = wanted(leaf, slot);
    const LaneBits proved = leaf.inside ? proved_[slot] & rays : 0;
    if (proved == all) {
        record_row(leaf, slot);
        return;
    }
    const std::size_t pixel = first_pixel(leaf, rows_[slot]);
    for (LaneBits bits = proved; bits != 0; bits &= bits - 1) {
        const int col = std::countr_zero(bits);
        const int i = slot * pixels + col;
        found_.add(
            pixel + static_cast<std::size_t>(col), next_[i], Certificate::Certified,
            {static_cast<float>(exact_gradient_[0][i]), static_cast<float>(exact_gradient_[1][i]),
             static_cast<float>(exact_gradient_[2][i])});
    }
    const double cell_lo = static_cast<double>(leaf.s) - static_cast<double>(leaf.reach);
    const double cell_hi = static_cast<double>(leaf.s) + static_cast<double>(leaf.reach);
    for (LaneBits bits = rays & ~proved; bits != 0; bits &= bits - 1) {
        const int col = std::countr_zero(bits);
        const int i = slot * pixels + col;
        const bool known = lo_[i] <= hi_[i];
        const auto from = static_cast<double>(from_[i]);
        const auto to = static_cast<double>(to_[i]);
        const double ray_from = known ? std::max(from, lo_[i]) : from;
        const double ray_to = known ? std::min(to, hi_[i]) : to;
        const double guess = known ? next_[i] : static_cast<double>(guess_[i]);
        roots_.push({static_cast<std::uint32_t>(pixel) + static_cast<std::uint32_t>(col),
                     leaf.inside, ray_from, ray_to, cell_lo, cell_hi,
                     std::clamp(guess, ray_from, ray_to), static_cast<double>(leaf.slope_lo),
                     static_cast<double>(leaf.slope_hi), static_cast<double>(leaf.r)});
    }
}

template <int pixels>
void LeafSolver<pixels>::solve(const Leaf& leaf) {
    if (!place(leaf)) return;
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
