#include "engine/antialias/ray_stretches.hpp"

#include "engine/antialias/cover_rules.hpp"
#include "engine/kernel/point_batch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace zeroset {
namespace {

/// How well the depth of a root is known.
double error_of_root(const TileRays& rays, double s) {
    return std::max(root_error * rays.pixel() * (rays.distance() + s), 2.0 * rays.depth_error());
}

/// A ray: the point at depth s is origin + s direction.
struct RayLine {
    glm::dvec3 origin, direction;

    RayLine(const TileRays& rays, double col, double row) {
        const ViewFrame& axes = rays.axes();
        const glm::dvec3 across = rays.u(col) * axes.right + rays.v(row) * axes.up;
        origin = rays.base() + rays.distance() * across;
        direction = axes.forward + across;
    }
};

/// f on rays.
class RayValues {
public:
    RayValues(const TraceFrame& frame, const TileRays& rays, Counters& counters)
        : frame_(frame), rays_(rays), counters_(counters), batch_(room()) {}

    /// Begins to ask, `count` times.
    void begin(std::size_t count) {
        batch_.resize(count);
        asked_ = 0;
    }
    void ask(const RayLine& line, double s) {
        const glm::dvec3 x = line.origin + s * line.direction;
        batch_.set(asked_++, x.x, x.y, x.z);
    }
    /// Evaluates what was asked for.
    void evaluate();
    [[nodiscard]] double f(std::size_t i) const { return batch_.f(i); }
    [[nodiscard]] glm::dvec3 gradient(std::size_t i) const {
        return {batch_.gradient(0, i), batch_.gradient(1, i), batch_.gradient(2, i)};
    }
    /// df/ds.
    [[nodiscard]] double slope(std::size_t i, const RayLine& line) const {
        return glm::dot(gradient(i), line.direction);
    }
    /// How f changes from ray to ray at the same depth, a pixel to the right and downwards.
    [[nodiscard]] double by_col(const glm::dvec3& gradient, double s) const {
        return pixel_at(s) * glm::dot(gradient, rays_.axes().right);
    }
    [[nodiscard]] double by_row(const glm::dvec3& gradient, double s) const {
        return -pixel_at(s) * glm::dot(gradient, rays_.axes().up);
    }

private:
    /// A thread's: one object at a time uses it.
    static PointBatch<double>& room() {
        thread_local PointBatch<double> kept;
        return kept;
    }
    [[nodiscard]] double pixel_at(double s) const { return rays_.pixel() * (rays_.distance() + s); }

