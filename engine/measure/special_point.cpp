#include "engine/measure/special_point.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/real/rounding.hpp"
#include "engine/view/camera.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

// Both kinds of points are zeros of three or four functions r of three unknowns, each divided by a
// length so that all have the unit of f's gradient (L: the clip box's edge, H: the second
// derivatives):
//   singular points   r = (f / L, df/dx, df/dy, df/dz)     J = (gradient / L; H)
//   tops and bottoms  r = (f / L, df/du, df/dv)            J = (gradient / L; uH; vH)
// with u, v of length 1 across `up` and each other. Newton's step is the shortest d of least
// |r + J d|, so that where all points of a curve qualify the one nearby is found.

namespace zeroset {
namespace {

/// The starts lie about `from` in shells of these radii, parts of the clip box's edge.
constexpr std::array<double, 5> shells{0.0, 0.02, 0.06, 0.15, 0.35};
/// Newton's method converges slowly, by halves or thirds, where the singularity is degenerate.
constexpr int most_steps = 150;
/// A step below this part of the clip box's edge ends the search from a start.
constexpr double last_step = 1e-10;
/// Largest values that count as 0, as parts of the gradient's size about `from`.
constexpr double zero_f = 1e-10;  // per length of the clip box's edge
constexpr double zero_slope = 1e-7;

/// f, its gradient and its second derivatives at a point.
struct Jet {
    double f = 0.0;
    glm::dvec3 gradient{0.0};
    glm::dmat3 second{0.0};
};

std::vector<Jet> jets_at(const DerivedFormula& formula, const Uniforms& uniforms,
                         std::span<const glm::dvec3> points) {
    PointBatch<double> batch(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        batch.set(i, points[i].x, points[i].y, points[i].z);
    batch.pad();
    std::vector<Jet> jets(points.size());
    const auto gradient = [&batch](std::size_t i) {
        return glm::dvec3(batch.gradient(0, i), batch.gradient(1, i), batch.gradient(2, i));
    };
    const UpwardRounding upward;
    formula.f.value(batch.batch(uniforms.points<double>()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        jets[i].f = batch.f(i);
        jets[i].gradient = gradient(i);
    }
    for (int axis = 0; axis < 3; ++axis) {
        formula.slopes.at(static_cast<std::size_t>(axis))
            .value(batch.batch(uniforms.points<double>()));
        for (std::size_t i = 0; i < points.size(); ++i)
            jets[i].second[axis] = gradient(i);
    }
    return jets;
}

/// The least-squares step of r + J d, of the rows added one by one.
class NewtonStep {
public:
    void add(double r, const glm::dvec3& j) {
        for (int i = 0; i < 3; ++i)
            squares_[i] += j[i] * j;
        slope_ += r * j;
    }
    /// Directions in which J hardly changes anything are left alone.
    [[nodiscard]] glm::dvec3 taken() const {
        constexpr double damping = 1e-13;
        const double size = squares_[0][0] + squares_[1][1] + squares_[2][2];
        if (!(size > 0.0)) return glm::dvec3(0.0);
        glm::dmat3 damped = squares_;
        for (int i = 0; i < 3; ++i)
            damped[i][i] += damping * size;
        return -(glm::inverse(damped) * slope_);
    }

private:
    glm::dmat3 squares_{0.0};
    glm::dvec3 slope_{0.0};
};

class SpecialPointFinder {
public:
    SpecialPointFinder(const DerivedFormula& formula, const Uniforms& uniforms,
                       const SpecialSearch& search)
        : formula_(formula),
          uniforms_(uniforms),
          search_(search),
          axes_(front_axes(search.up)),
          size_(search.clip.size()) {}

    std::optional<SpecialPoint> find();

private:
    enum class Wanted : std::uint8_t { Singular, Level };

    [[nodiscard]] std::vector<glm::dvec3> starts(double radius) const;
    [[nodiscard]] glm::dvec3 step(const Jet& jet, Wanted wanted) const;
    void search_from(std::vector<glm::dvec3> points, Wanted wanted);
    void take(const glm::dvec3& point, const Jet& jet, Wanted wanted);
    [[nodiscard]] std::optional<SpecialKind> kind_of_level(const Jet& jet) const;
    [[nodiscard]] bool is_shown(const glm::dvec3& point) const;

    const DerivedFormula& formula_;
    const Uniforms& uniforms_;
    const SpecialSearch& search_;
    glm::dmat3 axes_;  ///< two of them level, the third up
    double size_;
    double usual_slope_ = 0.0;  ///< the largest of the gradients about `from`
    std::optional<SpecialPoint> best_;
};

std::optional<SpecialPoint> SpecialPointFinder::find() {
    for (const Jet& jet : jets_at(formula_, uniforms_, starts(shells[2] * size_))) {
        const double slope = glm::length(jet.gradient);
        if (std::isfinite(slope)) usual_slope_ = std::max(usual_slope_, slope);
    }
    if (!(usual_slope_ > 0.0)) return std::nullopt;
    for (const double shell : shells) {
        const double radius = shell * size_;
        const std::vector<glm::dvec3> from = starts(radius);
        search_from(from, Wanted::Singular);
        search_from(from, Wanted::Level);
        // Farther starts lead to points that are hardly nearer.
        if (best_ && glm::distance(best_->at, search_.from) <= radius) break;
    }
    return best_;
}

/// The point itself, or the directions to the 26 neighbours of a cell at this radius.
std::vector<glm::dvec3> SpecialPointFinder::starts(double radius) const {
    if (radius == 0.0) return {search_.from};
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 27; ++i) {
        const glm::dvec3 way(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (way != glm::dvec3(0.0)) points.push_back(search_.from + radius * glm::normalize(way));
    }
    return points;
}

glm::dvec3 SpecialPointFinder::step(const Jet& jet, Wanted wanted) const {
    NewtonStep step;
    step.add(jet.f / size_, jet.gradient / size_);
    if (wanted == Wanted::Singular) {
        for (int axis = 0; axis < 3; ++axis)
            step.add(jet.gradient[axis], jet.second[axis]);
    } else {
        for (int axis = 0; axis < 2; ++axis)
            step.add(glm::dot(jet.gradient, axes_[axis]), jet.second * axes_[axis]);
    }
    return step.taken();
}

/// Newton's method from all points at once; those that end or get lost drop out.
void SpecialPointFinder::search_from(std::vector<glm::dvec3> points, Wanted wanted) {
    const double longest = 0.25 * size_;
    for (int i = 0; i < most_steps && !points.empty(); ++i) {
        const std::vector<Jet> jets = jets_at(formula_, uniforms_, points);
        std::vector<glm::dvec3> left;
        for (std::size_t k = 0; k < points.size(); ++k) {
            glm::dvec3 way = step(jets[k], wanted);
            const double length = glm::length(way);
            if (!std::isfinite(length)) continue;
            if (length <= last_step * size_) {
                take(points[k], jets[k], wanted);
                continue;
            }
            if (length > longest) way *= longest / length;
            const glm::dvec3 next = points[k] + way;
            if (glm::distance(next, search_.from) <= 2.0 * size_) left.push_back(next);
        }
        points = std::move(left);
    }
    // At degenerate singularities the last digits come slowly.
    if (points.empty()) return;
    const std::vector<Jet> jets = jets_at(formula_, uniforms_, points);
    for (std::size_t k = 0; k < points.size(); ++k)
        take(points[k], jets[k], wanted);
}

/// Keeps the point where a search has ended if it is what was wanted, and the nearest.
void SpecialPointFinder::take(const glm::dvec3& point, const Jet& jet, Wanted wanted) {
    if (best_ && glm::distance(point, search_.from) >= glm::distance(best_->at, search_.from))
        return;
    const double slope = glm::length(jet.gradient);
    if (!(std::abs(jet.f) <= zero_f * usual_slope_ * size_) || !is_shown(point)) return;
    if (wanted == Wanted::Singular) {
        if (slope > zero_slope * usual_slope_) return;
        best_ = {.at = point, .kind = SpecialKind::Singular, .f = jet.f, .slope = slope};
        return;
    }
    // Close to a singular point the surface is bent more than any top that could be seen.
    constexpr double sharpest = 1e-5;  // radius, as a part of the clip box's edge
    const double bend =
        glm::length(jet.second[0]) + glm::length(jet.second[1]) + glm::length(jet.second[2]);
    if (slope <= sharpest * size_ * bend || slope <= zero_slope * usual_slope_) return;
    if (const auto kind = kind_of_level(jet))
        best_ = {.at = point, .kind = *kind, .f = jet.f, .slope = slope};
}

/// Where the surface is level: by the second derivatives of its height above u and v, which are
/// those of f there, divided by -df/dup.
std::optional<SpecialKind> SpecialPointFinder::kind_of_level(const Jet& jet) const {
    const glm::dvec3& u = axes_[0];
    const glm::dvec3& v = axes_[1];
    const double rise = glm::dot(jet.gradient, axes_[2]);
    const double aslant = std::hypot(glm::dot(jet.gradient, u), glm::dot(jet.gradient, v));
    if (!(aslant <= zero_slope * std::abs(rise))) return std::nullopt;
    const double uu = -glm::dot(u, jet.second * u) / rise;
    const double uv = -glm::dot(u, jet.second * v) / rise;
    const double vv = -glm::dot(v, jet.second * v) / rise;
    const double mean = 0.5 * (uu + vv);
    const double spread = std::hypot(0.5 * (uu - vv), uv);
    const double bend = std::abs(mean) + spread;
    constexpr double flat = 1e-6;  // per length of the clip box's edge
    constexpr double along_a_ridge = 1e-5;
    if (!(bend * size_ > flat)) return std::nullopt;
    if (mean + spread <= along_a_ridge * bend) return SpecialKind::Top;
    if (mean - spread >= -along_a_ridge * bend) return SpecialKind::Bottom;
    return std::nullopt;
}

bool SpecialPointFinder::is_shown(const glm::dvec3& point) const {
    const double slack = 1e-9 * size_;
    return search_.clip.contains(point, slack) && search_.region.contains(point, slack);
}

}  // namespace

std::optional<SpecialPoint> nearest_special_point(const DerivedFormula& formula,
                                                  const Uniforms& uniforms,
                                                  const SpecialSearch& search) {
    return SpecialPointFinder(formula, uniforms, search).find();
}

}  // namespace zeroset
