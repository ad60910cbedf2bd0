#pragma once

#include "engine/draw/curve_cells.hpp"
#include "engine/draw/space_curve.hpp"

#include <functional>
#include <optional>

namespace zeroset {

/// The curve through a point of it, both ways as far as the domain goes, or until steps get too
/// short beside singular points. `start` is on the curve, `longest_step` tells how far a step may
/// go from a place; nothing where the curve has no direction at the start.
struct TraceLimits {
    std::function<double(const glm::dvec3&)> longest_step;
    double shortest_step = 0.0;
    std::size_t most_points = 200'000;
    TimeLimit time = {};
};
struct TracedCurve {
    SpaceCurve curve;
    int stuck_ends = 0;  ///< ends within the domain
};
std::optional<TracedCurve> trace_curve(const CurveSystem& system, const CurveDomain& domain,
                                       const glm::dvec3& start, const TraceLimits& limits);

/// The point of the curve a step from `from` along its tangent; nothing where Newton's method finds
/// none or the curve turns too much.
std::optional<CurvePoint> stepped(const CurveSystem& system, const CurvePoint& from, double step);

}  // namespace zeroset
