#include "engine/antialias/ray_stretches.hpp"

#include "engine/kernel/point_batch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace zeroset {
namespace {

/// How the point on a ray changes with s.
glm::dvec3 ray_direction(const TileRays& rays, double col, double row) {
    const ViewFrame& axes = rays.axes();
    return axes.forward + rays.u(col) * axes.right + rays.v(row) * axes.up;
}

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
        return ray_direction(rays_, points_[i].col, points_[i].row);
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

/// The places of a stretch at which f is asked for, to bracket a root.
class RootSamples {
public:
    explicit RootSamples(const RayRoot& root) : root_(root) {}

    [[nodiscard]] bool are_known() const { return !root_.several && root_.f_from * root_.f_to < 0; }
    [[nodiscard]] std::size_t count() const { return root_.several ? 8 : 2; }
    [[nodiscard]] double place(std::size_t i) const {
        return root_.from + static_cast<double>(i) *
                                ((root_.to - root_.from) / (static_cast<double>(count()) - 1));
    }

private:
    const RayRoot& root_;
};

/// Brackets the roots, the first ones that samples show where there may be several; `falls`: the
/// way that f goes there.
std::vector<RootSearch> bracket_roots(RayValues& values, std::span<RayRoot> roots,
                                      std::vector<bool>& falls) {
    values.clear();
    for (const RayRoot& root : roots) {
        const RootSamples samples(root);
        for (std::size_t i = 0; i < samples.count() && !samples.are_known(); ++i)
            values.ask(root.col, root.row, samples.place(i));
    }
    values.evaluate();
    std::vector<RootSearch> open;
    open.reserve(roots.size());
    std::size_t first = 0;
    for (RayRoot& root : roots) {
        const RootSamples samples(root);
        const bool known = samples.are_known();
        const auto f = [&](std::size_t i) {
            if (!known) return values.f(first + i);
            return i == 0 ? root.f_from : root.f_to;
        };
        root.s = root.to;
        falls.push_back(f(0) > 0.0);
        for (std::size_t i = 1; i < samples.count(); ++i) {
            const double f_lo = f(i - 1);
            const double f_hi = f(i);
            if (!(f_lo * f_hi < 0.0)) continue;
            root.found = true;
            open.push_back({.root = &root,
                            .lo = samples.place(i - 1),
                            .hi = samples.place(i),
                            .f_lo = f_lo,
                            .f_hi = f_hi,
                            .next = 0.0});
            break;
        }
        first += known ? 0 : samples.count();
    }
    return open;
}

/// Takes f's gradient at a place right before the root, or so near that it does not matter.
void take_gradient(RayRoot& root, const RayValues& values, std::size_t i) {
    root.gradient = values.gradient(i);
    root.slope = values.slope(i);
    root.by_col = -values.by_col(i) / root.slope;
    root.by_row = -values.by_row(i) / root.slope;
    const double size = glm::length(root.gradient) * glm::length(values.direction(i));
    root.cosine = std::abs(root.slope) / size;
}

/// Narrows brackets until a step is shorter than `fine` pixels, and takes gradients at the last
/// ones.
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
            const double before = search.next;
            search.take(values.f(i), values.slope(i));
            search.root->s = search.next;
            const bool is_near = std::abs(search.next - before) <= tolerance;
            if (!is_near && search.hi - search.lo > tolerance && step + 1 < most_steps) {
                open[kept++] = search;
            } else {
                take_gradient(*search.root, values, i);
            }
        }
        open.resize(kept);
    }
}

/// Takes gradients right before roots, where the last step took them on another branch of f, or
/// where f does not go the way that it goes at the root.
void take_gradients_before(RayValues& values, const TileRays& rays, std::span<RayRoot> roots,
                           const std::vector<bool>& falls, bool branches) {
    constexpr double before = 1.0 / 64;  // in pixels
    std::vector<RayRoot*> asked;
    values.clear();
    for (std::size_t i = 0; i < roots.size(); ++i) {
        RayRoot& root = roots[i];
        if (!branches && root.found && (root.slope < 0.0) == falls[i]) continue;
        const double step = before * rays.pixel() * (rays.distance() + root.s);
        values.ask(root.col, root.row,
                   root.s - std::max(root.found ? 0.0 : step, 2.0 * rays.tolerance()));
        asked.push_back(&root);
    }
    values.evaluate();
    for (std::size_t i = 0; i < asked.size(); ++i)
        take_gradient(*asked[i], values, i);
}

}  // namespace

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
    take_gradients_before(values, rays, roots, falls, frame.kernel.branches);
    for (std::size_t i = 0; i < roots.size(); ++i) {
        RayRoot& root = roots[i];
        if ((root.slope < 0.0) == falls[i]) continue;
        // Turn it until it is upright on the ray, and a little more.
        const glm::dvec3 along = ray_direction(rays, root.col, root.row);
        const double least = 1e-3 * glm::length(root.gradient) * glm::length(along);
        const double change = (falls[i] ? -least : least) - root.slope;
        root.gradient += change / glm::dot(along, along) * along;
    }
}

}  // namespace zeroset
