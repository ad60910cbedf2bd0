#include "engine/mesh/collapsible_mesh.hpp"
#include "engine/mesh/feature_point.hpp"
#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/mesh_steps.hpp"
#include "engine/mesh/place_index.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace zeroset {
namespace {

/// The nearest edge of a triangle at each vertex: how far a vertex may go without turning one over.
std::vector<double> shortest_edges(const TriangleMesh& mesh) {
    std::vector<double> shortest(mesh.vertices.size(), 1e300);
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k];
            const std::uint32_t b = t[(k + 1) % 3];
            const double length = glm::distance(mesh.vertices[a].point, mesh.vertices[b].point);
            shortest[a] = std::min(shortest[a], length);
            shortest[b] = std::min(shortest[b], length);
        }
    }
    return shortest;
}

std::vector<SolidValue> values_at(const MeshSolid& solid, const std::vector<PartsMeeting>& creases,
                                  const MeshWork& work) {
    std::vector<glm::dvec3> points;
    points.reserve(creases.size());
    for (const PartsMeeting& crease : creases)
        points.push_back(crease.point);
    return field_at(solid, points, work);
}

/// Puts vertices on sides of triangles that cross an edge of the solid.
class SideSplitter {
public:
    SideSplitter(const MeshSolid& solid, double step, Contour& contour, const MeshWork& work)
        : solid_(solid), step_(step), contour_(contour), work_(work) {}
    void split();

private:
    using Side = std::array<std::uint32_t, 2>;

    void find_sides();
    [[nodiscard]] bool may_split(const Side& side, const glm::dvec3& point) const;
    void split_side(const Side& side, const glm::dvec3& point);
    [[nodiscard]] const MeshVertex& vertex(std::uint32_t v) const {
        return contour_.mesh.vertices[v];
    }
    /// The corner of a side's triangle that is not on it.
    [[nodiscard]] std::uint32_t opposite(std::uint32_t a, std::uint32_t b) const {
        const Triangle& t = contour_.mesh.triangles[triangles_.at(pair_key(a, b))];
        return *std::ranges::find_if(t, [&](std::uint32_t v) { return v != a && v != b; });
    }

    const MeshSolid& solid_;
    double step_;
    Contour& contour_;
    const MeshWork& work_;
    std::vector<Side> sides_;                           ///< each once
    std::map<std::uint64_t, std::uint32_t> triangles_;  ///< by their sides, as these run
};

/// Finds sides whose ends are on different parts, neither on an edge of the solid.
void SideSplitter::find_sides() {
    for (std::uint32_t t = 0; t < contour_.mesh.triangles.size(); ++t) {
        const Triangle& triangle = contour_.mesh.triangles[t];
        for (std::size_t k = 0; k < 3; ++k) {
            const Side side{triangle.at(k), triangle.at((k + 1) % 3)};
            const MeshVertex& a = vertex(side[0]);
            const MeshVertex& b = vertex(side[1]);
            const bool smooth = a.kind == VertexKind::Smooth && b.kind == VertexKind::Smooth;
            if (!smooth || a.part == b.part) continue;
            triangles_[pair_key(side[0], side[1])] = t;
            if (side[0] < side[1]) sides_.push_back(side);
        }
    }
}

/// Whether the triangles that a vertex at the point makes face outwards, as those of a's side do
/// there, and those of b's.
bool SideSplitter::may_split(const Side& side, const glm::dvec3& point) const {
    const auto [a, b] = side;
    const MeshVertex& first = vertex(a);
    const MeshVertex& second = vertex(b);
    const double length = glm::distance(first.point, second.point);
    if (!(glm::distance(point, 0.5 * (first.point + second.point)) < length)) return false;
    const glm::dvec3& c = vertex(opposite(a, b)).point;
    const glm::dvec3& d = vertex(opposite(b, a)).point;
    const auto faces = [](const MeshVertex& of, const glm::dvec3& across) {
        return glm::dot(of.normal, across) > 0.0;
    };
    return faces(first, area_vector(first.point, point, c)) &&
           faces(first, area_vector(point, first.point, d)) &&
           faces(second, area_vector(point, second.point, c)) &&
           faces(second, area_vector(second.point, point, d));
}

