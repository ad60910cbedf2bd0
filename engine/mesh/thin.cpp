#include "engine/mesh/collapsible_mesh.hpp"
#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/mesh_steps.hpp"
#include "engine/mesh/parallel.hpp"
#include "engine/real/unbounded.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace zeroset {
namespace {

// The least shape of new triangles, unless the old ones were worse.
constexpr double least_shape_kept = 0.15;
// Normals of a new triangle and of its smooth vertices, of it and of the one before at features.
constexpr double least_turn = 0.6;

/// The sum of squared distances from planes, weighted by area.
struct Quadric {
    glm::dmat3 a{0.0};
    glm::dvec3 b{0.0};
    double c = 0.0;

    void add_plane(const glm::dvec3& normal, const glm::dvec3& point, double weight) {
        const double offset = glm::dot(normal, point);
        a += weight * glm::outerProduct(normal, normal);
        b -= weight * offset * normal;
        c += weight * offset * offset;
    }
    void add(const Quadric& other) {
        a += other.a;
        b += other.b;
        c += other.c;
    }
    [[nodiscard]] double at(const glm::dvec3& p) const {
        return std::abs(glm::dot(p, a * p) + 2.0 * glm::dot(b, p) + c);
    }
};

/// A vertex that may go into a neighbour.
struct Move {
    std::uint32_t from = 0, into = 0;
    double cost = unbounded;
};

class Thinner {
public:
    Thinner(TriangleMesh mesh, const MeshSolid& solid, const ThinOptions& options);
    TriangleMesh run();

private:
    using Change = CollapsibleMesh::Change;

    [[nodiscard]] Move best_move(std::uint32_t from) const;
    [[nodiscard]] double cost_of(std::uint32_t from, std::uint32_t into) const;
    [[nodiscard]] bool keeps_features(std::uint32_t from, std::uint32_t into) const;
    [[nodiscard]] bool keeps_shape(const std::vector<Change>& changes) const;
    [[nodiscard]] bool keeps_normals(const Change& change) const;
    [[nodiscard]] bool is_crease(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] glm::dvec3 across(const Triangle& t) const {
        return area_vector(mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2]));
    }
    [[nodiscard]] double shape(const Triangle& t) const {
        return shape_of(mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2]));
    }
    void find_moves();
    [[nodiscard]] std::vector<Move> found_moves() const;
    [[nodiscard]] std::vector<Move> independent(std::vector<Move> moves) const;
    void add_samples(const Triangle& triangle, std::vector<glm::dvec3>& points) const;
    std::size_t apply(const std::vector<Move>& moves);
    void make(const Move& move);

    CollapsibleMesh mesh_;
    const MeshSolid& solid_;
    ThinOptions options_;
    std::vector<Quadric> quadrics_;
    std::vector<float> detail_;          ///< the longest edge that was at a vertex
    std::vector<Move> moves_;            ///< the best of each vertex, if there is one
    std::vector<std::uint8_t> changed_;  ///< whether it is to be found anew
};

Thinner::Thinner(TriangleMesh mesh, const MeshSolid& solid, const ThinOptions& options)
    : mesh_(std::move(mesh)),
      solid_(solid),
      options_(options),
      quadrics_(mesh_.size()),
      detail_(mesh_.size(), std::numeric_limits<float>::max()),
      moves_(mesh_.size()),
      changed_(mesh_.size(), 1) {
    for (std::uint32_t v = 0; v < mesh_.size(); ++v) {
        double longest = 0.0;
        for (const std::uint32_t t : mesh_.star(v)) {
            const Triangle& triangle = mesh_.triangle(t);
            const glm::dvec3 vector = across(triangle);
            const double area = glm::length(vector);
            if (area > 0) quadrics_[v].add_plane(vector / area, mesh_.point(triangle[0]), area);
            for (const std::uint32_t other : triangle)
                longest = std::max(longest, glm::distance(mesh_.point(v), mesh_.point(other)));
        }
        detail_[v] = static_cast<float>(longest);
    }
}

