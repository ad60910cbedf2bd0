#include "engine/mesh/feature_point.hpp"
#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/mesh_steps.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <span>

namespace zeroset {
namespace {

/// A tetrahedron's piece of the contour.
struct Piece {
    std::uint32_t tetrahedron;
    std::vector<std::uint32_t> triangles;  ///< one or two
    std::vector<std::uint32_t> ring;       ///< vertices, in order
    std::vector<FeatureSide> sides = {};
    glm::dvec3 near{0.0};
    double edge = 0.0;  ///< of its larger cell
    std::optional<glm::dvec3> feature = std::nullopt;
    bool is_corner = false;
};

glm::dvec3 middle_of(const TriangleMesh& mesh, std::span<const std::uint32_t> ring) {
    glm::dvec3 sum(0.0);
    for (const std::uint32_t vertex : ring)
        sum += mesh.vertices[vertex].point;
    return sum / static_cast<double>(ring.size());
}

/// The pieces in cells with kinks.
class FeatureMaker {
public:
    FeatureMaker(const CellTree& tree, const Lattice& lattice, const MeshSolid& solid,
                 Contour& contour, const MeshWork& work)
        : tree_(tree), lattice_(lattice), solid_(solid), contour_(contour), work_(work) {}
    void make();

private:
    void collect();
    void add_piece(std::uint32_t first, std::uint32_t count);
    void find_corners();
    void find_corner(std::uint32_t cell, std::span<const std::uint32_t> pieces);
    void approach(double share);
    void settle();
    void accept(Piece& piece) const;
    void fan(const Piece& piece);
    void turn_sides();
    [[nodiscard]] std::vector<const MeshVertex*> vertices_of(const Piece& piece) const;

    const CellTree& tree_;
    const Lattice& lattice_;
    const MeshSolid& solid_;
    Contour& contour_;
    const MeshWork& work_;
    std::vector<Piece> pieces_;
    std::size_t first_tip_ = 0;  ///< vertices from there on are those of features
};

void FeatureMaker::add_piece(std::uint32_t first, std::uint32_t count) {
    const Tetrahedron& tetrahedron = lattice_.tetrahedra[contour_.tetrahedra[first]];
    const MeshCell& a = tree_[tetrahedron.cells[0]];
    const MeshCell& b = tree_[tetrahedron.cells[1]];
    if (!a.facts.kinked && !b.facts.kinked) return;
    Piece piece{.tetrahedron = contour_.tetrahedra[first], .triangles = {first}, .ring = {}};
    const Triangle& t = contour_.mesh.triangles[first];
    piece.ring.assign(t.begin(), t.end());
    if (count == 2) {  // as Marcher::add_two makes them
        piece.triangles.push_back(first + 1);
        piece.ring.push_back(contour_.mesh.triangles[first + 1][2]);
    }
    piece.near = middle_of(contour_.mesh, piece.ring);
    piece.edge = std::max(tree_.edge(a), tree_.edge(b));
    piece.sides = sides_of(vertices_of(piece));
    pieces_.push_back(std::move(piece));
}

void FeatureMaker::collect() {
    const auto triangles = static_cast<std::uint32_t>(contour_.mesh.triangles.size());
    for (std::uint32_t i = 0; i < triangles;) {
        const bool two = i + 1 < triangles && contour_.tetrahedra[i + 1] == contour_.tetrahedra[i];
        add_piece(i, two ? 2 : 1);
        i += two ? 2 : 1;
    }
}

std::vector<const MeshVertex*> FeatureMaker::vertices_of(const Piece& piece) const {
    std::vector<const MeshVertex*> vertices;
    vertices.reserve(piece.ring.size());
    for (const std::uint32_t vertex : piece.ring)
        vertices.push_back(&contour_.mesh.vertices[vertex]);
    return vertices;
}

void FeatureMaker::find_corner(std::uint32_t cell, std::span<const std::uint32_t> pieces) {
    std::vector<const MeshVertex*> vertices;
    for (const std::uint32_t piece : pieces)
        std::ranges::copy(vertices_of(pieces_[piece]), std::back_inserter(vertices));
    const std::vector<FeatureSide> sides = sides_of(vertices);
    if (sides.size() < 3) return;
    const Box box = tree_.box(tree_[cell]);
    const auto corner = meeting_point(sides, box.centre());
    if (!corner || glm::any(glm::lessThan(*corner, box.lo)) ||
        glm::any(glm::greaterThan(*corner, box.hi)))
        return;
    const auto nearest = std::ranges::min_element(pieces, {}, [&](std::uint32_t piece) {
        return glm::distance(pieces_[piece].near, *corner);
    });
    Piece& piece = pieces_[*nearest];
    piece.sides = sides;
    piece.near = *corner;
    piece.is_corner = true;
}

/// Gives the corner in each cell, if there is one, to the piece nearest to it.
void FeatureMaker::find_corners() {
    std::map<std::uint32_t, std::vector<std::uint32_t>> of_cells;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
        for (const std::uint32_t cell : lattice_.tetrahedra[pieces_[i].tetrahedron].cells)
            of_cells[cell].push_back(i);
    }
    for (const auto& [cell, pieces] : of_cells)
        find_corner(cell, pieces);
}

/// Finds where the sides' planes meet, taken where they are `share` of the way from there to their
/// bases.
void FeatureMaker::approach(double share) {
    std::vector<glm::dvec3> points;
    std::vector<FeatureSide*> sides;
    for (Piece& piece : pieces_) {
        if (!piece.feature) continue;
        for (FeatureSide& side : piece.sides) {
            points.push_back(*piece.feature + share * (side.base - *piece.feature));
            sides.push_back(&side);
        }
    }
    const std::vector<SolidValue> values = field_at(solid_, points, work_);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const glm::dvec3& normal = values[i].normal;
        // A gradient of another side tells nothing of this one.
        if (!(glm::dot(normal, sides[i]->normal) > 0.8)) continue;
        sides[i]->normal = normal;
        sides[i]->point = points[i] - values[i].level * normal;
    }
    for (Piece& piece : pieces_) {
        if (piece.feature) piece.feature = meeting_point(piece.sides, *piece.feature);
        if (piece.feature) accept(piece);
    }
}

