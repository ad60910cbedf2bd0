#include "engine/antialias/ray_stretches.hpp"

#include "engine/kernel/point_batch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace zeroset {
namespace {

/// f on rays.
class RayValues {
public:
    RayValues(const TraceFrame& frame, const TileRays& rays, Counters& counters)
        : frame_(frame),
          rays_(rays),
          counters_(counters),
          points_(room().points),
          batch_(room().batch) {
        points_.clear();
    }

    void clear() { points_.clear(); }
    void ask(double col, double row, double s) {
        points_.push_back({.col = col, .row = row, .s = s});
    }
    /// Evaluates what was asked for.
    void evaluate();
    [[nodiscard]] double f(std::size_t i) const { return batch_.f(i); }
    [[nodiscard]] glm::dvec3 gradient(std::size_t i) const {
        return {batch_.gradient(0, i), batch_.gradient(1, i), batch_.gradient(2, i)};
    }
    /// How the point changes with s.
    [[nodiscard]] glm::dvec3 direction(std::size_t i) const {
        const ViewFrame& axes = rays_.axes();
        return axes.forward + rays_.u(points_[i].col) * axes.right +
               rays_.v(points_[i].row) * axes.up;
    }
    /// How f changes from ray to ray at the same depth, a pixel to the right and downwards.
    [[nodiscard]] double by_col(std::size_t i) const {
        return pixel_at(i) * glm::dot(gradient(i), rays_.axes().right);
    }
    [[nodiscard]] double by_row(std::size_t i) const {
        return -pixel_at(i) * glm::dot(gradient(i), rays_.axes().up);
    }
    /// df/ds.
    [[nodiscard]] double slope(std::size_t i) const { return glm::dot(gradient(i), direction(i)); }

private:
    struct Point {
        double col, row, s;
    };
    struct Room {
        std::vector<Point> points;
        PointBatch<double> batch;
    };
    /// A thread's: one object at a time uses it.
    static Room& room() {
        thread_local Room kept;
        return kept;
    }
    [[nodiscard]] double pixel_at(std::size_t i) const {
        return rays_.pixel() * (rays_.distance() + points_[i].s);
    }

    const TraceFrame& frame_;
    const TileRays& rays_;
    Counters& counters_;
    std::vector<Point>& points_;
    PointBatch<double>& batch_;
};

void RayValues::evaluate() {
    constexpr std::size_t at_once = 256;
    if (points_.empty()) return;
    batch_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const glm::dvec3 x = rays_.point(points_[i].col, points_[i].row, points_[i].s);
        batch_.set(i, x.x, x.y, x.z);
    }
    batch_.pad();
    counters_.value += points_.size();
    const double* const uniforms = frame_.scene.uniforms.points<double>();
    for (std::size_t i = 0; i < batch_.size(); i += at_once)
        frame_.kernel.value(batch_.batch(i, std::min(at_once, batch_.size() - i), uniforms));
}

/// A place on a ray: f there, with the sign that it has at the stretch's near end, and df/ds.
struct Place {
    double s, f, slope;
};

/// Where the cubic through two places with these slopes is least; between them.
double least_of_cubic(const Place& a, const Place& b) {
    const double length = b.s - a.s;
    const double chord = (b.f - a.f) / length;
    const double p = a.slope + b.slope - 3.0 * chord;
    const double root = std::sqrt(std::max(p * p - a.slope * b.slope, 0.0));
    const double part = 1.0 - (b.slope + root - p) / (b.slope - a.slope + 2.0 * root);
    const double within = part > 0.0 && part < 1.0 ? part : 0.5;
    return a.s + std::clamp(within, 0.02, 0.98) * length;
}

/// Where the tangents at two places meet: where f is least if it has a kink between them, and is
/// straight on both sides.
double meeting_of_tangents(const Place& a, const Place& b) {
    const double length = b.s - a.s;
    const double part = (b.f - a.f - b.slope * length) / ((a.slope - b.slope) * length);
    const double within = part > 0.0 && part < 1.0 ? part : 0.5;
    return a.s + std::clamp(within, 0.02, 0.98) * length;
}

/// The search for the least f of one stretch.
struct LeastSearch {
    RayStretch* stretch;
    double sign, size;  ///< of f at the ends: 1 or -1, and the larger
    Place lo, hi;       ///< df/ds below 0, and above