/// Whether the two triangles at an edge meet at an angle.
bool Thinner::is_crease(std::uint32_t a, std::uint32_t b) const {
    constexpr double bent = 0.94;
    std::array<glm::dvec3, 2> normals{};
    std::size_t count = 0;
    for (const std::uint32_t t : mesh_.star(a)) {
        const Triangle& triangle = mesh_.triangle(t);
        if (count < 2 && std::ranges::find(triangle, b) != triangle.end())
            normals[count++] = across(triangle);
    }
    const double sizes = glm::length(normals[0]) * glm::length(normals[1]);
    return glm::dot(normals[0], normals[1]) < bent * sizes;
}

bool Thinner::keeps_features(std::uint32_t from, std::uint32_t into) const {
    switch (mesh_.vertex(from).kind) {
        case VertexKind::Smooth: return true;
        case VertexKind::Corner: return false;
        case VertexKind::Crease:
            return mesh_.vertex(into).kind != VertexKind::Smooth && is_crease(from, into);
    }
    return false;
}

bool Thinner::keeps_normals(const Change& change) const {
    const glm::dvec3 after = across(change.after);
    const double area = glm::length(after);
    bool smooth = true;
    for (const std::uint32_t v : change.after) {
        const MeshVertex& vertex = mesh_.vertex(v);
        if (vertex.kind != VertexKind::Smooth || vertex.normal == glm::dvec3(0.0)) {
            smooth = false;
        } else if (glm::dot(vertex.normal, after) < least_turn * area) {
            return false;
        }
    }
    if (smooth) return true;
    const glm::dvec3 before = across(change.before);
    return glm::dot(before, after) >= least_turn * area * glm::length(before);
}

bool Thinner::keeps_shape(const std::vector<Change>& changes) const {
    double before = 1.0;
    double after = 1.0;
    for (const Change& change : changes) {
        before = std::min(before, shape(change.before));
        after = std::min(after, shape(change.after));
    }
    return after > std::min(before, least_shape_kept);
}

double Thinner::cost_of(std::uint32_t from, std::uint32_t into) const {
    const glm::dvec3 way = mesh_.point(into) - mesh_.point(from);
    // Where all is flat, short edges go first.
    constexpr double share_of_length = 1e-6;
    const double length = glm::dot(way, way);
    return quadrics_[from].at(mesh_.point(into)) + share_of_length * length * length;
}

Move Thinner::best_move(std::uint32_t from) const {
    static thread_local std::vector<std::uint32_t> ring;
    static thread_local std::vector<Move> moves;
    static thread_local std::vector<Change> changes;
    mesh_.ring(from, ring);
    moves.clear();
    for (const std::uint32_t into : ring)
        moves.push_back({.from = from, .into = into, .cost = cost_of(from, into)});
    std::ranges::sort(moves, {}, &Move::cost);
    for (const Move& move : moves) {
        if (!keeps_features(from, move.into) || !mesh_.may_collapse(from, move.into, ring))
            continue;
        mesh_.changes(from, move.into, changes);
        const bool turned = !std::ranges::all_of(
            changes, [&](const Change& change) { return keeps_normals(change); });
        if (!turned && keeps_shape(changes)) return move;
    }
    return {};
}

void Thinner::find_moves() {
    parallel_upward(mesh_.size(), 1024, options_.work, [&](std::size_t first, std::size_t last) {
        if (options_.work.limit.over()) return;
        for (std::size_t i = first; i < last; ++i) {
            const auto v = static_cast<std::uint32_t>(i);
            if (changed_[i] == 0) continue;
            changed_[i] = 0;
            moves_[i] = mesh_.star(v).empty() ? Move() : best_move(v);
        }
    });
}

std::vector<Move> Thinner::found_moves() const {
    std::vector<Move> found;
    for (const Move& move : moves_) {
        if (move.cost != unbounded) found.push_back(move);
    }
    return found;
}

/// The cheapest moves whose triangles no other of them changes.
std::vector<Move> Thinner::independent(std::vector<Move> moves) const {
    std::ranges::sort(moves, {}, &Move::cost);
    // The dearest of a pass would keep cheaper ones of the next from being made.
    moves.resize((moves.size() + 1) / 2);
    std::vector<bool> taken(mesh_.size());
    std::vector<std::uint32_t> ring;
    std::erase_if(moves, [&](const Move& move) {
        mesh_.ring(move.from, ring);
        ring.push_back(move.from);
        if (std::ranges::any_of(ring, [&](std::uint32_t v) { return taken[v]; })) return true;
        for (const std::uint32_t v : ring)
            taken[v] = true;
        return false;
    });
    return moves;
}

