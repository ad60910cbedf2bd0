// Roots on rays where f is known to be monotone: Newton's method in double, with certificates.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_ROOTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_ROOTS_INL
#undef ZEROSET_BEAM_ROOTS_INL
#else
#define ZEROSET_BEAM_ROOTS_INL
#endif

#include "engine/trace/beam/beam_cells-inl.hpp"
#include "engine/trace/simd/bit_bytes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

constexpr std::size_t tile_pixels = static_cast<std::size_t>(tile_size) * tile_size;

/// What is known of the tile's rays so far, in the type of its cells.
template <class Real>
class Found {
public:
    static constexpr Real none = std::numeric_limits<Real>::infinity();

    /// Begins a tile whose certificates and gradients go to `hits`, which is clear. What is not
    /// wanted of its rays is behind a root that `end` takes away.
    void begin(TileHits& hits, const Tile& tile, const BeamView& view) {
        if constexpr (std::is_same_v<Real, float>) {
            depth = hits.depth.data();
        } else {
            own_.assign(tile_pixels, none);
            depth = own_.data();
        }
        any_ = false;
        hits_ = &hits;
        pending.clear();
        limits_.clear();
        if (tile.limits == nullptr) return;
        for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel)
            depth[pixel] = upper_end(Real{}, view.limit(pixel));
        limits_.assign(depth, depth + tile_pixels);
    }
    void end() {
        for (std::size_t pixel = 0; pixel < limits_.size(); ++pixel) {
            if (depth[pixel] == limits_[pixel]) depth[pixel] = none;
        }
    }
    /// A root at s, if it is the nearest so far; whether it is.
    bool add(std::size_t pixel, double s, Certificate known, const std::array<float, 3>& slope) {
        if (!(s < static_cast<double>(depth[pixel]))) return false;
        any_ = true;
        depth[pixel] = static_cast<Real>(s);
        hits_->certificate[pixel] = known;
        for (std::size_t k = 0; k < 3; ++k)
            hits_->gradient[k][pixel] = slope[k];
        return true;
    }
    /// The same, with no gradient yet.
    void add_pending(std::uint32_t pixel, double s, Certificate known, Trend trend) {
        if (add(pixel, s, known, {})) pending.push_back({pixel, s, trend});
    }
    /// Certified roots of those of `most` pixels from `pixel` on whose bits are set, whose depths
    /// and gradients are written to `depth` and `gradients`.
    template <std::size_t most>
    void certify(std::size_t pixel, LaneBits bits) {
        static_assert(most <= 8);
        any_ = true;
        Certificate* const known = &hits_->certificate[pixel];
        const std::uint64_t bytes = bytes_of_bits(bits);
        std::uint64_t all = 0;
        std::memcpy(&all, known, most);
        constexpr auto certified = static_cast<std::uint64_t>(Certificate::Certified);
        all = (all & ~bytes) | (bytes & (certified * 0x0101010101010101U));
        std::memcpy(known, &all, most);
    }
    /// The same, for all of `most` pixels.
    template <std::size_t most>
    void certify(std::size_t pixel) {
        any_ = true;
        std::memset(&hits_->certificate[pixel], static_cast<int>(Certificate::Certified), most);
    }
    float* gradients(std::size_t axis, std::size_t pixel) { return &hits_->gradient[axis][pixel]; }
    [[nodiscard]] bool any() const { return any_; }

    /// s of the nearest root of each pixel, in rows of tile_size; +inf: none. In float it stands
    /// where the distances from the eye are wanted.
    Real* depth = nullptr;
    /// Roots whose gradients are not known, or not for sure.
    struct Pending {
        std::uint32_t pixel;
        double s;
        Trend trend;
    };
    std::vector<Pending> pending;

private:
    bool any_ = false;
    std::vector<Real> own_;     ///< depths that have no place in the hits
    std::vector<Real> limits_;  ///< what `depth` began with, empty: with `none`
    TileHits* hits_ = nullptr;
};

/// A stretch of a ray on which f is continuous and monotone, and so has at most one root.
struct Stretch {
    std::uint32_t pixel;        ///< index in the tile, in rows of tile_size
    bool inside;                ///< surely inside the clip box
    double from, to;            ///< where the root is looked for
    double lo, hi;              ///< where the slope holds; not narrower
    double guess;               ///< in [from, to]
    double slope_lo, slope_hi;  ///< of df/ds, of one sign
    double r;                   ///< see FormBatchOf
    const Kernel* kernel;       ///< of f in this part of the ray
    bool kinked;                ///< f may have a kink on it
    bool again;                 ///< what is not proved is left to RootFinder::take_open

    [[nodiscard]] Trend trend() const { return slope_hi < 0 ? Trend::Falling : Trend::Rising; }
};

