#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/mesh/finished_mesh.hpp"
#include "engine/mesh/place_index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <vector>

namespace zeroset {
namespace {

glm::dvec3 across(const std::vector<glm::dvec3>& points, const Triangle& t) {
    return glm::cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
}

std::unexpected<std::string> refusal(const char* why, const glm::dvec3& where) {
    return std::unexpected(filled(why, {short_number(where.x, 4) + "," + short_number(where.y, 4) +
                                        "," + short_number(where.z, 4)}));
}

std::vector<glm::dvec3> points_of(const TriangleMesh& mesh) {
    std::vector<glm::dvec3> points;
    points.reserve(mesh.vertices.size());
    for (const MeshVertex& vertex : mesh.vertices)
        points.push_back(vertex.point);
    return points;
}

/// The sums of what triangles give their corners: those with a smooth vertex alone, as the
/// direction of one between vertices of edges may be that of what ends the surface; for corners
/// without such triangles what their neighbours have, or else what all triangles give.
std::vector<glm::dvec3> sums_across(const TriangleMesh& mesh,
                                    const std::vector<glm::dvec3>& points) {
    const std::vector<glm::dvec3> none(points.size(), glm::dvec3(0.0));
    std::vector<glm::dvec3> smooth = none;
    std::vector<glm::dvec3> any = none;
    for (const Triangle& t : mesh.triangles) {
        const glm::dvec3 vector = across(points, t);
        const bool has_smooth = std::ranges::any_of(
            t, [&](std::uint32_t v) { return mesh.vertices[v].kind == VertexKind::Smooth; });
        for (const std::uint32_t v : t) {
            any[v] += vector;
            if (has_smooth) smooth[v] += vector;
        }
    }
    std::vector<glm::dvec3> beside = none;
    for (const Triangle& t : mesh.triangles) {
        for (const std::uint32_t v : t)
            beside[v] += smooth[t[0]] + smooth[t[1]] + smooth[t[2]];
    }
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (smooth[v] == glm::dvec3(0.0)) smooth[v] = beside[v];
        if (smooth[v] == glm::dvec3(0.0)) smooth[v] = any[v];
    }
    return smooth;
}

/// Normals of vertices: the surface's, elsewhere the mean of the triangles' by their areas.
std::vector<glm::dvec3> normals_of(const TriangleMesh& mesh,
                                   const std::vector<glm::dvec3>& points) {
    std::vector<glm::dvec3> normals = sums_across(mesh, points);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const glm::dvec3 mean = glm::normalize(normals[v]);
        const MeshVertex& vertex = mesh.vertices[v];
        const bool own = vertex.kind == VertexKind::Smooth && glm::dot(vertex.normal, mean) > 0.5;
        normals[v] = own ? vertex.normal : mean;
    }
    return normals;
}

/// Points in cubes of an edge, for those near a place.
class PointGrid {
public:
    PointGrid(const std::vector<glm::dvec3>& points, double edge) : points_(points), edge_(edge) {
        for (std::uint32_t v = 0; v < points.size(); ++v)
            cubes_[key(cube_of(points[v]))].push_back(v);
    }
    /// Whether a point is nearer than `distance`, at most the edge.
    [[nodiscard]] bool has_near(const glm::dvec3& place, double distance) const {
        const glm::ivec3 middle = cube_of(place);
        for (int i = 0; i < 27; ++i) {
            const auto found = cubes_.find(key(middle + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1));
            if (found == cubes_.end()) continue;
            for (const std::uint32_t v : found->second) {
                if (glm::distance(points_[v], place) < distance) return true;
            }
        }
        return false;
    }

private:
    [[nodiscard]] glm::ivec3 cube_of(const glm::dvec3& point) const {
        return glm::ivec3(glm::floor(point / edge_));
    }
    static std::uint64_t key(const glm::ivec3& cube) {
        constexpr int half = 1 << 20;
        const auto part = [](int i) { return static_cast<std::uint64_t>(i + half) & 0x1FFFFFU; };
        return part(cube.x) | part(cube.y) << 21U | part(cube.z) << 42U;
    }

    const std::vector<glm::dvec3>& points_;
    double edge_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cubes_;
};

