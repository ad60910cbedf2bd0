// Roots on rays where f is known to be monotone: Newton's method in double, with certificates.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_ROOTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_ROOTS_INL
#undef ZEROSET_BEAM_ROOTS_INL
#else
#define ZEROSET_BEAM_ROOTS_INL
#endif

#include "engine/trace/beam_cells-inl.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

constexpr std::size_t tile_pixels = static_cast<std::size_t>(tile_size) * tile_size;

/// What is known of the tile's rays so far, in the type of its cells.
template <class Real>
class Found {
public:
    static constexpr Real none = std::numeric_limits<Real>::infinity();

    Found() : depth(tile_pixels, none) {}

    /// Begins a tile whose certificates and gradients go to `hits`, which is clear.
    void begin(TileHits& hits) {
        if (any_) std::ranges::fill(depth, none);
        any_ = false;
        hits_ = &hits;
        without_gradient.clear();
    }
    /// A root at s, if it is the nearest so far.
    void add(std::size_t pixel, double s, Certificate known, const std::array<float, 3>& slope) {
        if (!(s < static_cast<double>(depth[pixel]))) return;
        any_ = true;
        depth[pixel] = static_cast<Real>(s);
        hits_->certificate[pixel] = known;
        for (std::size_t k = 0; k < 3; ++k)
            hits_->gradient[k][pixel] = slope[k];
    }
    /// One that may be there.
    void add_undecided(std::uint32_t pixel, double s) {
        if (!(s < static_cast<double>(depth[pixel]))) return;
        add(pixel, s, Certificate::Undecided, {});
        without_gradient.push_back(pixel);
    }
    /// Certified roots of a row of pixels, each the nearest so far, are written to `depth` and
    /// these.
    Certificate* certificates(std::size_t pixel) {
        any_ = true;
        return &hits_->certificate[pixel];
    }
    float* gradients(std::size_t axis, std::size_t pixel) { return &hits_->gradient[axis][pixel]; }
    [[nodiscard]] bool any() const { return any_; }

    /// s of the nearest root of each pixel, in rows of tile_size; +inf: none.
    std::vector<Real> depth;
    std::vector<std::uint32_t> without_gradient;  ///< pixels with a root but no gradient

private:
    bool any_ = false;
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
};

/// How far f is off where it was evaluated in double; `r`: see FormBatchOf.
inline double value_error(double r) {
    return std::numeric_limits<double>::epsilon() * (1.0 + 0x1p-20) * r;
}

/// Solves stretches in batches. `Real`: of the tile's cells; where it is float, the first steps
/// are.
template <class Real>
class RootFinder {
public:
    RootFinder(const TraceFrame& frame, const BeamView& view, Found<Real>& found,
               Counters& counters)
        : frame_(frame), view_(view), found_(found), counters_(counters) {}

    void push(const Stretch& stretch) {
        stretches_[size_++] = stretch;
        if (size_ == capacity) solve();
    }
    /// Works off what has been pushed.
    void solve();

private:
    static constexpr std::size_t capacity = 256;
    /// A whole batch may begin with any stretch.
    static constexpr std::size_t room = capacity + batch_multiple;
    static constexpr int most_steps = 40;
    static constexpr int float_steps = std::is_same_v<Real, float> ? 2 : 0;

    void make_rays();
    /// Calls evaluate(kernel, first, count) for stretches one behind the other that have the same
    /// kernel, from the front; count is that of a batch.
    template <class Evaluate>
    void by_kernels(Evaluate evaluate) const;
    void step_in_float();
    void evaluate_in_double();
    /// One step of each stretch; keeps those that are not finished.
    void step_in_double(bool last);
    void finish(std::size_t i, double lo, double hi, double s, bool proved);

    const TraceFrame& frame_;
    const BeamView& view_;
    Found<Real>& found_;
    Counters& counters_;
    std::size_t size_ = 0;
    std::array<Stretch, capacity> stretches_;
    alignas(64) double origin_[3][room];     ///< of the ray, at s = 0
    alignas(64) double direction_[3][room];  ///< for 1 of s
    alignas(64) double position_[3][room];
    alignas(64) double f_[room];
    alignas(64) double gradient_[3][room];
    alignas(64) float position_float_[3][room];
    alignas(64) float f_float_[room];
    alignas(64) float gradient_float_[3][room];
};

template <class Real>
void RootFinder<Real>::make_rays() {
    const ViewFrame& axes = view_.axes();
    for (std::size_t i = 0; i < size_; ++i) {
        const std::uint32_t pixel = stretches_[i].pixel;
        const double u = view_.u(pixel % tile_size);
        const double v = view_.v(pixel / tile_size);
        for (int k = 0; k < 3; ++k) {
            const double across = u * axes.right[k] + v * axes.up[k];
            origin_[k][i] = view_.base()[k] + view_.distance() * across;
            direction_[k][i] = axes.forward[k] + across;
        }
    }
    for (std::size_t i = size_; i < size_ + batch_multiple; ++i) {
        for (int k = 0; k < 3; ++k) {
            origin_[k][i] = origin_[k][0];
            direction_[k][i] = direction_[k][0];
        }
    }
}