    const TraceFrame& frame_;
    const TileRays& rays_;
    Counters& counters_;
    PointBatch<double>& batch_;
    std::size_t asked_ = 0;
};

void RayValues::evaluate() {
    if (asked_ == 0) return;
    batch_.pad();
    counters_.value += asked_;
    batch_.evaluate(frame_.kernel.in_double.value, frame_.scene.uniforms.points<double>(),
                    [] { return false; });
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

/// What find_least works on: a stretch, its ray, and f's gradient where f is least so far.
struct LeastTask {
    RayStretch* stretch;
    RayLine line;
    glm::dvec3 gradient;

    LeastTask(RayStretch& of, const TileRays& rays)
        : stretch(&of), line(rays, of.col, of.row), gradient(0.0) {}
};

/// The search for the least f of one stretch.
struct LeastSearch {
    LeastTask* task;
    double sign, size;  ///< of f at the ends: 1 or -1, and the larger
    Place lo, hi;       ///< df/ds below 0, and above
    double next = 0.0;

    void choose(int step) {
        next = step % 3 == 1 ? meeting_of_tangents(lo, hi) : least_of_cubic(lo, hi);
    }
    void take(double f, const glm::dvec3& gradient) {
        const double slope = sign * glm::dot(gradient, task->line.direction);
        const Place place{.s = next, .f = sign * f, .slope = slope};
        RayStretch& stretch = *task->stretch;
        if (!(place.f > stretch.least)) {
            stretch.least = place.f;
            stretch.at = next;
            stretch.inner = true;
            task->gradient = sign * gradient;
        }
        (slope < 0.0 ? lo : hi) = place;
    }
    [[nodiscard]] bool narrow() const {
        return (hi.s - lo.s) * std::min(-lo.slope, hi.slope) <= 1e-7 * size;
    }
};

/// The search for the root of one stretch.
struct RootSearch {
    RayRoot* root;
    const RayLine* line;
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
std::vector<LeastSearch> begin_least(RayValues& values, std::span<LeastTask> tasks) {
    values.begin(2 * tasks.size());
    for (const LeastTask& task : tasks) {
        values.ask(task.line, task.stretch->from);
        values.ask(task.line, task.stretch->to);
    }
    values.evaluate();
    std::vector<LeastSearch> open;
    open.reserve(tasks.size());
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        LeastTask& task = tasks[i];
        RayStretch& stretch = *task.stretch;
        stretch.near = values.f(2 * i);
        stretch.far = values.f(2 * i + 1);
        const double sign = stretch.near >= 0.0 ? 1.0 : -1.0;
        const auto place = [&](std::size_t k, double s) {
            return Place{
                .s = s, .f = sign * values.f(k), .slope = sign * values.slope(k, task.line)};
        };
        const Place lo = place(2 * i, stretch.from);
        const Place hi = place(2 * i + 1, stretch.to);
        stretch.least = std::min(lo.f, hi.f);
        stretch.at = hi.f < lo.f ? hi.s : lo.s;
        stretch.inner = false;
        task.gradient = sign * values.gradient(hi.f < lo.f ? 2 * i + 1 : 2 * i);
        if (lo.slope < 0.0 && hi.slope > 0.0) {
            open.push_back({.task = &task,
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
                                      std::span<const RayLine> lines, std::vector<bool>& falls) {
    constexpr int samples = 8;  // of a stretch that may hold several
    const auto samples_of = [](const RayRoot& root) { return root.several ? samples : 2; };
    const auto place = [&](const RayRoot& root, int i) {
        return root.from + i * ((root.to - root.from) / (samples_of(root) - 1));
    };
    std::size_t count = 0;
    for (const RayRoot& root : roots)
        count += static_cast<std::size_t>(samples_of(root));
    values.begin(count);
    for (std::size_t k = 0; k < roots.size(); ++k) {
        for (int i = 0; i < samples_of(roots[k]); ++i)
            values.ask(lines[k], place(roots[k], i));
    }
    values.evaluate();
    std::vector<RootSearch> open;
    open.reserve(roots.size());
    std::size_t first = 0;
    for (std::size_t k = 0; k < roots.size(); ++k) {
        RayRoot& root = roots[k];
        root.s = root.to;
        falls.push_back(values.f(first) > 0.0);
        for (int i = 1; i < samples_of(root); ++i) {
            const double f_lo = values.f(first + static_cast<std::size_t>(i) - 1);
            const double f_hi = values.f(first + static_cast<std::size_t>(i));
            if (!(f_lo * f_hi < 0.0)) continue;
            root.found = true;
            open.push_back({.root = &root,
                            .line = &lines[k],
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

/// Narrows brackets until a step is shorter than the error that roots may have.
void narrow_roots(const TraceFrame& frame, const TileRays& rays, RayValues& values,
                  std::vector<RootSearch>& open) {
    constexpr int most_steps = 40;
    for (int step = 0; step < most_steps && !open.empty() && !frame.stopped(); ++step) {
        values.begin(open.size());
        for (const RootSearch& search : open)
            values.ask(*search.line, search.next);
        values.evaluate();
        std::size_t kept = 0;
        for (std::size_t i = 0; i < open.size(); ++i) {
            RootSearch& search = open[i];
            const double tolerance = error_of_root(rays, search.next);
            search.root->s = search.next;
            search.take(values.f(i), values.slope(i, *search.line));
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
    if (stretches.empty()) return;
    RayValues values(frame, rays, counters);
    std::vector<LeastTask> tasks;
    tasks.reserve(stretches.size());
    for (RayStretch& stretch : stretches)
        tasks.emplace_back(stretch, rays);
    std::vector<LeastSearch> open = begin_least(values, tasks);
    for (int step = 0; step < most_steps && !open.empty() && !frame.stopped(); ++step) {
        values.begin(open.size());
        for (LeastSearch& search : open) {
            search.choose(step);
            values.ask(search.task->line, search.next);
        }
        values.evaluate();
        std::size_t kept = 0;
        for (std::size_t i = 0; i < open.size(); ++i) {
            LeastSearch& search = open[i];
            search.take(values.f(i), values.gradient(i));
            if (!search.narrow()) open[kept++] = search;
        }
        open.resize(kept);
    }
    for (const LeastTask& task : tasks) {
        RayStretch& stretch = *task.stretch;
        stretch.by_col = values.by_col(task.gradient, stretch.at);
        stretch.by_row = values.by_row(task.gradient, stretch.at);
    }
}

void find_roots(const TraceFrame& frame, const TileRays& rays, std::span<RayRoot> roots,
                Counters& counters) {
    if (roots.empty()) return;
    RayValues values(frame, rays, counters);
    std::vector<RayLine> lines;
    lines.reserve(roots.size());
    for (const RayRoot& root : roots)
        lines.emplace_back(rays, root.col, root.row);
    std::vector<bool> falls;
    std::vector<RootSearch> open = bracket_roots(values, roots, lines, falls);
    for (RootSearch& search : open)
        search.begin();
    narrow_roots(frame, rays, values, open);
    // The branch that leads to the root is the one before it. Where f only comes to 0, its gradient
    // vanishes there.
    constexpr double before = 1.0 / 64;  // in pixels
    values.begin(roots.size());
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const RayRoot& root = roots[i];
        const double step = before * rays.pixel() * (rays.distance() + root.s);
        values.ask(lines[i],
                   root.s - std::max(root.found ? 0.0 : step, 2.0 * error_of_root(rays, root.s)));
    }
    values.evaluate();
    for (std::size_t i = 0; i < roots.size(); ++i) {
        RayRoot& root = roots[i];
        const glm::dvec3& along = lines[i].direction;
        const double slope = values.slope(i, lines[i]);
        root.gradient = values.gradient(i);
        root.by_col = -values.by_col(root.gradient, root.s) / slope;
        root.by_row = -values.by_row(root.gradient, root.s) / slope;
        root.cosine = std::abs(slope) / (glm::length(root.gradient) * glm::length(along));
        if ((slope < 0.0) == falls[i]) continue;
        // Turn it until it is upright on the ray, and a little more.
        const double least = 1e-3 * glm::length(root.gradient) * glm::length(along);
        const double change = (falls[i] ? -least : least) - slope;
        root.gradient += change / glm::dot(along, along) * along;
    }
}

}  // namespace zeroset
