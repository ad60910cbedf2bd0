#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/finished_mesh.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace zeroset {

void drop_unused(TriangleMesh& mesh) {
    constexpr std::uint32_t unused = ~std::uint32_t{0};
    std::vector<std::uint32_t> numbers(mesh.vertices.size(), unused);
    std::vector<MeshVertex> kept;
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& v : triangle) {
            if (numbers[v] == unused) {
                numbers[v] = static_cast<std::uint32_t>(kept.size());
                kept.push_back(mesh.vertices[v]);
            }
            v = numbers[v];
        }
    }
    mesh.vertices = std::move(kept);
}

namespace {

glm::dvec3 middle_of(const TriangleMesh& mesh, const Triangle& t) {
    return (mesh.vertices[t[0]].point + mesh.vertices[t[1]].point + mesh.vertices[t[2]].point) /
           3.0;
}

/// How well a triangle lies on the zeros of a part: the cosine between their normals, less the
/// distance in sizes of the triangle. A triangle between three points of the line where two parts
/// meet is near both, so that its normal has to tell.
double fit_of(const TriangleMesh& mesh, const Triangle& t, const SolidValue& value) {
    const glm::dvec3& a = mesh.vertices[t[0]].point;
    const glm::dvec3 across =
        glm::cross(mesh.vertices[t[1]].point - a, mesh.vertices[t[2]].point - a);
    const double area = glm::length(across);
    const double turned = area > 0 ? glm::dot(across, value.normal) / area : 0.0;
    const double size =
        glm::distance(mesh.vertices[t[1]].point, a) + glm::distance(mesh.vertices[t[2]].point, a);
    return turned - 4.0 * value.distance() / size;
}

/// The fans of triangles about a vertex: those joined by sides that end there.
std::vector<std::vector<std::uint32_t>> fans_of(const TriangleMesh& mesh, std::uint32_t v,
                                                std::vector<std::uint32_t> star) {
    const auto are_joined = [&](std::uint32_t s, std::uint32_t t) {
        return std::ranges::any_of(mesh.triangles[s], [&](std::uint32_t w) {
            return w != v && std::ranges::find(mesh.triangles[t], w) != mesh.triangles[t].end();
        });
    };
    std::vector<std::vector<std::uint32_t>> fans;
    while (!star.empty()) {
        std::vector<std::uint32_t> fan{star.back()};
        star.pop_back();
        for (std::size_t i = 0; i < fan.size(); ++i) {
            std::erase_if(star, [&, s = fan[i]](std::uint32_t t) {
                const bool joined = are_joined(s, t);
                if (joined) fan.push_back(t);
                return joined;
            });
        }
        fans.push_back(std::move(fan));
    }
    return fans;
}

/// Takes out all but the largest fan about each vertex that has several, as those of slivers at the
/// surface's end; whether there were any.
bool drop_lesser_fans(TriangleMesh& mesh) {
    std::vector<std::vector<std::uint32_t>> stars(mesh.vertices.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const std::uint32_t v : mesh.triangles[t])
            stars[v].push_back(t);
    }
    std::vector<bool> dropped(mesh.triangles.size());
    bool any = false;
    for (std::uint32_t v = 0; v < stars.size(); ++v) {
        auto fans = fans_of(mesh, v, std::move(stars[v]));
        std::ranges::sort(fans, std::ranges::greater(), &std::vector<std::uint32_t>::size);
        for (std::size_t i = 1; i < fans.size(); ++i) {
            for (const std::uint32_t t : fans[i])
                any = dropped[t] = true;
        }
    }
    std::size_t kept = 0;
    for (std::size_t t = 0; t < dropped.size(); ++t) {
        if (!dropped[t]) mesh.triangles[kept++] = mesh.triangles[t];
    }
    mesh.triangles.resize(kept);
    return any;
}

}  // namespace

void keep_surface(TriangleMesh& mesh, const MeshSolid& solid) {
    const std::size_t count = mesh.triangles.size();
    std::vector<PartPlace> places(count);
    for (std::size_t i = 0; i < count; ++i)
        places[i].point = middle_of(mesh, mesh.triangles[i]);
    std::vector<double> best(count, -1e300);
    std::vector<bool> wanted(count);
    const std::size_t parts = solid.parts.size() + solid.cuts.size();
    for (std::size_t part = 0; part < parts; ++part) {
        for (PartPlace& place : places)
            place.part = static_cast<std::uint32_t>(part);
        const std::vector<SolidValue> values = parts_at(solid, places);
        for (std::size_t i = 0; i < count; ++i) {
            const double fit = fit_of(mesh, mesh.triangles[i], values[i]);
            if (!(fit > best[i])) continue;
            best[i] = fit;
            wanted[i] = part < solid.surface_parts;
        }
    }
    // A triangle across the surface's end has a vertex beyond it.
    const auto is_beyond = [&](std::uint32_t v) {
        const MeshVertex& vertex = mesh.vertices[v];
        return vertex.kind == VertexKind::Smooth && vertex.part >= solid.surface_parts;
    };
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (wanted[i] && std::ranges::none_of(mesh.triangles[i], is_beyond))
            mesh.triangles[kept++] = mesh.triangles[i];
    }
    mesh.triangles.resize(kept);
    while (drop_lesser_fans(mesh)) {
    }
    drop_unused(mesh);
}

}  // namespace zeroset
