#include "engine/draw/page_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

// Least squares for the lengths of the two end tangents, whose directions are known, with the
// points' parameters by chord length, improved by Newton's method [Schneider90]. Unlike there,
// directions are the curve's own, and each piece goes as far as the tolerance lets it, so that
// there are few.

namespace zeroset {
namespace {

glm::dvec2 derivative_of(const Bezier& c, double t) {
    const double r = 1.0 - t;
    return 3.0 * (r * r * (c[1] - c[0]) + 2.0 * r * t * (c[2] - c[1]) + t * t * (c[3] - c[2]));
}

glm::dvec2 second_derivative_of(const Bezier& c, double t) {
    return 6.0 * ((1.0 - t) * (c[2] - 2.0 * c[1] + c[0]) + t * (c[3] - 2.0 * c[2] + c[1]));
}

std::vector<double> chord_parameters(std::span<const PagePoint> points) {
    std::vector<double> t{0.0};
    for (std::size_t i = 1; i < points.size(); ++i)
        t.push_back(t.back() + glm::distance(points[i].place, points[i - 1].place));
    for (double& at : t)
        at = t.back() > 0.0 ? at / t.back() : 0.0;
    t.back() = 1.0;
    return t;
}

/// The cubic with the points' ends and directions that is nearest to them at the parameters.
Bezier least_squares(std::span<const PagePoint> points, std::span<const double> parameters) {
    const PagePoint& a = points.front();
    const PagePoint& b = points.back();
    double c00 = 0.0;
    double c01 = 0.0;
    double c11 = 0.0;
    double x0 = 0.0;
    double x1 = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double t = parameters[i];
        const double r = 1.0 - t;
        const glm::dvec2 by_a = 3.0 * r * r * t * a.tangent;
        const glm::dvec2 by_b = -3.0 * r * t * t * b.tangent;
        const glm::dvec2 rest =
            points[i].place - r * r * (r + 3.0 * t) * a.place - t * t * (t + 3.0 * r) * b.place;
        c00 += glm::dot(by_a, by_a);
        c01 += glm::dot(by_a, by_b);
        c11 += glm::dot(by_b, by_b);
        x0 += glm::dot(by_a, rest);
        x1 += glm::dot(by_b, rest);
    }
    const double chord = glm::distance(a.place, b.place);
    const double size = c00 * c11 - c01 * c01;
    double from_a = (x0 * c11 - x1 * c01) / size;
    double from_b = (x1 * c00 - x0 * c01) / size;
    const double least = 1e-3 * chord;
    const double most = 4.0 * chord;
    if (!(from_a > least && from_b > least && from_a < most && from_b < most))
        from_a = from_b = chord / 3.0;
    return {a.place, a.place + from_a * a.tangent, b.place - from_b * b.tangent, b.place};
}

/// Moves the parameters to where the curve is nearest to the points.
void improve(const Bezier& curve, std::span<const PagePoint> points, std::span<double> parameters) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        double& t = parameters[i];
        const glm::dvec2 off = point_of(curve, t) - points[i].place;
        const glm::dvec2 slope = derivative_of(curve, t);
        const double by = glm::dot(slope, slope) + glm::dot(off, second_derivative_of(curve, t));
        if (by > 0.0) t = std::clamp(t - glm::dot(off, slope) / by, 0.0, 1.0);
    }
}

double farthest(const Bezier& curve, std::span<const PagePoint> points,
                std::span<const double> parameters) {
    double most = 0.0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        most = std::max(most, glm::distance(point_of(curve, parameters[i]), points[i].place));
    return most;
}

struct Fit {
    Bezier curve;
    double distance;
};

/// The cubic that is nearest to the points, as far as some rounds find it.
Fit best_fit(std::span<const PagePoint> points, double tolerance) {
    constexpr int most_rounds = 20;
    constexpr double hopeless = 30.0;
    constexpr double too_slow = 0.98;
    std::vector<double> parameters = chord_parameters(points);
    Fit best{.curve = least_squares(points, parameters), .distance = 0.0};
    best.distance = farthest(best.curve, points, parameters);
    for (int i = 0; i < most_rounds && best.distance > tolerance; ++i) {
        if (best.distance > hopeless * tolerance) break;
        improve(best.curve, points, parameters);
        const Bezier curve = least_squares(points, parameters);
        const double distance = farthest(curve, points, parameters);
        const bool gains = distance < too_slow * best.distance;
        if (distance < best.distance) best = {.curve = curve, .distance = distance};
        if (!gains) break;
    }
    return best;
}

/// How many of the points, from the first on, one cubic can follow, and that cubic; at least two.
std::pair<std::size_t, Bezier> longest_fit(std::span<const PagePoint> points, double tolerance) {
    std::size_t good = 2;
    std::size_t bad = points.size() + 1;
    Bezier curve = least_squares(points.first(2), chord_parameters(points.first(2)));
    for (std::size_t next = points.size(); good + 1 < bad; next = (good + bad) / 2) {
        const Fit fit = best_fit(points.first(next), tolerance);
        if (fit.distance <= tolerance) {
            good = next;
            curve = fit.curve;
        } else {
            bad = next;
        }
    }
    return {good, curve};
}

}  // namespace

glm::dvec2 point_of(const Bezier& c, double t) {
    const double r = 1.0 - t;
    return r * r * r * c[0] + 3.0 * r * r * t * c[1] + 3.0 * r * t * t * c[2] + t * t * t * c[3];
}

std::vector<Bezier> fitted(std::span<const PagePoint> points, double tolerance) {
    std::vector<Bezier> pieces;
    while (points.size() > 1) {
        const auto [count, curve] = longest_fit(points, tolerance);
        pieces.push_back(curve);
        points = points.subspan(count - 1);
    }
    return pieces;
}

}  // namespace zeroset