/// The edges with one triangle, as that one runs along them.
std::vector<std::array<std::uint32_t, 2>> open_edges(const TriangleMesh& mesh) {
    KeyIndex edges(3 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k)
            edges.add(pair_key(t[k], t[(k + 1) % 3]));
    }
    std::vector<std::array<std::uint32_t, 2>> open;
    for (const std::uint64_t key : edges.keys()) {
        const auto a = static_cast<std::uint32_t>(key >> 32U);
        const auto b = static_cast<std::uint32_t>(key);
        if (edges.find(pair_key(b, a)) == KeyIndex::none) open.push_back({a, b});
    }
    return open;
}

/// A surface's points with their normals; at the surface's end triangles may lean towards
/// what ended it: they are not asked.
struct SideSource {
    const std::vector<glm::dvec3>& points;
    const std::vector<glm::dvec3>& normals;
    std::vector<bool> at_end;

    [[nodiscard]] bool ends(const Triangle& t) const {
        return at_end[t[0]] || at_end[t[1]] || at_end[t[2]];
    }
};

/// Why a triangle does not keep its direction where its corners are `moved`, if so.
std::optional<std::string> turned(const SideSource& source, const Triangle& t,
                                  const std::vector<glm::dvec3>& moved) {
    const glm::dvec3 before = across(source.points, t);
    for (const std::uint32_t v : t) {
        if (glm::dot(source.normals[v], before) < 0.7 * glm::length(before))
            return refusal(tr("the surface has an edge near {0}"), source.points[v]).error();
    }
    if (glm::dot(before, across(moved, t)) < 0.01 * glm::dot(before, before))
        return refusal(tr("the surface bends too much for this wall near {0}"), source.points[t[0]])
            .error();
    return std::nullopt;
}

/// Why the surface cannot have a wall of two sides at `half` along its normals, if so.
std::optional<std::string> defect(const TriangleMesh& mesh, const std::vector<glm::dvec3>& points,
                                  const std::vector<glm::dvec3>& normals, double half,
                                  double tolerance) {
    SideSource source{
        .points = points, .normals = normals, .at_end = std::vector<bool>(points.size())};
    for (const auto& [a, b] : open_edges(mesh))
        source.at_end[a] = source.at_end[b] = true;
    for (const double side : {half, -half}) {
        std::vector<glm::dvec3> moved(points.size());
        for (std::size_t v = 0; v < points.size(); ++v)
            moved[v] = points[v] + side * normals[v];
        for (const Triangle& t : mesh.triangles) {
            if (source.ends(t)) continue;
            if (auto wrong = turned(source, t, moved)) return wrong;
        }
        const PointGrid grid(points, half);
        for (std::size_t v = 0; v < points.size(); ++v) {
            if (half > 2 * tolerance && grid.has_near(moved[v], half - 2 * tolerance))
                return refusal(tr("the wall would meet itself near {0}"), points[v]).error();
        }
    }
    return std::nullopt;
}

}  // namespace

std::expected<TriangleMesh, std::string> wall_of(const TriangleMesh& surface, double thickness,
                                                 double tolerance) {
    const double half = 0.5 * thickness;
    const std::vector<glm::dvec3> points = points_of(surface);
    const std::vector<glm::dvec3> normals = normals_of(surface, points);
    if (auto wrong = defect(surface, points, normals, half, tolerance))
        return std::unexpected(*wrong);
    const auto count = static_cast<std::uint32_t>(points.size());
    TriangleMesh wall;
    for (const double side : {1.0, -1.0}) {
        for (std::uint32_t v = 0; v < count; ++v) {
            MeshVertex vertex = surface.vertices[v];
            vertex.point += side * half * normals[v];
            vertex.normal = side * normals[v];
            vertex.kind = VertexKind::Smooth;
            wall.vertices.push_back(vertex);
        }
    }
    for (const Triangle& t : surface.triangles) {
        wall.triangles.push_back(t);
        wall.triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
    }
    for (const auto& [a, b] : open_edges(surface)) {
        wall.triangles.push_back({b, a, a + count});
        wall.triangles.push_back({b, a + count, b + count});
        for (const std::uint32_t v : {a, b, a + count, b + count})
            wall.vertices[v].kind = VertexKind::Crease;
    }
    return wall;
}

}  // namespace zeroset
