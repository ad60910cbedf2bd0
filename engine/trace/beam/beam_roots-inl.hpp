// Roots on rays where f is known to be monotone: Newton's method in double, with certificates.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_ROOTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_ROOTS_INL
#undef ZEROSET_BEAM_ROOTS_INL
#else
#define ZEROSET_BEAM_ROOTS_INL
#endif

#include "engine/trace/beam/beam_cells-inl.hpp"
#include "engine/trace/beam/beam_nearest-inl.hpp"
#include "engine/trace/beam/beam_newton-inl.hpp"
#include "engine/trace/tile_costs.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A part of a ray on which f is continuous and monotone, and so has at most one root.
struct RootBracket {
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

/// Solves brackets in batches: Newton's method in the type of the tile's cells, `Real`, then in
/// double. A batch's brackets have the same kernel.
template <class Real>
class RootFinder {
public:
    /// `asked`: the width of brackets that is asked for; they are sought no wider than the rays'
    /// tolerance, which is not above it.
    RootFinder(const TraceFrame& frame, const TileRays& rays, double asked,
               NearestRoots<Real>& nearest, Counters& counters)
        : frame_(frame), rays_(rays), asked_(asked), nearest_(nearest), counters_(counters) {}

    void push(const RootBracket& bracket) {
        if (size_ > 0 && brackets_[0].kernel != bracket.kernel) solve();
        brackets_[size_++] = bracket;
        if (size_ == capacity) solve();
    }
    /// Works off what has been pushed.
    void solve();
    /// Brackets on which Newton's method proved nothing.
    std::vector<RootBracket> take_open() { return std::exchange(open_, {}); }
    /// Roots that may be there, where nothing more can be done along the ray.
    std::vector<Doubt> take_doubts() { return std::exchange(doubts_, {}); }

private:
    static constexpr std::size_t capacity = 256;
    static constexpr int first_steps = 4;  ///< at most
    static constexpr int most_steps = 40;

    /// Tells who asks that f was evaluated so often for each bracket.
    void tell_costs(double evaluations) const {
        for (std::size_t i = 0; counters_.costs != nullptr && i < size_; ++i)
            counters_.costs->add(brackets_[i].pixel, evaluations);
    }
    /// Closer guesses, and the slopes there: a help only, nothing rests on them.
    void take_first_steps();
    void evaluate();
    /// One step of Newton's method in double, a help only, too.
    void refine();
    /// One step of each bracket; keeps those that are not finished.
    void step(bool last);
    /// Ends bracket i: its root is in [lo, hi], surely if it is `proved`.
    void finish(std::size_t i, double lo, double hi, double s, bool proved);
    void add(std::size_t i, double s, Certificate known);

