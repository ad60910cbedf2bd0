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
template <class Real>
struct Leaf {
    int col, row;  ///< first pixel in the tile
    bool inside;   ///< all rays are inside the clip box in the slab
    // f is c + ku x - kv y + kt t + [-e, e] at x pixels right and y below the first pixel, at the
    // depth s + reach t.
    Real c, ku, kv, kt, e;
    Real s, reach;
    Real from, to;            ///< the slab
    Real slope_lo, slope_hi;  ///< of d/ds, of one sign
    Real r;                   ///< see FormBatchOf
    const Kernel* kernel;     ///< of f in the cell
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

/// Solves leaves of `pixels` x `pixels` pixels: guesses from the form, Newton's method in the
/// cells' type, then one step in double that certifies. What that leaves open goes to the root
/// finder.
template <class Real, int pixels>
class LeafSolver {
public:
    LeafSolver(const TraceFrame& frame, const Tile& tile, const BeamView& view, Found<Real>& found,
               RootFinder<Real>& roots, Counters& counters);
    void solve(const Leaf<Real>& leaf);

private:
    static constexpr std::size_t side = pixels;
    static constexpr std::size_t items = side * side;
    static constexpr int most_steps = 4;
    using D = hn::CappedTag<Real, side>;
    using DD = hn::CappedTag<double, 4>;
    using V = hn::Vec<D>;
    using VD = hn::Vec<DD>;
    static constexpr D d{};
    static constexpr DD dd{};
    static constexpr hn::Rebind<Real, DD> d_narrow{};
    static constexpr hn::Rebind<float, DD> d_float{};
    static constexpr int lanes = hn::MaxLanes(d);
    static constexpr int lanes_double = hn::MaxLanes(dd);

    /// Stretches of the rays; rows without any are left out. False when there is none.
    bool place(const Leaf<Real>& leaf);
    /// The largest step taken, or +inf where one was not a number.
    Real improve();
    void evaluate_in_double();
    void certify(const Leaf<Real>& leaf);
    /// The rays of a row with roots proved, or that may be there, nearer than what was found.
    [[nodiscard]] LaneBits wanted(const Leaf<Real>& leaf, int slot) const;
    /// Hands on the proved roots of one row, all of whose pixels are wanted.
    void record_row(const Leaf<Real>& leaf, int slot);
    /// Hands on one row of results, and what they leave open.
    void record(const Leaf<Real>& leaf, int slot);
    static VD wide(const Real* from) {
        if constexpr (std::is_same_v<Real, float>) {
            return hn::PromoteTo(dd, hn::LoadU(d_narrow, from));
        } else {
            return hn::LoadU(dd, from);
        }
    }
    static void store_depths(VD s, Real* to) {
        if constexpr (std::is_same_v<Real, float>) {
            hn::StoreU(hn::DemoteTo(d_narrow, s), d_narrow, to);
        } else {
            hn::StoreU(s, dd, to);
        }
    }
    /// The first pixel of a row, in the tile.
    [[nodiscard]] std::size_t first_pixel(const Leaf<Real>& leaf, int row) const {
        return static_cast<std::size_t>((leaf.row + row) * tile_size + leaf.col);
    }
    [[nodiscard]] std::size_t count() const {
        return padded(static_cast<std::size_t>(slots_ * pixels));
    }
    /// Repeats the first row up to a whole batch.
    template <class Number>
    void pad(Number (&columns)[3][items]) const {
        for (std::size_t i = static_cast<std::size_t>(slots_ * pixels); i < count(); ++i) {
            for (auto& column : columns)
                column[i] = column[0];
        }
    }

    const TraceFrame& frame_;
    const Tile& tile_;
    const BeamView& view_;
    Found<Real>& found_;
    RootFinder<Real>& roots_;
    Counters& counters_;
    RowRays<Real> rays_;
    RowRays<double> exact_rays_;
    const Kernel* kernel_ = nullptr;  ///< of the leaf at work
    Real small_step_;                 ///< a step behind which the next one is below the tolerance