/// Points of a triangle, as close together as details were before.
void Thinner::add_samples(const Triangle& triangle, std::vector<glm::dvec3>& points) const {
    const glm::dvec3& a = mesh_.point(triangle[0]);
    const glm::dvec3 ab = mesh_.point(triangle[1]) - a;
    const glm::dvec3 ac = mesh_.point(triangle[2]) - a;
    const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
    double detail = unbounded;
    for (const std::uint32_t v : triangle)
        detail = std::min(detail, double{detail_[v]});
    const double wanted = longest / std::max(detail, 0.02 * longest);
    // An even number, so that the middles of the sides are among them.
    const int parts = 2 * static_cast<int>(std::clamp(std::ceil(0.5 * wanted), 1.0, 6.0));
    points.push_back(a + (ab + ac) / 3.0);
    for (int i = 0; i <= parts; ++i) {
        for (int k = 0; i + k <= parts; ++k) {
            const bool corner = (i == 0 && k == 0) || i == parts || k == parts;
            if (corner) continue;
            points.push_back(a + (static_cast<double>(i) * ab + static_cast<double>(k) * ac) /
                                     static_cast<double>(parts));
        }
    }
}

void Thinner::make(const Move& move) {
    static thread_local std::vector<std::uint32_t> ring;
    static thread_local std::vector<std::uint32_t> beyond;
    mesh_.ring(move.from, ring);
    for (const std::uint32_t v : ring) {
        changed_[v] = 1;
        // Whether these may go into v depends on what is about v.
        mesh_.ring(v, beyond);
        for (const std::uint32_t other : beyond) {
            if (moves_[other].cost != unbounded && moves_[other].into == v) changed_[other] = 1;
        }
    }
    quadrics_[move.into].add(quadrics_[move.from]);
    detail_[move.into] = std::min(detail_[move.into], detail_[move.from]);
    mesh_.collapse(move.from, move.into);
    moves_[move.from] = {};
}

/// Makes the moves whose new triangles keep the tolerance; returns how many these are.
std::size_t Thinner::apply(const std::vector<Move>& moves) {
    std::vector<glm::dvec3> points;
    std::vector<std::size_t> ends;
    std::vector<Change> changes;
    for (const Move& move : moves) {
        mesh_.changes(move.from, move.into, changes);
        for (const Change& change : changes)
            add_samples(change.after, points);
        ends.push_back(points.size());
    }
    const std::vector<SolidValue> values = field_at(solid_, points, options_.work);
    std::size_t made = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const auto own = std::span(values).subspan(first, ends[i] - first);
        first = ends[i];
        const bool near = std::ranges::all_of(
            own, [&](const SolidValue& value) { return value.distance() <= options_.tolerance; });
        if (near && (options_.most_triangles == 0 || mesh_.triangles() > options_.most_triangles)) {
            make(moves[i]);
            ++made;
        } else {
            moves_[moves[i].from] = {};
        }
    }
    return made;
}

TriangleMesh Thinner::run() {
    constexpr int most_passes = 200;
    constexpr std::size_t few = 2'000;  // a part in so many of the vertices is not worth a pass
    for (int pass = 0; pass < most_passes && !options_.work.limit.over(); ++pass) {
        find_moves();
        std::vector<Move> moves = found_moves();
        if (moves.empty()) break;
        const std::size_t made = apply(independent(std::move(moves)));
        if (options_.most_triangles > 0 && mesh_.triangles() <= options_.most_triangles) break;
        if (pass > 20 && made < mesh_.triangles() / few) break;
    }
    return mesh_.finish();
}

}  // namespace

void thin(TriangleMesh& mesh, const MeshSolid& solid, const ThinOptions& options) {
    mesh = Thinner(std::move(mesh), solid, options).run();
}

}  // namespace zeroset