    const TraceFrame& frame_;
    const TileRays& rays_;
    double asked_;
    NearestRoots<Real>& nearest_;
    Counters& counters_;
    std::size_t size_ = 0;
    std::array<RootBracket, capacity> brackets_;
    std::vector<RootBracket> open_;
    std::vector<Doubt> doubts_;
    NewtonRays<Real, capacity> newton_;
};

template <class Real>
void RootFinder<Real>::take_first_steps() {
    const Kernel& kernel = *brackets_[0].kernel;
    const std::size_t count = padded(size_, kernel.lane_multiple);
    for (std::size_t i = 0; i < count; ++i) {
        const RootBracket& bracket = brackets_[i < size_ ? i : 0];
        newton_.col[i] = from_middle(static_cast<int>(bracket.pixel % tile_size));
        newton_.row[i] = from_middle(static_cast<int>(bracket.pixel / tile_size));
        newton_.from[i] = static_cast<Real>(bracket.from);
        newton_.to[i] = static_cast<Real>(bracket.to);
        newton_.guess[i] = static_cast<Real>(bracket.guess);
    }
    counters_.value += 2 * size_;
    tell_costs(2.0);
    newton_.take_steps(frame_, rays_, kernel, count, first_steps);
    for (std::size_t i = 0; i < size_; ++i) {
        RootBracket& bracket = brackets_[i];
        bracket.guess = std::clamp(static_cast<double>(newton_.guess[i]), bracket.from, bracket.to);
    }
}

template <class Real>
void RootFinder<Real>::evaluate() {
    const Kernel& kernel = *brackets_[0].kernel;
    const std::size_t count = padded(size_, kernel.lane_multiple);
    for (std::size_t i = 0; i < count; ++i)
        newton_.s[i] = brackets_[i < size_ ? i : 0].guess;
    counters_.value += size_;
    tell_costs(1.0);
    newton_.evaluate(frame_, rays_, kernel, count);
}

template <class Real>
void RootFinder<Real>::refine() {
    for (std::size_t i = 0; i < size_; ++i) {
        RootBracket& bracket = brackets_[i];
        const double newton =
            bracket.guess - newton_.f[i] * static_cast<double>(newton_.per_slope[i]);
        const double above = newton > bracket.from ? newton : bracket.from;  // `from` where NaN
        bracket.guess = std::min(above, bracket.to);
    }
}

template <class Real>
void RootFinder<Real>::finish(std::size_t i, double lo, double hi, double s, bool proved) {
    const RootBracket& bracket = brackets_[i];
    if (!bracket.inside) {
        const DepthRange box = rays_.depths(rays_.u(bracket.pixel % tile_size),
                                            rays_.v(bracket.pixel / tile_size), 0.0, 0.0);
        if (hi < box.enter_lo || lo > box.exit_hi) return;
        proved = proved && lo >= box.enter_hi && hi <= box.exit_lo;
    }
    const bool narrow = hi - lo <= asked_;
    if (bracket.again && !narrow) {
        open_.push_back(bracket);
        open_.back().from = lo;
        open_.back().to = hi;
    } else if (!proved) {
        doubts_.push_back({.pixel = bracket.pixel, .from = lo, .to = hi, .kernel = bracket.kernel});
    } else {
        if (!narrow) counters_.coarse_width = std::max(counters_.coarse_width, hi - lo);
        add(i, s, narrow ? Certificate::Certified : Certificate::Coarse);
    }
}

template <class Real>
void RootFinder<Real>::add(std::size_t i, double s, Certificate known) {
    const RootBracket& bracket = brackets_[i];
    const Real per_slope =
        bracket.trend() == Trend::Falling ? -newton_.per_slope[i] : newton_.per_slope[i];
    const bool fits = per_slope > 0 && per_slope <= std::numeric_limits<Real>::max();
    if (bracket.kinked || !fits)
        return nearest_.add_pending(bracket.pixel, s, known, bracket.trend());
    if constexpr (std::is_same_v<Real, float>) {
        nearest_.add(bracket.pixel, s, known,
                     {newton_.gradient[0][i], newton_.gradient[1][i], newton_.gradient[2][i]});
    } else {
        nearest_.add(bracket.pixel, s, known,
                     float_gradient(
                         {newton_.gradient[0][i], newton_.gradient[1][i], newton_.gradient[2][i]}));
    }
}

/// f and its slopes at a root, turned so that f rises.
struct Rise {
    double f, least, most;
};

inline Rise rise_of(const RootBracket& bracket, double f) {
    const bool falling = bracket.slope_hi < 0;
    return {.f = falling ? -f : f,
            .least = falling ? -bracket.slope_hi : bracket.slope_lo,
            .most = falling ? -bracket.slope_lo : bracket.slope_hi};
}

/// The interval Newton operator: f is within `error` of the value computed, and the root, if any,
/// is at the guess less f over the slope at some place between.
template <class Real>
void RootFinder<Real>::step(bool last) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
        const RootBracket& bracket = brackets_[i];
        const double error = value_error(bracket.r);
        const auto [f, least, most] = rise_of(bracket, newton_.f[i]);
        // Divide by the slopes, rounded upward, like both ends. The sign of y is hard to predict.
        const double slopes[] = {most, least};
        const auto quotient = [&](double y) { return y / slopes[y > 0 ? 1 : 0]; };
        const double above = f + error;
        const double neg_below = error - f;
        const double lo = -(quotient(above) - bracket.guess);
        const double hi = quotient(neg_below) + bracket.guess;
        const bool known = lo <= hi;  // false where NaN
        if (known && (hi < bracket.from || lo > bracket.to)) continue;
        const double from = known ? std::max(bracket.from, lo) : bracket.from;
        const double to = known ? std::min(bracket.to, hi) : bracket.to;
        // Take a step of Newton's method within what is left, or halve it.
        double next = bracket.guess - newton_.f[i] * static_cast<double>(newton_.per_slope[i]);
        if (!(next >= from && next <= to)) next = 0.5 * from + 0.5 * to;
        // End brackets in which no more steps are needed, or would help.
        const bool narrow = known && hi - lo <= rays_.tolerance();
        const bool proved = known && lo >= bracket.lo && hi <= bracket.hi;
        const bool stuck = known && above >= 0 && neg_below >= 0 && !narrow;
        if ((proved && narrow) || stuck || last || !(from < 0.5 * from + 0.5 * to)) {
            finish(i, from, to, next, proved);
            continue;
        }
        // Keep the others.
        RootBracket remaining = bracket;
        remaining.from = from;
        remaining.to = to;
        remaining.guess = next;
        newton_.col[kept] = newton_.col[i];
        newton_.row[kept] = newton_.row[i];
        newton_.per_slope[kept] = newton_.per_slope[i];
        for (auto& component : newton_.gradient)
            component[kept] = component[i];
        brackets_[kept++] = remaining;
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
    // Doubt those that it was stopped at.
    for (std::size_t i = 0; i < size_; ++i) {
        const RootBracket& bracket = brackets_[i];
        doubts_.push_back({.pixel = bracket.pixel,
                           .from = bracket.from,
                           .to = bracket.to,
                           .kernel = bracket.kernel});
    }
    size_ = 0;
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