    int slots_ = 0;  ///< rows that have stretches
    int rows_[side];
    LaneBits valid_[side];    ///< of each such row, the rays that have one
    LaneBits proved_[side];   ///< of each such row, the brackets that prove a root
    double across_[3][side];  ///< of each such row, see RowRays
    alignas(64) Real from_[items], to_[items], guess_[items];
    alignas(64) Real x_[3][items];
    alignas(64) Real f_[items];
    alignas(64) Real gradient_[3][items];
    alignas(64) double exact_x_[3][items];
    alignas(64) double exact_f_[items];
    alignas(64) double exact_gradient_[3][items];
    alignas(64) double lo_[items], hi_[items], next_[items];  ///< brackets, and roots in them
};

template <class Real, int pixels>
LeafSolver<Real, pixels>::LeafSolver(const TraceFrame& frame, const Tile& tile,
                                     const BeamView& view, Found<Real>& found,
                                     RootFinder<Real>& roots, Counters& counters)
    : frame_(frame),
      tile_(tile),
      view_(view),
      found_(found),
      roots_(roots),
      counters_(counters),
      rays_(view),
      exact_rays_(view),
      small_step_(static_cast<Real>(0x1p-14 * view.extent())) {}

template <class Real, int pixels>
bool LeafSolver<Real, pixels>::place(const Leaf<Real>& leaf) {
    const Real steepness = std::max(std::abs(leaf.kt), std::numeric_limits<Real>::min());
    const Real scale = leaf.reach / std::copysign(steepness, leaf.kt);
    const Real error =
        leaf.e + static_cast<Real>(0x1p-10 * tile_size) * (std::abs(leaf.ku) + std::abs(leaf.kv));
    const Real rounding =
        8 * std::numeric_limits<Real>::epsilon() * (std::abs(leaf.s) + leaf.reach);
    const V radius = hn::Set(d, error * std::abs(scale) + rounding);
    const V from = hn::Set(d, leaf.from);
    const V to = hn::Set(d, leaf.to);
    const int cols = std::min(pixels, tile_.cols - leaf.col);
    const int rows = std::min(pixels, tile_.rows - leaf.row);
    slots_ = 0;
    for (int row = 0; row < rows; ++row) {
        const Real row_c = leaf.c - leaf.kv * static_cast<Real>(row);
        LaneBits valid = 0;
        for (int col = 0; col < pixels; col += lanes) {
            const V x = hn::Iota(d, static_cast<Real>(col));
            const V c = hn::MulAdd(x, hn::Set(d, leaf.ku), hn::Set(d, row_c));
            const V middle = hn::NegMulAdd(c, hn::Set(d, scale), hn::Set(d, leaf.s));
            const V ray_from = hn::Max(hn::Sub(middle, radius), from);  // `from` where NaN
            const V ray_to = hn::Min(hn::Add(middle, radius), to);
            const V found =
                hn::LoadU(d, &found_.depth[first_pixel(leaf, row) + static_cast<std::size_t>(col)]);
            valid |= bits_of(d, hn::Le(ray_from, hn::Min(ray_to, found))) << col;
            const int at = slots_ * pixels + col;
            hn::Store(ray_from, d, from_ + at);
            hn::Store(ray_to, d, to_ + at);
            hn::Store(hn::Min(hn::Max(middle, ray_from), ray_to), d, guess_ + at);
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

template <class Real, int pixels>
Real LeafSolver<Real, pixels>::improve() {
    for (int slot = 0; slot < slots_; ++slot) {
        for (int col = 0; col < pixels; col += lanes) {
            const int i = slot * pixels + col;
            const V s = hn::Load(d, guess_ + i);
            const V x = hn::Iota(d, static_cast<Real>(col));
            for (std::size_t k = 0; k < 3; ++k) {
                const auto row = static_cast<Real>(across_[k][slot]);
                hn::Store(rays_.point(d, k, row, x, s), d, x_[k] + i);
            }
        }
    }
    pad(x_);
    counters_.value += static_cast<std::uint64_t>(slots_ * pixels);
    kernel_->value(ValueBatchOf<Real>{count(),
                                      {x_[0], x_[1], x_[2]},
                                      frame_.scene.uniforms.template points<Real>(),
                                      f_,
                                      {gradient_[0], gradient_[1], gradient_[2]}});
    V largest = hn::Zero(d);
    for (int slot = 0; slot < slots_; ++slot) {
        for (int col = 0; col < pixels; col += lanes) {
            const int i = slot * pixels + col;
            const V x = hn::Iota(d, static_cast<Real>(col));
            V slope = hn::Zero(d);
            for (std::size_t k = 0; k < 3; ++k) {
                const auto row = static_cast<Real>(across_[k][slot]);
                slope =
                    hn::MulAdd(hn::Load(d, gradient_[k] + i), rays_.direction(d, k, row, x), slope);
            }
            const V s = hn::Load(d, guess_ + i);
            const V from = hn::Load(d, from_ + i);
            const V to = hn::Load(d, to_ + i);
            const V newton = hn::Sub(s, hn::Div(hn::Load(d, f_ + i), slope));
            const V next = hn::Min(hn::Max(newton, from), to);  // `from` where NaN
            hn::Store(next, d, guess_ + i);
            const V step = hn::IfThenElseZero(hn::Le(from, to), hn::Abs(hn::Sub(next, s)));
            largest = hn::Max(largest, step);
        }
    }
    return hn::GetLane(hn::MaxOfLanes(d, largest));
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::evaluate_in_double() {
    for (int slot = 0; slot < slots_; ++slot) {
        for (int col = 0; col < pixels; col += lanes_double) {
            const int i = slot * pixels + col;
            const VD s = wide(guess_ + i);
            const VD x = hn::Iota(dd, static_cast<double>(col));
            for (std::size_t k = 0; k < 3; ++k)
                hn::Store(exact_rays_.point(dd, k, across_[k][slot], x, s), dd, exact_x_[k] + i);
        }
    }
    pad(exact_x_);
    counters_.value += static_cast<std::uint64_t>(slots_ * pixels);
    kernel_->value(
        ValueBatchOf<double>{count(),
                             {exact_x_[0], exact_x_[1], exact_x_[2]},
                             frame_.scene.uniforms.points<double>(),
                             exact_f_,
                             {exact_gradient_[0], exact_gradient_[1], exact_gradient_[2]}});
}

/// The interval Newton operator, see RootFinder::step_in_double; both ends rounded outward.
template <class Real, int pixels>
void LeafSolver<Real, pixels>::certify(const Leaf<Real>& leaf) {
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
            const VD s = wide(guess_ + i);
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

template <class Real, int pixels>
LaneBits LeafSolver<Real, pixels>::wanted(const Leaf<Real>& leaf, int slot) const {
    const std::size_t pixel = first_pixel(leaf, rows_[slot]);
    LaneBits bits = 0;
    for (int col = 0; col < pixels; col += lanes_double) {
        const int i = slot * pixels + col;
        const VD from = wide(from_ + i);
        const VD to = wide(to_ + i);
        const VD before = wide(&found_.depth[pixel + static_cast<std::size_t>(col)]);
        // True where the bracket is NaN.
        const auto beside =
            hn::Or(hn::Lt(hn::Load(dd, hi_ + i), from), hn::Gt(hn::Load(dd, lo_ + i), to));
        const auto hidden = hn::Gt(hn::Load(dd, lo_ + i), before);
        bits |= bits_of(dd, hn::Not(hn::Or(beside, hidden))) << col;
    }
    return bits & valid_[slot];
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::record_row(const Leaf<Real>& leaf, int slot) {
    const std::size_t pixel = first_pixel(leaf, rows_[slot]);
    for (int col = 0; col < pixels; col += lanes_double) {
        const int i = slot * pixels + col;
        const std::size_t at = pixel + static_cast<std::size_t>(col);
        store_depths(hn::Load(dd, next_ + i), &found_.depth[at]);
        for (std::size_t k = 0; k < 3; ++k) {
            hn::StoreU(hn::DemoteTo(d_float, hn::Load(dd, exact_gradient_[k] + i)), d_float,
                       found_.gradients(k, at));
        }
    }
    std::fill_n(found_.certificates(pixel), pixels, Certificate::Certified);
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::record(const Leaf<Real>& leaf, int slot) {
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
                     static_cast<double>(leaf.slope_hi), static_cast<double>(leaf.r), leaf.kernel});
    }
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::solve(const Leaf<Real>& leaf) {
    if (!place(leaf)) return;
    kernel_ = leaf.kernel;
    for (int step = 0; step < most_steps; ++step) {
        if (improve() <= small_step_) break;
    }
    evaluate_in_double();
    certify(leaf);
    for (int slot = 0; slot < slots_; ++slot)
        record(leaf, slot);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