void SideSplitter::split_side(const Side& side, const glm::dvec3& point) {
    const auto [a, b] = side;
    const std::uint32_t c = opposite(a, b);
    const std::uint32_t d = opposite(b, a);
    TriangleMesh& mesh = contour_.mesh;
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back({.point = point, .kind = VertexKind::Crease, .part = vertex(a).part});
    const auto divide = [&](std::uint32_t from, std::uint32_t to, std::uint32_t tip) {
        const std::uint32_t triangle = triangles_.at(pair_key(from, to));
        const auto other = static_cast<std::uint32_t>(mesh.triangles.size());
        mesh.triangles[triangle] = {from, middle, tip};
        mesh.triangles.push_back({middle, to, tip});
        contour_.tetrahedra.push_back(contour_.tetrahedra[triangle]);
        const auto moved = triangles_.find(pair_key(to, tip));
        if (moved != triangles_.end()) moved->second = other;
    };
    divide(a, b, c);
    divide(b, a, d);
}

void SideSplitter::split() {
    find_sides();
    std::vector<PartsMeeting> creases;
    creases.reserve(sides_.size());
    for (const auto& [a, b] : sides_) {
        creases.push_back({.parts = {vertex(a).part, vertex(b).part},
                           .point = 0.5 * (vertex(a).point + vertex(b).point)});
    }
    approach_meetings(solid_, creases);
    const std::vector<SolidValue> values = values_at(solid_, creases, work_);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        const bool on_surface = values[i].distance() < 1e-6 * step_;
        if (on_surface && may_split(sides_[i], creases[i].point))
            split_side(sides_[i], creases[i].point);
    }
}

}  // namespace

void approach_meetings(const MeshSolid& solid, std::vector<PartsMeeting>& places) {
    constexpr int most_steps = 6;
    for (int i = 0; i < most_steps; ++i) {
        std::vector<PartPlace> asked;
        for (const PartsMeeting& place : places) {
            for (const std::uint32_t part : place.parts)
                asked.push_back({.part = part, .point = place.point});
        }
        const std::vector<SolidValue> values = parts_at(solid, asked);
        std::size_t next = 0;
        for (PartsMeeting& place : places) {
            std::vector<FeatureSide> sides;
            for (const std::uint32_t part : place.parts) {
                const SolidValue& value = values[next++];
                sides.push_back({.base = place.point,
                                 .point = place.point - value.level * value.normal,
                                 .normal = value.normal,
                                 .part = part});
            }
            place.point = meeting_point(sides, place.point).value_or(place.point);
        }
    }
}

void sharpen_creases(const MeshSolid& solid, double step, Contour& contour, const MeshWork& work) {
    const std::vector<double> room = shortest_edges(contour.mesh);
    std::vector<PartsMeeting> creases;
    creases.reserve(contour.creases.size());
    for (const Contour::Crease& crease : contour.creases) {
        creases.push_back({.parts = {crease.parts.begin(), crease.parts.end()},
                           .point = contour.mesh.vertices[crease.vertex].point});
    }
    approach_meetings(solid, creases);
    const std::vector<SolidValue> values = values_at(solid, creases, work);
    for (std::size_t c = 0; c < creases.size(); ++c) {
        const std::uint32_t v = contour.creases[c].vertex;
        MeshVertex& vertex = contour.mesh.vertices[v];
        const bool near =
            glm::distance(creases[c].point, vertex.point) < std::max(0.5 * room[v], 0.01 * step);
        if (near && values[c].distance() < 1e-6 * step) vertex.point = creases[c].point;
    }
}

void split_creased_sides(const MeshSolid& solid, double step, Contour& contour,
                         const MeshWork& work) {
    SideSplitter(solid, step, contour, work).split();
}

}  // namespace zeroset