    [[nodiscard]] double next(int step) const {
        return step % 3 == 1 ? meeting_of_tangents(lo, hi) : least_of_cubic(lo, hi);
    }
    void take(const RayValues& values, std::size_t i, double s) {
        const Place place{.s = s, .f = sign * values.f(i), .slope = sign * values.slope(i)};
        if (!(place.f > stretch->least)) {
            stretch->least = place.f;
            stretch->at = s;
            stretch->by_col = sign * values.by_col(i);
            stretch->by_row = sign * values.by_row(i);
            stretch->inner = true;
        }
        (place.slope < 0.0 ? lo : hi) = place;
    }
    [[nodiscard]] bool narrow() const {
        return (hi.s - lo.s) * std::min(-lo.slope, hi.slope) <= 1e-7 * size;
    }
};

/// The search for the root of one stretch.
struct RootSearch {
    RayRoot* root;
    double lo, hi, f_lo, f_hi;
    double next;
    int stood = 0;            ///< steps in a row that kept the same end
    bool was_before = false;  ///< the last one kept the far end

    /// Begins where the secant vanishes.
    void begin() {
        const double part = f_lo / (f_lo - f_hi);
        next = lo + (part > 0.0 && part < 1.0 ? part : 0.5) * (hi - lo);
    }
    /// Takes f there, and goes on by Newton's method; where that leaves the bracket, or one end has
    /// stood still, to its middle.
    void take(double f, double slope) {
        const bool before = (f > 0) == (f_lo > 0);
        (before ? lo : hi) = next;
        (before ? f_lo : f_hi) = f;
        stood = before == was_before ? stood + 1 : 0;
        was_before = before;
        const double newton = next - f / slope;
        const bool fits = newton > lo && newton < hi && stood < 3;
        next = fits ? newton : 0.5 * lo + 0.5 * hi;
    }
};

/// Takes f at the ends of stretches; returns those in which df/ds changes its sign.
std::vector<LeastSearch> begin_least(RayValues& values, std::span<RayStretch> stretches) {
    for (const RayStretch& stretch : stretches) {
        values.ask(stretch.col, stretch.row, stretch.from);
        values.ask(stretch.col, stretch.row, stretch.to);
    }
    values.evaluate();
    std::vector<LeastSearch> open;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        RayStretch& stretch = stretches[i];
        stretch.near = values.f(2 * i);
        stretch.far = values.f(2 * i + 1);
        const double sign = stretch.near >= 0.0 ? 1.0 : -1.0;
        const auto place = [&](std::size_t k, double s) {
            return Place{.s = s, .f = sign * values.f(k), .slope = sign * values.slope(k)};
        };
        const Place lo = place(2 * i, stretch.from);
        const Place hi = place(2 * i + 1, stretch.to);
        const std::size_t least = hi.f < lo.f ? 2 * i + 1 : 2 * i;
        stretch.least = std::min(lo.f, hi.f);
        stretch.at = hi.f < lo.f ? hi.s : lo.s;
        stretch.by_col = sign * values.by_col(least);
        stretch.by_row = sign * values.by_row(least);
        stretch.inner = false;
        if (lo.slope < 0.0 && hi.slope > 0.0) {
            open.push_back({.stretch = &stretch,
                            .sign = sign,
                            .size = std::max(std::abs(lo.f), std::abs(hi.f)),
                            .lo = lo,
                            .hi = hi});
        }
    }
    return open;
}

/// Brackets the roots, the first ones that samples show where there may be several; `falls`: the
/// way that f goes there.
std::vector<RootSearch> bracket_roots(RayValues& values, std::span<RayRoot> roots,
                                      std::vector<bool>& falls) {
    constexpr int samples = 8;  // of a stretch that may hold several
    const auto samples_of = [](const RayRoot& root) { return root.several ? samples : 2; };
    const auto place = [&](const RayRoot& root, int i) {
        return root.from + i * ((root.to - root.from) / (samples_of(root) - 1));
    };
    values.clear();
    for (const RayRoot& root : roots) {
        for (int i = 0; i < samples_of(root); ++i)
            values.ask(root.col, root.row, place(root, i));
    }
    values.evaluate();
    std::vector<RootSearch> open;
    std::size_t first = 0;
    for (RayRoot& root : roots) {
        root.s = root.to;
        falls.push_back(values.f(first) > 0.0);
        for (int i = 1; i < samples_of(root); ++i) {
            const double f_lo = values.f(first + static_cast<std::size_t>(i) - 1);
            const double f_hi = values.f(first + static_cast<std::size_t>(i));
            if (!(f_lo * f_hi < 0.0)) continue;
            root.found = true;
            open.push_back({.root = &root,
                            .lo = place(root, i - 1),
                            .hi = place(root, i),
                            .f_lo = f_lo,
                            .f_hi = f_hi,
                            .next = 0.0});
            break;
        }
        first += static_cast<std::size_t>(samples_of(root));
    }
    return open;
}

