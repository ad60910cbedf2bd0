#include "engine/mesh/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace zeroset {
namespace {

// The least shape of new triangles, unless the old ones were worse.
constexpr double least_shape_kept = 0.15;
constexpr double least_shape_of_flat = 0.02;
// Normals of a new triangle and of its smooth vertices, of it and of the one before at features.
constexpr double least_turn = 0.6;
// The directions of narrower triangles are not to be trusted.
constexpr double least_shape_asked = 1e-3;

bool has(const Triangle& triangle, std::uint32_t v) {
    return std::ranges::find(triangle, v) != triangle.end();
}

double distance_from_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 ab = b - a;
    const double square = glm::dot(ab, ab);
    const double t = square > 0 ? std::clamp(glm::dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * ab);
}

}  // namespace

void Quadric::add_plane(const glm::dvec3& normal, const glm::dvec3& point, double weight) {
    const double offset = glm::dot(normal, point);
    const glm::dvec3 n = weight * normal;
    a[0] += n.x * normal.x;
    a[1] += n.x * normal.y;
    a[2] += n.x * normal.z;
    a[3] += n.y * normal.y;
    a[4] += n.y * normal.z;
    a[5] += n.z * normal.z;
    b -= offset * n;
    c += weight * offset * offset;
}

void Quadric::add(const Quadric& other) {
    for (std::size_t i = 0; i < a.size(); ++i)
        a[i] += other.a[i];
    b += other.b;
    c += other.c;
}

double Quadric::at(const glm::dvec3& p) const {
    const double squares = p.x * (a[0] * p.x + 2.0 * (a[1] * p.y + a[2] * p.z + b.x)) +
                           p.y * (a[3] * p.y + 2.0 * (a[4] * p.z + b.y)) +
                           p.z * (a[5] * p.z + 2.0 * b.z);
    return std::abs(squares + c);
}

Thinning::Thinning(TriangleMesh mesh, double tolerance)
    : mesh_(std::move(mesh)),
      tolerance_(tolerance),
      quadrics_(mesh_.size()),
      detail_(mesh_.size(), std::numeric_limits<float>::max()),
      lost_(mesh_.size()) {
    if (mesh_.size() > 0) origin_ = mesh_.point(0);
    for (std::uint32_t v = 0; v < mesh_.size(); ++v) {
        double longest = 0.0;
        for (const std::uint32_t t : mesh_.star(v)) {
            const Triangle& triangle = mesh_.triangle(t);
            const glm::dvec3 vector = across(triangle);
            const double area = glm::length(vector);
            if (area > 0)
                quadrics_[v].add_plane(vector / area, mesh_.point(triangle[0]) - origin_, area);
            for (const std::uint32_t other : triangle) {
                const glm::dvec3 way = mesh_.point(v) - mesh_.point(other);
                longest = std::max(longest, glm::dot(way, way));
            }
        }
        detail_[v] = static_cast<float>(std::sqrt(longest));
    }
}

double Thinning::cost_of(std::uint32_t from, std::uint32_t into) const {
    const glm::dvec3 way = mesh_.point(into) - mesh_.point(from);
    // Where all is flat, short edges go first.
    constexpr double share_of_length = 1e-6;
    const double length = glm::dot(way, way);
    const glm::dvec3 p = mesh_.point(into) - origin_;
    const double off = quadrics_[from].at(p) + quadrics_[into].at(p);
    return off + share_of_length * length * length;
}

float Thinning::least_cost(std::uint32_t from) const {
    double least = Collapse::unbounded_cost;
    // Each neighbour comes second in one of the triangles, counted from `from`.
    for (const std::uint32_t t : mesh_.star(from)) {
        const Triangle& triangle = mesh_.triangle(t);
        const std::size_t k = triangle[0] == from ? 1 : triangle[1] == from ? 2 : 0;
        least = std::min(least, cost_of(from, triangle[k]));
    }
    return static_cast<float>(least);
}

Collapse Thinning::best_collapse(std::uint32_t from) const {
    static thread_local std::vector<std::uint32_t> ring;
    static thread_local std::vector<Collapse> all;
    mesh_.ring(from, ring);
    all.clear();
    for (const std::uint32_t into : ring)
        all.push_back(
            {.from = from, .into = into, .cost = static_cast<float>(cost_of(from, into))});
    std::ranges::sort(all, {}, &Collapse::cost);
    for (const Collapse& collapse : all) {
        if (!collapse.exists()) break;
        if (keeps_features(from, collapse.into) && mesh_.may_collapse(from, collapse.into, ring) &&
            keeps_triangles(from, collapse.into) && keeps_creases(from, collapse.into))
            return collapse;
    }
    return {};
}

