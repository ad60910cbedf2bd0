#include "engine/draw/bezier_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

// Least squares for the lengths of the two end tangents, whose directions are known, with the
// points' parameters by chord length, improved by Newton's method; a piece that is too far from a
// point is divided there [Schneider90]. Unlike there, directions are the curve's own.

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

struct Farthest {
    std::size_t point;
    double distance;
};

Farthest farthest(const Bezier& curve, std::span<const PagePoint> points,
                  std::span<const double> parameters) {
    Farthest found{.point = points.size() / 2, .distance = 0.0};
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const double distance = glm::distance(point_of(curve, parameters[i]), points[i].place);
        if (distance > found.distance) found = {.point = i, .distance = distance};
    }
    return found;
}

void fit(std::span<const PagePoint> points, double tolerance, std::vector<Bezier>& out) {
    constexpr int rounds = 6;
    constexpr double hopeless = 8.0;
    std::vector<double> parameters = chord_parameters(points);
    Bezier curve = least_squares(points, parameters);
    Farthest worst = farthest(curve, points, parameters);
    for (int i = 0; i < rounds && worst.distance > tolerance; ++i) {
        if (worst.distance > hopeless * tolerance && i > 1) break;
        improve(curve, points, parameters);
        curve = least_squares(points, parameters);
        worst = farthest(curve, points, parameters);
    }
    if (worst.distance <= tolerance || points.size() < 3) {
        out.push_back(curve);
        return;
    }
    fit(points.first(worst.point + 1), tolerance, out);
    fit(points.subspan(worst.point), tolerance, out);
}

}  // namespace

glm::dvec2 point_of(const Bezier& c, double t) {
    const double r = 1.0 - t;
    return r * r * r * c[0] + 3.0 * r * r * t * c[1] + 3.0 * r * t * t * c[2] + t * t * t * c[3];
}

std::vector<Bezier> fitted(std::span<const PagePoint> points, double tolerance) {
    std::vector<Bezier> pieces;
    fit(points, tolerance, pieces);
    return pieces;
}

}  // namespace zeroset