template <class Real>
template <class Evaluate>
void RootFinder<Real>::by_kernels(Evaluate evaluate) const {
    for (std::size_t first = 0; first < size_;) {
        std::size_t last = first + 1;
        while (last < size_ && stretches_[last].kernel == stretches_[first].kernel)
            ++last;
        evaluate(*stretches_[first].kernel, first, padded(last - first));
        first = last;
    }
}

/// Moves the guesses closer, in float: a help only, nothing rests on it.
template <class Real>
void RootFinder<Real>::step_in_float() {
    const std::size_t count = size_ + batch_multiple;
    for (int k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < count; ++i) {
            const double s = stretches_[i < size_ ? i : 0].guess;
            position_float_[k][i] = static_cast<float>(origin_[k][i] + s * direction_[k][i]);
        }
    }
    counters_.value += size_;
    by_kernels([&](const Kernel& kernel, std::size_t first, std::size_t batch) {
        kernel.value(ValueBatchOf<float>{
            batch,
            {position_float_[0] + first, position_float_[1] + first, position_float_[2] + first},
            frame_.scene.uniforms.points<float>(),
            f_float_ + first,
            {gradient_float_[0] + first, gradient_float_[1] + first, gradient_float_[2] + first}});
    });
    for (std::size_t i = 0; i < size_; ++i) {
        Stretch& stretch = stretches_[i];
        double slope = 0;
        for (int k = 0; k < 3; ++k)
            slope += static_cast<double>(gradient_float_[k][i]) * direction_[k][i];
        const double next = stretch.guess - static_cast<double>(f_float_[i]) / slope;
        if (next >= stretch.from && next <= stretch.to) stretch.guess = next;
    }
}

template <class Real>
void RootFinder<Real>::evaluate_in_double() {
    const std::size_t count = size_ + batch_multiple;
    for (int k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < count; ++i) {
            const double s = stretches_[i < size_ ? i : 0].guess;
            position_[k][i] = origin_[k][i] + s * direction_[k][i];
        }
    }
    counters_.value += size_;
    by_kernels([&](const Kernel& kernel, std::size_t first, std::size_t batch) {
        kernel.value(ValueBatchOf<double>{
            batch,
            {position_[0] + first, position_[1] + first, position_[2] + first},
            frame_.scene.uniforms.points<double>(),
            f_ + first,
            {gradient_[0] + first, gradient_[1] + first, gradient_[2] + first}});
    });
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
    found_.add(stretch.pixel, s, proved ? Certificate::Certified : Certificate::Undecided,
               {static_cast<float>(gradient_[0][i]), static_cast<float>(gradient_[1][i]),
                static_cast<float>(gradient_[2][i])});
}

/// The interval Newton operator: f is within `error` of the value computed, and the root, if any,
/// is at the guess less f over the slope at some place between.
template <class Real>
void RootFinder<Real>::step_in_double(bool last) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
        Stretch& stretch = stretches_[i];
        const double error = value_error(stretch.r);
        const bool falling = stretch.slope_hi < 0;
        const double f = falling ? -f_[i] : f_[i];
        const double least = falling ? -stretch.slope_hi : stretch.slope_lo;
        const double most = falling ? -stretch.slope_lo : stretch.slope_hi;
        const double above = f + error;
        const double below = f - error;
        const double before = above > 0 ? above / least : above / most;
        const double behind = below > 0 ? below / most : below / least;
        const double lo = stretch.guess - before - view_.depth_error();
        const double hi = stretch.guess - behind + view_.depth_error();
        const bool known = lo <= hi;  // false where NaN
        if (known && (hi < stretch.from || lo > stretch.to)) continue;
        const double from = known ? std::max(stretch.from, lo) : stretch.from;
        const double to = known ? std::min(stretch.to, hi) : stretch.to;
        double slope = 0;
        for (int k = 0; k < 3; ++k)
            slope += gradient_[k][i] * direction_[k][i];
        double next = stretch.guess - f_[i] / slope;
        if (!(next >= from && next <= to)) next = 0.5 * from + 0.5 * to;
        const bool narrow = known && hi - lo <= view_.tolerance();
        const bool proved = narrow && lo >= stretch.lo && hi <= stretch.hi;
        const bool stuck = known && above >= 0 && below <= 0 && !narrow;
        if (proved || stuck || last || to - from <= 4 * view_.depth_error()) {
            finish(i, from, to, next, proved);
            continue;
        }
        Stretch remaining = stretch;
        remaining.from = from;
        remaining.to = to;
        remaining.guess = next;
        for (int k = 0; k < 3; ++k) {
            origin_[k][kept] = origin_[k][i];
            direction_[k][kept] = direction_[k][i];
        }
        stretches_[kept++] = remaining;
    }
    size_ = kept;
}

template <class Real>
void RootFinder<Real>::solve() {
    if (size_ == 0) return;
    make_rays();
    for (int step = 0; step < float_steps; ++step)
        step_in_float();
    for (int step = 1; size_ > 0 && step <= most_steps; ++step) {
        evaluate_in_double();
        step_in_double(step == most_steps);
    }
    size_ = 0;
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