/// A root that may be there: neither proved nor disproved by Newton's method.
struct Doubt {
    std::uint32_t pixel;
    double from, to;
    const Kernel* kernel;
};

/// How far f is off where it was evaluated in double; `r`: see FormBatchOf.
inline double value_error(double r) {
    return std::numeric_limits<double>::epsilon() * (1.0 + 0x1p-20) * r;
}

/// Solves stretches in batches: Newton's method in the type of the tile's cells, `Real`, then in
/// double. A batch's stretches have the same kernel.
template <class Real>
class RootFinder {
public:
    RootFinder(const TraceFrame& frame, const BeamView& view, Found<Real>& found,
               Counters& counters)
        : frame_(frame), view_(view), found_(found), counters_(counters) {}

    void push(const Stretch& stretch) {
        if (size_ > 0 && stretches_[0].kernel != stretch.kernel) solve();
        stretches_[size_++] = stretch;
        if (size_ == capacity) solve();
    }
    /// Works off what has been pushed.
    void solve();
    /// Stretches on which Newton's method proved nothing.
    std::vector<Stretch> take_open() { return std::exchange(open_, {}); }
    /// Roots that may be there, where nothing more can be done along the ray.
    std::vector<Doubt> take_doubts() { return std::exchange(doubts_, {}); }

private:
    static constexpr std::size_t capacity = 256;
    static constexpr int first_steps = 4;  ///< at most
    static constexpr int most_steps = 40;

    void take_first_steps();
    void evaluate();
    /// One step of Newton's method in double: a help only.
    void refine();
    /// One step of each stretch; keeps those that are not finished.
    void step(bool last);
    void finish(std::size_t i, double lo, double hi, double s, bool proved);
    void add(std::size_t i, double s, Certificate known);

    const TraceFrame& frame_;
    const BeamView& view_;
    Found<Real>& found_;
    Counters& counters_;
    std::size_t size_ = 0;
    std::array<Stretch, capacity> stretches_;
    std::vector<Stretch> open_;
    std::vector<Doubt> doubts_;
    alignas(64) float col_[capacity], row_[capacity];
    alignas(64) Real from_[capacity], to_[capacity], guess_[capacity];
    alignas(64) Real gradient_[3][capacity], per_slope_[capacity];
    alignas(64) float float_per_slope_[capacity];
    alignas(64) double s_[capacity], f_[capacity];
};

/// Closer guesses, and the slopes there: a help only, nothing rests on them.
template <class Real>
void RootFinder<Real>::take_first_steps() {
    const std::size_t count = padded(size_, stretches_[0].kernel->lane_multiple);
    for (std::size_t i = 0; i < count; ++i) {
        const Stretch& stretch = stretches_[i < size_ ? i : 0];
        col_[i] = from_middle(static_cast<int>(stretch.pixel % tile_size));
        row_[i] = from_middle(static_cast<int>(stretch.pixel / tile_size));
        from_[i] = static_cast<Real>(stretch.from);
        to_[i] = static_cast<Real>(stretch.to);
        guess_[i] = static_cast<Real>(stretch.guess);
    }
    counters_.value += 2 * size_;
    stretches_[0].kernel->newton(NewtonBatchOf<Real>{count,
                                                     col_,
                                                     row_,
                                                     from_,
                                                     to_,
                                                     view_.rays<Real>(),
                                                     frame_.scene.uniforms.template points<Real>(),
                                                     static_cast<Real>(view_.small_step()),
                                                     first_steps - 1,
                                                     guess_,
                                                     {gradient_[0], gradient_[1], gradient_[2]},
                                                     per_slope_});
    for (std::size_t i = 0; i < size_; ++i) {
        Stretch& stretch = stretches_[i];
        stretch.guess = std::clamp(static_cast<double>(guess_[i]), stretch.from, stretch.to);
    }
}

template <class Real>
void RootFinder<Real>::evaluate() {
    const std::size_t count = padded(size_, stretches_[0].kernel->lane_multiple);
    for (std::size_t i = 0; i < count; ++i) {
        s_[i] = stretches_[i < size_ ? i : 0].guess;
        float_per_slope_[i] = static_cast<float>(per_slope_[i]);
    }
    counters_.value += size_;
    stretches_[0].kernel->ray_value(RayValueBatch{count, col_, row_, float_per_slope_, 0, 0.0, 0.0,
                                                  s_, view_.rays<double>(),
                                                  frame_.scene.uniforms.points<double>(), f_});
}

template <class Real>
void RootFinder<Real>::refine() {
    for (std::size_t i = 0; i < size_; ++i) {
        Stretch& stretch = stretches_[i];
        const double newton = stretch.guess - f_[i] * static_cast<double>(per_slope_[i]);
        const double above = newton > stretch.from ? newton : stretch.from;  // `from` where NaN
        stretch.guess = std::min(above, stretch.to);
    }
}