/// Whether two vertices are as good as one, as where several triangles found the same corner.
bool Thinning::is_same_place(std::uint32_t a, std::uint32_t b) const {
    constexpr double share_of_tolerance = 1e-3;
    return glm::distance(mesh_.point(a), mesh_.point(b)) < share_of_tolerance * tolerance_;
}

/// Whether all that has gone into `from` lies in planes through `into`, as far as it matters.
bool Thinning::is_flat(std::uint32_t from, std::uint32_t into) const {
    const Quadric& quadric = quadrics_[from];
    const glm::dvec3 p = mesh_.point(into) - origin_;
    // The quadric's value has a rounding of some 1e-15 of its terms.
    const double off = std::max(1e-6 * tolerance_, 1e-7 * glm::length(p));
    return quadric.at(p) < off * off * (quadric.a[0] + quadric.a[3] + quadric.a[5]);
}

/// Whether the two triangles at an edge meet at an angle.
bool Thinning::is_crease(std::uint32_t a, std::uint32_t b) const {
    constexpr double bent = 0.94;
    std::array<glm::dvec3, 2> normals{};
    std::size_t count = 0;
    for (const std::uint32_t t : mesh_.star(a)) {
        const Triangle& triangle = mesh_.triangle(t);
        if (count < 2 && has(triangle, b)) normals.at(count++) = across(triangle);
    }
    const double sizes = glm::length(normals[0]) * glm::length(normals[1]);
    return glm::dot(normals[0], normals[1]) < bent * sizes;
}

bool Thinning::keeps_features(std::uint32_t from, std::uint32_t into) const {
    const VertexKind kind = mesh_.vertex(from).kind;
    if (kind == VertexKind::Smooth) return true;
    if (is_same_place(from, into)) return kind <= mesh_.vertex(into).kind;
    return kind == VertexKind::Crease && mesh_.vertex(into).kind != VertexKind::Smooth &&
           is_crease(from, into);
}

/// The vertices to which a crease goes on from v.
void Thinning::crease_neighbours(std::uint32_t v, std::uint32_t without,
                                 std::vector<std::uint32_t>& found) const {
    static thread_local std::vector<std::uint32_t> ring;
    mesh_.ring(v, ring);
    found.clear();
    for (const std::uint32_t other : ring) {
        if (other != without && mesh_.vertex(other).kind != VertexKind::Smooth &&
            is_crease(v, other))
            found.push_back(other);
    }
}

/// Whether the places that a crease went through stay within the tolerance of it.
bool Thinning::keeps_creases(std::uint32_t from, std::uint32_t into) const {
    if (mesh_.vertex(from).kind != VertexKind::Crease || is_same_place(from, into)) return true;
    static thread_local std::vector<std::uint32_t> before;
    crease_neighbours(from, into, before);
    if (before.size() != 1) return true;
    const glm::dvec3& a = mesh_.point(before[0]);
    const glm::dvec3& b = mesh_.point(into);
    const auto is_near = [&](const glm::dvec3& p) {
        return distance_from_segment(p, a, b) <= tolerance_;
    };
    // Places that are still nearer to the crease beyond the ends are those of other segments.
    const auto stays = [&](const glm::dvec3& p, const glm::dvec3& end) {
        const glm::dvec3& mine = mesh_.point(from);
        return is_near(p) || distance_from_segment(p, end, mine) > tolerance_;
    };
    const auto all = [&](std::uint32_t v, const glm::dvec3& end) {
        return std::ranges::all_of(lost_[v], [&](const glm::dvec3& p) { return stays(p, end); });
    };
    return is_near(mesh_.point(from)) && std::ranges::all_of(lost_[from], is_near) &&
           all(before[0], a) && all(into, b);
}

