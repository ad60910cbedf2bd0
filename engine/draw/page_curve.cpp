#include "engine/draw/page_curve.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace zeroset {
namespace {

constexpr double spacing_pt = 0.75;
/// Points that are nearer are far enough refined, whatever the curve's direction does.
constexpr double least_spacing_pt = 0.04;
constexpr double least_page_cosine = 0.97;
constexpr int deepest = 14;
/// Changes of state are found to this.
constexpr double change_pt = 0.004;

/// The point of the curve halfway between two.
std::optional<CurvePoint> middle_of(const CurveSystem& system, const CurvePoint& a,
                                    const CurvePoint& b) {
    const glm::dvec3 chord = b.place - a.place;
    const double length = glm::length(chord);
    if (!(length > 0.0)) return std::nullopt;
    const auto place = system.point_near(between(a, b, 0.5), chord / length, 0.5 * length);
    if (!place) return std::nullopt;
    const Linearized there = system.at(*place);
    if (!there.is_usable()) return std::nullopt;
    const glm::dvec3 tangent = there.tangent();
    return CurvePoint{.place = *place,
                      .tangent = glm::dot(tangent, chord) > 0.0 ? tangent : -tangent};
}

bool are_near(const Page& page, const CurvePoint& a, const CurvePoint& b) {
    const double apart = glm::distance(page.place(a.place), page.place(b.place));
    if (apart > spacing_pt) return false;
    if (apart < least_spacing_pt) return true;
    const glm::dvec2 at_a = page.motion(a.place, a.tangent);
    const glm::dvec2 at_b = page.motion(b.place, b.tangent);
    return glm::dot(at_a, at_b) >= least_page_cosine * glm::length(at_a) * glm::length(at_b);
}

class Refiner {
public:
    Refiner(const CurveSystem& system, const Page& page, const TimeLimit& limit)
        : system_(system), page_(page), limit_(limit) {}

    /// Adds the points after `a` up to `b`.
    void add(const CurvePoint& a, const CurvePoint& b, int depth, std::vector<CurvePoint>& out) {
        if (depth < deepest && !are_near(page_, a, b) && !limit_.over()) {
            if (const auto middle = middle_of(system_, a, b)) {
                add(a, *middle, depth + 1, out);
                add(*middle, b, depth + 1, out);
                return;
            }
        }
        out.push_back(b);
    }

private:
    const CurveSystem& system_;
    const Page& page_;
    const TimeLimit& limit_;
};

/// The last point before the state of `a` changes on the way to `b`.
CurvePoint change_between(const CurveSystem& system, const Page& page, CurvePoint a, CurvePoint b,
                          int state, const StateAt& state_at) {
    constexpr int most_halvings = 24;
    constexpr int least_halvings = 6;
    for (int i = 0; i < most_halvings; ++i) {
        const double apart = glm::distance(page.place(a.place), page.place(b.place));
        if (i >= least_halvings && apart < change_pt) break;
        const auto middle = middle_of(system, a, b);
        if (!middle) break;
        (state_at(*middle) == state ? a : b) = *middle;
    }
    return a;
}

}  // namespace

SpaceCurve refined(const CurveSystem& system, const SpaceCurve& curve, const Page& page,
                   const TimeLimit& limit) {
    SpaceCurve result{.points = {curve.points.front()}, .closed = curve.closed};
    Refiner refiner(system, page, limit);
    for (std::size_t i = 1; i < curve.points.size(); ++i)
        refiner.add(curve.points[i - 1], curve.points[i], 0, result.points);
    if (curve.closed) {
        refiner.add(curve.points.back(), curve.points.front(), 0, result.points);
        result.points.pop_back();
    }
    return result;
}

std::vector<CurveRun> divided(const CurveSystem& system, const SpaceCurve& curve, const Page& page,
                              const std::vector<int>& states, const StateAt& state_at) {
    const std::size_t count = curve.points.size();
    std::size_t first = 0;
    if (curve.closed) {
        while (first < count && states[first] == states[(first + count - 1) % count])
            ++first;
        if (first == count) return {{.curve = curve, .state = states.front()}};
    }
    std::vector<CurveRun> runs;
    const std::size_t steps = curve.closed ? count : count - 1;
    runs.push_back({.curve = {.points = {curve.points[first]}}, .state = states[first]});
    for (std::size_t k = 1; k <= steps; ++k) {
        const std::size_t last = (first + k - 1) % count;
        const std::size_t i = (first + k) % count;
        if (states[i] != states[last]) {
            const CurvePoint change = change_between(system, page, curve.points[last],
                                                     curve.points[i], states[last], state_at);
            runs.back().curve.points.push_back(change);
            runs.push_back({.curve = {.points = {change}}, .state = states[i]});
        }
        runs.back().curve.points.push_back(curve.points[i]);
    }
    if (curve.closed) {  // the last run is the beginning of the first
        CurveRun beginning = std::move(runs.back());
        runs.pop_back();
        std::vector<CurvePoint>& points = runs.front().curve.points;
        points.insert(points.begin(), beginning.curve.points.begin(),
                      beginning.curve.points.end() - 1);
    }
    return runs;
}

}  // namespace zeroset