/// Brings features onto the parts that meet there: where a side's plane was taken too far away,
/// they are not there yet.
void FeatureMaker::settle() {
    std::vector<PartsMeeting> places;
    std::vector<Piece*> pieces;
    for (Piece& piece : pieces_) {
        if (!piece.feature) continue;
        std::vector<std::uint32_t> parts;
        parts.reserve(piece.sides.size());
        for (const FeatureSide& side : piece.sides)
            parts.push_back(side.part);
        std::ranges::sort(parts);
        if (std::ranges::adjacent_find(parts) != parts.end()) continue;
        places.push_back({.parts = std::move(parts), .point = *piece.feature});
        pieces.push_back(&piece);
    }
    approach_meetings(solid_, places);
    std::vector<glm::dvec3> points;
    points.reserve(places.size());
    for (const PartsMeeting& place : places)
        points.push_back(place.point);
    const std::vector<SolidValue> values = field_at(solid_, points, work_);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const bool near = glm::distance(points[i], *pieces[i]->feature) < 0.5 * pieces[i]->edge;
        if (near && values[i].distance() < 1e-6 * lattice_.step) pieces[i]->feature = points[i];
    }
}

/// Drops a feature that has left the piece's surroundings.
void FeatureMaker::accept(Piece& piece) const {
    const double reach = 1.2 * piece.edge;
    if (!(glm::distance(*piece.feature, middle_of(contour_.mesh, piece.ring)) < reach))
        piece.feature.reset();
}

/// Replaces the piece's triangles by a fan about its feature.
void FeatureMaker::fan(const Piece& piece) {
    TriangleMesh& mesh = contour_.mesh;
    const auto tip = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back({.point = *piece.feature,
                             .normal = glm::dvec3(0.0),
                             .kind = piece.is_corner || piece.sides.size() > 2 ? VertexKind::Corner
                                                                               : VertexKind::Crease,
                             .part = mesh.vertices[piece.ring[0]].part});
    for (std::size_t i = 0; i < piece.ring.size(); ++i) {
        const Triangle triangle{tip, piece.ring[i], piece.ring[(i + 1) % piece.ring.size()]};
        if (i < piece.triangles.size()) {
            mesh.triangles[piece.triangles[i]] = triangle;
        } else {
            mesh.triangles.push_back(triangle);
            contour_.tetrahedra.push_back(piece.tetrahedron);
        }
    }
}

/// Two triangles of fans and the side that they share.
struct SharedSide {
    std::uint32_t first, second;
};

void FeatureMaker::turn_sides() {
    TriangleMesh& mesh = contour_.mesh;
    const auto is_fan = [&](const Triangle& t) { return t[0] >= first_tip_; };
    std::map<std::uint64_t, std::uint32_t> by_side;
    std::vector<SharedSide> shared;
    std::vector<glm::dvec3> points;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        points.push_back(0.5 * (mesh.vertices[a].point + mesh.vertices[b].point));
    };
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        if (!is_fan(t)) continue;
        const auto other = by_side.find(pair_key(t[2], t[1]));
        if (other == by_side.end()) {
            by_side.emplace(pair_key(t[1], t[2]), i);
            continue;
        }
        shared.push_back({.first = other->second, .second = i});
        middle(t[1], t[2]);
        middle(t[0], mesh.triangles[other->second][0]);
    }
    const std::vector<SolidValue> values = field_at(solid_, points, work_);
    for (std::size_t i = 0; i < shared.size(); ++i) {
        if (!(values[2 * i + 1].distance() < values[2 * i].distance())) continue;
        Triangle& s = mesh.triangles[shared[i].first];
        Triangle& t = mesh.triangles[shared[i].second];
        const Triangle old = s;
        s = {old[0], old[1], t[0]};
        t = {t[0], old[2], old[0]};
    }
}

void FeatureMaker::make() {
    collect();
    find_corners();
    for (Piece& piece : pieces_) {
        piece.feature = meeting_point(piece.sides, piece.near);
        if (piece.feature) accept(piece);
    }
    for (const double share : {0.5, 0.25, 0.05, 0.01, 0.002})
        approach(share);
    settle();
    first_tip_ = contour_.mesh.vertices.size();
    for (const Piece& piece : pieces_) {
        if (piece.feature) fan(piece);
    }
    turn_sides();
}

}  // namespace

void add_features(const CellTree& tree, const Lattice& lattice, const MeshSolid& solid,
                  Contour& contour, const MeshWork& work) {
    FeatureMaker(tree, lattice, solid, contour, work).make();
}

}  // namespace zeroset