bool Thinning::keeps_normal(const Triangle& before, const Triangle& after) const {
    const glm::dvec3 vector = across(after);
    const double area = glm::length(vector);
    bool smooth = true;
    for (const std::uint32_t v : after) {
        const MeshVertex& vertex = mesh_.vertex(v);
        if (vertex.kind != VertexKind::Smooth || vertex.normal == glm::dvec3(0.0)) {
            smooth = false;
        } else if (glm::dot(vertex.normal, vector) < least_turn * area) {
            return false;
        }
    }
    if (smooth) return true;
    const glm::dvec3 old = across(before);
    return glm::dot(old, vector) >= least_turn * area * glm::length(old);
}

/// Whether no triangle turns over or gets too narrow.
bool Thinning::keeps_triangles(std::uint32_t from, std::uint32_t into) const {
    double least_before = 1.0;
    double least_after = 1.0;
    const bool same_place = is_same_place(from, into);
    for (const std::uint32_t t : mesh_.star(from)) {
        const Triangle& before = mesh_.triangle(t);
        if (has(before, into)) continue;
        Triangle after = before;
        std::ranges::replace(after, from, into);
        const double shape_before = shape(before);
        if (same_place && shape_before < least_shape_asked) continue;
        if (!keeps_normal(before, after)) return false;
        least_before = std::min(least_before, shape_before);
        least_after = std::min(least_after, shape(after));
    }
    const double wanted = is_flat(from, into) ? least_shape_of_flat : least_shape_kept;
    return same_place || least_after > std::min(least_before, wanted);
}

void Thinning::new_triangles(const Collapse& collapse, std::vector<Triangle>& triangles) const {
    triangles.clear();
    for (const std::uint32_t t : mesh_.star(collapse.from)) {
        Triangle triangle = mesh_.triangle(t);
        if (has(triangle, collapse.into)) continue;
        std::ranges::replace(triangle, collapse.from, collapse.into);
        triangles.push_back(triangle);
    }
}

void Thinning::add_middles(std::span<const Triangle> triangles, std::uint32_t into,
                           std::vector<glm::dvec3>& points) const {
    for (const Triangle& t : triangles) {
        points.push_back((mesh_.point(t[0]) + mesh_.point(t[1]) + mesh_.point(t[2])) / 3.0);
        // The other side at `into` is that of a neighbour among the new triangles, or is old.
        const std::size_t k = t[0] == into ? 1 : t[1] == into ? 2 : 0;
        points.push_back(0.5 * (mesh_.point(into) + mesh_.point(t[k])));
    }
}

/// How many parts a triangle's sides have between samples; an even number, so that their middles
/// are samples.
int Thinning::parts_of(const Triangle& triangle) const {
    const glm::dvec3& a = mesh_.point(triangle[0]);
    const glm::dvec3 ab = mesh_.point(triangle[1]) - a;
    const glm::dvec3 ac = mesh_.point(triangle[2]) - a;
    const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
    double detail = unbounded;
    for (const std::uint32_t v : triangle)
        detail = std::min(detail, double{detail_[v]});
    const double wanted = longest / std::max(detail, 0.02 * longest);
    return 2 * static_cast<int>(std::clamp(std::ceil(0.5 * wanted), 1.0, 6.0));
}

void Thinning::add_samples(std::span<const Triangle> triangles,
                           std::vector<glm::dvec3>& points) const {
    for (const Triangle& triangle : triangles) {
        const int parts = parts_of(triangle);
        if (parts == 2) continue;
        const glm::dvec3& a = mesh_.point(triangle[0]);
        const glm::dvec3 ab = (mesh_.point(triangle[1]) - a) / double(parts);
        const glm::dvec3 ac = (mesh_.point(triangle[2]) - a) / double(parts);
        for (int i = 0; i <= parts; ++i) {
            for (int k = 0; i + k <= parts; ++k) {
                const bool corner = (i == 0 && k == 0) || i == parts || k == parts;
                if (!corner) points.push_back(a + double(i) * ab + double(k) * ac);
            }
        }
    }
}

void Thinning::make(const Collapse& collapse) {
    const auto [from, into, cost] = collapse;
    if (mesh_.vertex(from).kind != VertexKind::Smooth) {
        mesh_.raise_kind(into, mesh_.vertex(from).kind);
        std::ranges::move(lost_[from], std::back_inserter(lost_[into]));
        lost_[into].push_back(mesh_.point(from));
        lost_[from].clear();
    }
    quadrics_[into].add(quadrics_[from]);
    detail_[into] = std::min(detail_[into], detail_[from]);
    mesh_.collapse(from, into);
}

}  // namespace zeroset
