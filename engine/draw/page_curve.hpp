#pragma once

#include "engine/draw/curve_system.hpp"
#include "engine/draw/drawing.hpp"
#include "engine/draw/page.hpp"
#include "engine/draw/space_curve.hpp"
#include "engine/trace/time_limit.hpp"

#include <glm/glm.hpp>

#include <functional>
#include <span>
#include <vector>

namespace zeroset {

/// A point of a curve on the page with the curve's direction there, of length 1.
struct PagePoint {
    glm::dvec2 place;
    glm::dvec2 tangent;
};

glm::dvec2 point_of(const Bezier& curve, double t);

/// Cubic pieces through the first and the last point, with their directions where they meet, no
/// farther than `tolerance` from all points between [Schneider90]. At least two points.
std::vector<Bezier> fitted(std::span<const PagePoint> points, double tolerance);

/// The curve with as many more points that those next to each other are near on the page, and its
/// direction there turns little between them; fewer if the time is over.
SpaceCurve refined(const CurveSystem& system, const SpaceCurve& curve, const Page& page,
                   const TimeLimit& limit);

/// A part of a curve in one state; with the others of its curve it makes up the whole, each begins
/// where the one before ends.
struct CurveRun {
    SpaceCurve curve;
    int state = 0;
};

/// The state of a point of a curve, of those into which it is to be divided.
using StateAt = std::function<int(const CurvePoint&)>;

/// Divides a curve where the state changes between two of its points; `states` has that of each.
/// The places are found by halving, to a small part of a point on the page.
std::vector<CurveRun> divided(const CurveSystem& system, const SpaceCurve& curve, const Page& page,
                              const std::vector<int>& states, const StateAt& state_at);

}  // namespace zeroset