/// Narrows brackets until a step is shorter than `fine` pixels.
void narrow_roots(const TraceFrame& frame, const TileRays& rays, RayValues& values,
                  std::vector<RootSearch>& open) {
    constexpr double fine = 1.0 / 1024;
    constexpr int most_steps = 40;
    for (int step = 0; step < most_steps && !open.empty() && !frame.stopped(); ++step) {
        values.clear();
        for (const RootSearch& search : open)
            values.ask(search.root->col, search.root->row, search.next);
        values.evaluate();
        std::size_t kept = 0;
        for (std::size_t i = 0; i < open.size(); ++i) {
            RootSearch& search = open[i];
            const double least = fine * rays.pixel() * (rays.distance() + search.next);
            const double tolerance = std::max(least, rays.tolerance());
            search.root->s = search.next;
            search.take(values.f(i), values.slope(i));
            const bool is_near = std::abs(search.next - search.root->s) <= tolerance;
            search.root->s = search.next;
            if (!is_near && search.hi - search.lo > tolerance) open[kept++] = search;
        }
        open.resize(kept);
    }
}

}  // namespace

void find_least(const TraceFrame& frame, const TileRays& rays, std::span<RayStretch> stretches,
                Counters& counters) {
    constexpr int most_steps = 16;
    RayValues values(frame, rays, counters);
    std::vector<LeastSearch> open = begin_least(values, stretches);
    for (int step = 0; step < most_steps && !open.empty() && !frame.stopped(); ++step) {
        values.clear();
        for (const LeastSearch& search : open)
            values.ask(search.stretch->col, search.stretch->row, search.next(step));
        values.evaluate();
        std::size_t kept = 0;
        for (std::size_t i = 0; i < open.size(); ++i) {
            LeastSearch& search = open[i];
            search.take(values, i, search.next(step));
            if (!search.narrow()) open[kept++] = search;
        }
        open.resize(kept);
    }
}

void find_roots(const TraceFrame& frame, const TileRays& rays, std::span<RayRoot> roots,
                Counters& counters) {
    RayValues values(frame, rays, counters);
    std::vector<bool> falls;
    std::vector<RootSearch> open = bracket_roots(values, roots, falls);
    for (RootSearch& search : open)
        search.begin();
    narrow_roots(frame, rays, values, open);
    // The branch that leads to the root is the one before it. Where f only comes to 0, its gradient
    // vanishes there.
    constexpr double before = 1.0 / 64;  // in pixels
    values.clear();
    for (const RayRoot& root : roots) {
        const double step = before * rays.pixel() * (rays.distance() + root.s);
        values.ask(root.col, root.row,
                   root.s - std::max(root.found ? 0.0 : step, 2.0 * rays.tolerance()));
    }
    values.evaluate();
    for (std::size_t i = 0; i < roots.size(); ++i) {
        RayRoot& root = roots[i];
        root.gradient = values.gradient(i);
        root.by_col = -values.by_col(i) / values.slope(i);
        root.by_row = -values.by_row(i) / values.slope(i);
        const glm::dvec3 along = values.direction(i);
        root.cosine = std::abs(values.slope(i)) / (glm::length(root.gradient) * glm::length(along));
        if ((values.slope(i) < 0.0) == falls[i]) continue;
        // Turn it until it is upright on the ray, and a little more.
        const double least = 1e-3 * glm::length(root.gradient) * glm::length(along);
        const double change = (falls[i] ? -least : least) - values.slope(i);
        root.gradient += change / glm::dot(along, along) * along;
    }
}

}  // namespace zeroset