/// A root in [lo, hi], or one that may be there.
template <class Real>
void RootFinder<Real>::finish(std::size_t i, double lo, double hi, double s, bool proved) {
    const Stretch& stretch = stretches_[i];
    if (!stretch.inside) {
        const DepthRange box = view_.depths(view_.u(stretch.pixel % tile_size),
                                            view_.v(stretch.pixel / tile_size), 0.0, 0.0);
        if (hi < box.enter_lo || lo > box.exit_hi) return;
        proved = proved && lo >= box.enter_hi && hi <= box.exit_lo;
    }
    const bool narrow = hi - lo <= view_.tolerance();
    if (stretch.again && !narrow) {
        open_.push_back(stretch);
        open_.back().from = lo;
        open_.back().to = hi;
    } else if (!proved) {
        doubts_.push_back({stretch.pixel, lo, hi, stretch.kernel});
    } else {
        if (!narrow) counters_.coarse_width = std::max(counters_.coarse_width, hi - lo);
        add(i, s, narrow ? Certificate::Certified : Certificate::Coarse);
    }
}

template <class Real>
void RootFinder<Real>::add(std::size_t i, double s, Certificate known) {
    const Stretch& stretch = stretches_[i];
    const Real per_slope = stretch.trend() == Trend::Falling ? -per_slope_[i] : per_slope_[i];
    const bool fits = per_slope > 0 && per_slope <= std::numeric_limits<Real>::max();
    if (stretch.kinked || !fits)
        return found_.add_pending(stretch.pixel, s, known, stretch.trend());
    if constexpr (std::is_same_v<Real, float>) {
        found_.add(stretch.pixel, s, known, {gradient_[0][i], gradient_[1][i], gradient_[2][i]});
    } else {
        found_.add(stretch.pixel, s, known,
                   float_gradient({gradient_[0][i], gradient_[1][i], gradient_[2][i]}));
    }
}

/// The interval Newton operator: f is within `error` of the value computed, and the root, if any,
/// is at the guess less f over the slope at some place between.
template <class Real>
void RootFinder<Real>::step(bool last) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
        const Stretch& stretch = stretches_[i];
        const double error = value_error(stretch.r);
        const bool falling = stretch.slope_hi < 0;
        const double f = falling ? -f_[i] : f_[i];
        const double least = falling ? -stretch.slope_hi : stretch.slope_lo;
        const double most = falling ? -stretch.slope_lo : stretch.slope_hi;
        // Rounded upward, like both ends of the bracket. The sign of y is hard to predict.
        const double slopes[] = {most, least};
        const auto quotient = [&](double y) { return y / slopes[y > 0 ? 1 : 0]; };
        const double above = f + error;
        const double neg_below = error - f;
        const double lo = -(quotient(above) - stretch.guess);
        const double hi = quotient(neg_below) + stretch.guess;
        const bool known = lo <= hi;  // false where NaN
        if (known && (hi < stretch.from || lo > stretch.to)) continue;
        const double from = known ? std::max(stretch.from, lo) : stretch.from;
        const double to = known ? std::min(stretch.to, hi) : stretch.to;
        double next = stretch.guess - f_[i] * static_cast<double>(per_slope_[i]);
        if (!(next >= from && next <= to)) next = 0.5 * from + 0.5 * to;
        const bool narrow = known && hi - lo <= view_.tolerance();
        const bool proved = known && lo >= stretch.lo && hi <= stretch.hi;
        const bool stuck = known && above >= 0 && neg_below >= 0 && !narrow;
        if ((proved && narrow) || stuck || last || !(from < 0.5 * from + 0.5 * to)) {
            finish(i, from, to, next, proved);
            continue;
        }
        Stretch remaining = stretch;
        remaining.from = from;
        remaining.to = to;
        remaining.guess = next;
        col_[kept] = col_[i];
        row_[kept] = row_[i];
        per_slope_[kept] = per_slope_[i];
        for (auto& component : gradient_)
            component[kept] = component[i];
        stretches_[kept++] = remaining;
    }
    size_ = kept;
}

template <class Real>
void RootFinder<Real>::solve() {
    if (size_ == 0) return;
    if (!frame_.stopped()) {
        take_first_steps();
        evaluate();
        refine();
    }
    for (int taken = 1; size_ > 0 && taken <= most_steps && !frame_.stopped(); ++taken) {
        evaluate();
        step(taken == most_steps);
    }
    // Those that it was stopped at.
    for (std::size_t i = 0; i < size_; ++i) {
        const Stretch& stretch = stretches_[i];
        doubts_.push_back({stretch.pixel, stretch.from, stretch.to, stretch.kernel});
    }
    size_ = 0;
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
