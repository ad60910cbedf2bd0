#include "engine/draw/curve_tracer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

// Predictor and corrector: a step along the tangent, then Newton's method on the plane across it.
// Steps are halved where the curve turns, or where Newton's method goes far; cells in which the
// curve is proved to be alone bound them, so that no step leads to another branch.

namespace zeroset {
namespace {

constexpr double least_cosine = 0.94;  ///< of the angle by which the tangent turns in a step
constexpr double most_aside = 0.25;    ///< of a corrector, in steps
constexpr double growth = 1.5;
/// How much longer a step may be than one that begins at its end.
constexpr double most_leap = 3.0;

/// One way along a curve.
class Walk {
public:
    Walk(const CurveSystem& system, const CurveDomain& domain, const TraceLimits& limits,
         const CurvePoint& start)
        : system_(system), domain_(domain), limits_(limits), start_(start) {
        points_.push_back(start);
        step_ = limits.longest_step(start.place);
    }

    enum class End : std::uint8_t { Closed, Left, Stuck };
    End run() {
        while (points_.size() < limits_.most_points && !limits_.time.over()) {
            if (const auto end = advance()) return *end;
        }
        return End::Stuck;
    }
    std::vector<CurvePoint>& points() { return points_; }

private:
    std::optional<End> advance();
    [[nodiscard]] bool closes(const CurvePoint& from, double step) const;
    void leave(double step);

    const CurveSystem& system_;
    const CurveDomain& domain_;
    const TraceLimits& limits_;
    CurvePoint start_;
    std::vector<CurvePoint> points_;
    double step_ = 0.0;
};

std::optional<Walk::End> Walk::advance() {
    const CurvePoint from = points_.back();
    step_ = std::min(step_, limits_.longest_step(from.place));
    for (;; step_ *= 0.5) {
        if (step_ < limits_.shortest_step) return End::Stuck;
        const auto next = stepped(system_, from, step_);
        if (!next || step_ > most_leap * limits_.longest_step(next->place)) continue;
        if (closes(from, step_)) return End::Closed;
        if (!domain_.contains(next->place)) {
            leave(step_);
            return End::Left;
        }
        points_.push_back(*next);
        step_ *= growth;
        return std::nullopt;
    }
}

/// Whether the curve comes back to its start within the step.
bool Walk::closes(const CurvePoint& from, double step) const {
    if (points_.size() < 3) return false;
    const glm::dvec3 to = start_.place - from.place;
    const double along = glm::dot(to, from.tangent);
    if (!(along > 0.0 && along <= step * 1.01 && glm::length(to - along * from.tangent) <= step))
        return false;
    const auto there = stepped(system_, from, along);
    return there && glm::distance(there->place, start_.place) <= 1e-6 * step &&
           glm::dot(there->tangent, start_.tangent) > 0.0;
}

/// Goes on to where the curve leaves the domain, at most a step away.
void Walk::leave(double step) {
    constexpr int halvings = 40;
    const CurvePoint from = points_.back();
    double inside = 0.0;
    double outside = step;
    std::optional<CurvePoint> last;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * inside + 0.5 * outside;
        const auto point = stepped(system_, from, middle);
        const bool is_in = point && domain_.contains(point->place);
        if (is_in) last = point;
        (is_in ? inside : outside) = middle;
    }
    if (last && inside > 0x1p-20 * step) points_.push_back(*last);
}

CurvePoint reversed(const CurvePoint& point) {
    return {.place = point.place, .tangent = -point.tangent};
}

}  // namespace

glm::dvec3 between(const CurvePoint& a, const CurvePoint& b, double share) {
    const double length = glm::distance(a.place, b.place);
    const double s = share;
    const double r = 1.0 - share;
    return r * r * (1.0 + 2.0 * s) * a.place + s * s * (1.0 + 2.0 * r) * b.place +
           length * (r * r * s * a.tangent - s * s * r * b.tangent);
}

std::optional<CurvePoint> stepped(const CurveSystem& system, const CurvePoint& from, double step) {
    const glm::dvec3 guess = from.place + step * from.tangent;
    const auto place = system.point_near(guess, from.tangent, most_aside * step);
    if (!place) return std::nullopt;
    const Linearized there = system.at(*place);
    if (!there.is_usable()) return std::nullopt;
    const double cosine = glm::dot(there.tangent(), from.tangent);
    if (!(std::abs(cosine) >= least_cosine)) return std::nullopt;
    return CurvePoint{.place = *place,
                      .tangent = cosine > 0.0 ? there.tangent() : -there.tangent()};
}

std::optional<TracedCurve> trace_curve(const CurveSystem& system, const CurveDomain& domain,
                                       const glm::dvec3& start, const TraceLimits& limits) {
    const Linearized there = system.at(start);
    if (!there.is_usable()) return std::nullopt;
    const CurvePoint first{.place = start, .tangent = there.tangent()};
    TracedCurve traced;
    Walk onward(system, domain, limits, first);
    const Walk::End end = onward.run();
    if (end == Walk::End::Closed) {
        traced.curve = {.points = std::move(onward.points()), .closed = true};
        return traced;
    }
    Walk backward(system, domain, limits, reversed(first));
    const Walk::End begin = backward.run();
    traced.stuck_ends = (end == Walk::End::Stuck ? 1 : 0) + (begin == Walk::End::Stuck ? 1 : 0);
    for (const CurvePoint& point : backward.points())
        traced.curve.points.push_back(reversed(point));
    std::ranges::reverse(traced.curve.points);
    traced.curve.points.insert(traced.curve.points.end(), onward.points().begin() + 1,
                               onward.points().end());
    if (traced.curve.points.size() < 2) return std::nullopt;
    return traced;
}

}  // namespace zeroset
