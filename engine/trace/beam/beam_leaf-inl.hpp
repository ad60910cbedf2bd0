// The roots of a small tile on which f is monotone along the rays: all its pixels at once. How
// they are certified: beam_leaf_certify-inl.hpp; whole pixels: beam_leaf_cover-inl.hpp.
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
#include "engine/trace/tile_costs.hpp"

#include <optional>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Solves leaves of `pixels` x `pixels` pixels: guesses from the forms, Newton's method in the
/// cells' type, then one value in double that certifies. What that leaves open goes to the root
/// finder.
template <class Real, int pixels>
class LeafSolver {
public:
    LeafSolver(const TraceFrame& frame, const Tile& tile, const TileRays& rays,
               NearestRoots<Real>& nearest, RootFinder<Real>& roots, Counters& counters)
        : frame_(frame),
          tile_(tile),
          rays_(rays),
          nearest_(nearest),
          roots_(roots),
          counters_(counters) {}

    /// One more leaf, behind those that were added before of the same pixels.
    void add(const Leaf<Real>& leaf) {
        if (run_ && run_->continues_with(leaf)) {
            run_->add(leaf);
            set_brackets<false>(leaf);
            if (nearest_.cover.wanted()) add_cover<false>(leaf);
        } else {
            solve();
            run_.emplace(leaf);
            set_brackets<true>(leaf);
            if (nearest_.cover.wanted()) add_cover<true>(leaf);
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

    /// Where a leaf's linear part vanishes on rays, widened by its error.
    struct ZeroBand {
        V radius;    ///< how far roots may be from there
        V from, to;  ///< of the leaf
        V by_col;
        Real s, c, kv, scale;

        /// `aside`: how far rays may be from the pixels' centres, in pixels.
        HWY_INLINE ZeroBand(const Leaf<Real>& leaf, Real aside)
            : from(hn::Set(d, leaf.from)),
              to(hn::Set(d, leaf.to)),
              s(leaf.s),
              c(leaf.c),
              kv(leaf.kv) {
            constexpr Real lost = 0x1p-10 * tile_size;  // by rounding, in pixels
            const Real steepness = std::max(std::abs(leaf.kt), std::numeric_limits<Real>::min());
            scale = leaf.s_radius / std::copysign(steepness, leaf.kt);
            const Real error = leaf.e + (aside + lost) * (std::abs(leaf.ku) + std::abs(leaf.kv));
            const Real rounding =
                8 * std::numeric_limits<Real>::epsilon() * (std::abs(leaf.s) + leaf.s_radius);
            radius = hn::Set(d, error * std::abs(scale) + rounding);
            by_col = hn::Set(d, leaf.ku * scale);
        }
        /// On the rays of a row's pixels from `col` on.
        [[nodiscard]] HWY_INLINE V middle(int col, int row) const {
            const Real first = s - (c - kv * static_cast<Real>(row)) * scale;
            return hn::NegMulAdd(hn::Iota(d, static_cast<Real>(col)), by_col, hn::Set(d, first));
        }
    };

    /// Conclusions of the interval Newton operator on a vector of rays.
    struct Judged {
        M proved;  ///< there is a root, and its bracket is narrow
        M wanted;  ///< a root may be where it is looked for
        M wide;    ///< the bracket is not narrow: more steps may help
        V lo, hi;  ///< where the root is
        V s;       ///< near it
    };

    /// Sets where roots may be on a leaf's rays, empty where from > to; joined to the brackets of
    /// leaves before.
    template <bool first_of_run>
    void set_brackets(const Leaf<Real>& leaf);
    /// Sets, or joins, where roots may be on all rays of the leaf's pixels.
    template <bool first_of_run>
    void add_cover(const Leaf<Real>& leaf);
    /// Columns of which all that may hold roots is inside the clip box, or outside.
    struct Places {
        M inside, outside;
    };
    [[nodiscard]] Places places(int first_col, int rows) const;
    /// Marks what is known of the whole pixels.
    void mark_cover();
    /// Whether any pixel was marked, and any that no sheet is known to cover.
    struct Marked {
        bool any = false, open = false;
    };
    /// Marks the pixels of a vector of columns; `is_first`: nothing is marked in their block.
    Marked mark_columns(int first_col, int rows, bool is_first);
    /// Leaves out rows without brackets; false when none is left.
    bool compact();
    void find_roots();
    /// Newton's method in the cells' type.
    void take_steps();
    /// Counts so many evaluations of f for each pixel at work.
    void count_values(int each);
    /// f in double, after so many more steps.
    void evaluate(int steps);
    /// Certifies roots and leaves out rows in which no more steps would help; brackets of those
    /// that are open, and the last time all brackets that are not proved, go to the root finder.
    void certify(bool last);
    /// Makes a row the next of those that remain.
    void keep_row(int slot);
    /// Applies the interval Newton operator to the rays from `pixel` on, item i.
    [[nodiscard]] HWY_INLINE Judged judge(std::size_t pixel, int i) const;
    /// Takes proved roots at `s` that are the nearest so far.
    HWY_INLINE void record(std::size_t pixel, int i, M proved, V s);
    /// Leaves the gradients of these rays to be found: Newton's method may have seen another
    /// branch.
    void add_pending(std::size_t pixel, int i, LaneBits rays);
    /// Hands the brackets of these rays to the root finder.
    void push_open_brackets(std::size_t pixel, int i, const Judged& judged, LaneBits rays);
    /// Drops roots that are surely outside the clip box; those that may be are not proved.
    [[nodiscard]] Judged clipped(int i, Judged judged) const;
    /// Upper bounds of x and of -x in the cells' type.
    HWY_INLINE static std::pair<V, V> bounds_of(const double* x);
    /// Stores the gradients of the rays in the mask.
    void store_gradients(std::size_t pixel, int i, M rays) {
        if constexpr (std::is_same_v<Real, float>) {
            // A masked store costs more than these on many processors.
            for (std::size_t k = 0; k < 3; ++k) {
                float* const to = nearest_.gradients(k, pixel);
                const V before = hn::LoadU(d, to);
                hn::StoreU(hn::IfThenElse(rays, hn::Load(d, newton_.gradient[k] + i), before), d,
                           to);
            }
        } else {
            for (LaneBits bits = bits_of(d, rays); bits != 0; bits &= bits - 1) {
                const int at = i + std::countr_zero(bits);
                const auto gradient = float_gradient(
                    {newton_.gradient[0][at], newton_.gradient[1][at], newton_.gradient[2][at]});
                for (std::size_t k = 0; k < 3; ++k)
                    nearest_.gradients(k, pixel)[at - i] = gradient[k];
            }
        }
    }
    /// The end of a bracket that is not wanted.
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
    const TileRays& rays_;
    NearestRoots<Real>& nearest_;
    RootFinder<Real>& roots_;
    Counters& counters_;
    std::optional<LeafRun<Real>> run_;

    int slots_ = 0;  ///< rows that have brackets
    int rows_[side];
    Real error_ = 0;      ///< of f in double
    Real tolerance_ = 0;  ///< of brackets
    Real per_least_ = 0;  ///< not below 1 / |df/ds|
    Real per_most_ = 0;   ///< not above it
    NewtonRays<Real, items> newton_;
    alignas(64) Real cover_from_[items], cover_to_[items];
};

template <class Real, int pixels>
template <bool first_of_run>
void LeafSolver<Real, pixels>::set_brackets(const Leaf<Real>& leaf) {
    const ZeroBand sheet(leaf, Real{0});
    for (int row = 0; row < pixels; ++row) {
        for (int col = 0; col < pixels; col += lanes) {
            const int i = row * pixels + col;
            const V middle = sheet.middle(col, row);
            const V ray_from = hn::Max(hn::Sub(middle, sheet.radius), sheet.from);  // `from` if NaN
            const V ray_to = hn::Min(hn::Add(middle, sheet.radius), sheet.to);
            const V guess = hn::Min(hn::Max(middle, ray_from), ray_to);
            if constexpr (first_of_run) {
                hn::Store(ray_from, d, newton_.from + i);
                hn::Store(ray_to, d, newton_.to + i);
                hn::Store(guess, d, newton_.guess + i);
                continue;
            }
            // Join with the leaves before.
            const M some = hn::Le(ray_from, ray_to);
            const V before_from = hn::Load(d, newton_.from + i);
            const V before_to = hn::Load(d, newton_.to + i);
            const M only = hn::AndNot(hn::Le(before_from, before_to), some);
            const M better = hn::Or(only, hn::And(some, hn::Ge(middle, sheet.from)));
            const auto join = [&](V before, V both, V alone) {
                return hn::IfThenElse(only, alone, hn::IfThenElse(some, both, before));
            };
            hn::Store(join(before_from, hn::Min(before_from, ray_from), ray_from), d,
                      newton_.from + i);
            hn::Store(join(before_to, hn::Max(before_to, ray_to), ray_to), d, newton_.to + i);
            hn::Store(hn::IfThenElse(better, guess, hn::Load(d, newton_.guess + i)), d,
                      newton_.guess + i);
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
            const V from = hn::Load(d, newton_.from + in);
            const V to = hn::Load(d, newton_.to + in);
            const V before = hn::LoadU(d, &nearest_.s[pixel + static_cast<std::size_t>(col)]);
            const M in_tile =
                hn::FirstN(d, static_cast<std::size_t>(std::clamp(cols - col, 0, lanes)));
            const M valid = hn::And(in_tile, hn::Le(from, hn::Min(to, before)));
            any = hn::Or(any, valid);
            hn::Store(from, d, newton_.from + out);
            hn::Store(hn::IfThenElse(valid, to, nothing()), d, newton_.to + out);
            hn::Store(hn::Load(d, newton_.guess + in), d, newton_.guess + out);
        }
        if (hn::AllFalse(d, any)) continue;
        for (int col = 0; col < pixels; ++col) {
            newton_.col[slots_ * pixels + col] = from_middle(run_->col + col);
            newton_.row[slots_ * pixels + col] = from_middle(run_->row + row);
        }
        rows_[slots_++] = row;
    }
    return slots_ > 0;
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::count_values(int each) {
    counters_.value += static_cast<std::size_t>(each) * used();
    for (int slot = 0; counters_.costs != nullptr && slot < slots_; ++slot)
        counters_.costs->add(run_->col, run_->row + rows_[slot], pixels, 1, each * pixels);
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::take_steps() {
    pad(newton_.from);
    pad(newton_.to);
    pad(newton_.guess);
    pad(newton_.col);
    pad(newton_.row);
    count_values(2);
    newton_.take_steps(frame_, rays_, *run_->kernel, count(), most_steps);
    for (std::size_t i = 0; i < count(); ++i)
        newton_.s[i] = static_cast<double>(newton_.guess[i]);
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::evaluate(int steps) {
    count_values(1 + steps);
    // The slopes hold between lo and hi, and with them what certify() concludes.
    newton_.evaluate(frame_, rays_, *run_->kernel, count(), steps, static_cast<double>(run_->lo),
                     static_cast<double>(run_->hi));
}

template <class Real, int pixels>
void LeafSolver<Real, pixels>::solve() {
    if (!run_) return;
    if (nearest_.cover.wanted()) mark_cover();
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
    tolerance_ = static_cast<Real>(rays_.tolerance());
    take_steps();
    evaluate(1);
    certify(false);
    if (slots_ == 0) return;
    pad(newton_.col);
    pad(newton_.row);
    evaluate(1);
    certify(true);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
