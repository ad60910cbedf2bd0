#include "engine/mesh/contour.hpp"
#include "engine/mesh/field_at_points.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

// Vertices keep so much of an edge's length from its ends, so that no two of them meet.
constexpr double apart = 1e-5;
constexpr double narrow = 1e-13;
constexpr int most_steps = 64;

/// A root that is looked for: t runs from 0 inside to 1 outside.
struct Search {
    std::uint32_t bracket;
    double lo = 0.0, hi = 1.0, t = 0.5;
    double width = 1.0;  ///< of [lo, hi] two steps ago
};

/// Where Newton's method goes from t, if that is inside the bracket and narrows it; else the
/// middle.
double next_place(const Search& search, double level, double slope) {
    const double newton = search.t - level / slope;
    const bool good = std::isfinite(newton) && newton > search.lo && newton < search.hi;
    return good ? newton : 0.5 * (search.lo + search.hi);
}

/// Takes in the value at t; returns whether the search is over.
bool take_step(Search& search, const SolidValue& value, const glm::dvec3& along, int step) {
    (value.inside() ? search.lo : search.hi) = search.t;
    if (value.level == 0.0 || search.hi - search.lo < narrow) return true;
    const double next = next_place(search, value.level, glm::dot(value.normal, along));
    // Newton's steps that leave the bracket wide for long are bisected.
    const bool slow = step % 4 == 3 && search.hi - search.lo > 0.25 * search.width;
    if (step % 4 == 3) search.width = search.hi - search.lo;
    const double place = slow ? 0.5 * (search.lo + search.hi) : next;
    const bool settled = !slow && std::abs(place - search.t) < narrow;
    search.t = place;
    return settled;
}

glm::dvec3 point_at(const CrossedEdge& bracket, double t) {
    return bracket.inside + t * (bracket.outside - bracket.inside);
}

/// Takes all searches a step further and keeps those that are not over; `places` gets the ends.
void step_all(const MeshSolid& solid, const std::vector<CrossedEdge>& brackets,
              std::vector<Search>& searches, std::vector<double>& places, int step,
              const MeshWork& work) {
    std::vector<glm::dvec3> points;
    points.reserve(searches.size());
    for (const Search& search : searches)
        points.push_back(point_at(brackets[search.bracket], search.t));
    const std::vector<SolidValue> values = field_at(solid, points, work);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < searches.size(); ++i) {
        Search search = searches[i];
        const CrossedEdge& bracket = brackets[search.bracket];
        const bool over = take_step(search, values[i], bracket.outside - bracket.inside, step);
        places[search.bracket] = std::clamp(search.t, apart, 1.0 - apart);
        if (!over) searches[kept++] = search;
    }
    searches.resize(kept);
}

/// Where a search ended at an end of its edge, and the surface is not there, there is no root, as
/// where simplify_unproved turned a vertex: such places go to the edge's middle.
void settle_rootless(const MeshSolid& solid, const std::vector<CrossedEdge>& brackets,
                     std::vector<SolidValue>& values, std::vector<glm::dvec3>& points,
                     const MeshWork& work) {
    std::vector<std::size_t> rootless;
    std::vector<glm::dvec3> middles;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const CrossedEdge& edge = brackets[i];
        const double near = 2 * apart * glm::distance(edge.inside, edge.outside);
        const bool at_end = std::min(glm::distance(points[i], edge.inside),
                                     glm::distance(points[i], edge.outside)) < near;
        if (!at_end || values[i].distance() <= near) continue;
        rootless.push_back(i);
        middles.push_back(point_at(edge, 0.5));
    }
    const std::vector<SolidValue> there = field_at(solid, middles, work);
    for (std::size_t k = 0; k < rootless.size(); ++k) {
        const CrossedEdge& edge = brackets[rootless[k]];
        points[rootless[k]] = middles[k];
        values[rootless[k]] = there[k];
        // f and its gradient there tell nothing of the mesh; the surface is in one of these cells.
        values[rootless[k]].level = glm::distance(edge.inside, edge.outside);
        values[rootless[k]].normal = glm::dvec3(0.0);
    }
}

MeshVertex vertex_at(const glm::dvec3& point, const SolidValue& value) {
    return {.point = point,
            .normal = value.normal,
            .kind = VertexKind::Smooth,
            .part = value.part,
            .error = static_cast<float>(value.distance())};
}

}  // namespace

std::vector<MeshVertex> find_roots(const MeshSolid& solid, const std::vector<CrossedEdge>& brackets,
                                   const MeshWork& work) {
    std::vector<double> places(brackets.size(), 0.5);
    std::vector<Search> searches(brackets.size());
    for (std::uint32_t i = 0; i < brackets.size(); ++i)
        searches[i].bracket = i;
    for (int step = 0; step < most_steps && !searches.empty() && !work.limit.over(); ++step)
        step_all(solid, brackets, searches, places, step, work);
    std::vector<glm::dvec3> points(brackets.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = point_at(brackets[i], places[i]);
    std::vector<SolidValue> values = field_at(solid, points, work);
    settle_rootless(solid, brackets, values, points, work);
    std::vector<MeshVertex> vertices(brackets.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i] = vertex_at(points[i], values[i]);
    return vertices;
}

}  // namespace zeroset
