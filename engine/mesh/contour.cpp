#include "engine/mesh/contour.hpp"

#include <array>
#include <utility>

namespace zeroset {
namespace {

using Four = std::array<std::uint32_t, 4>;

/// Makes the triangles of tetrahedra; vertices are numbered by the edges they lie on.
class Marcher {
public:
    explicit Marcher(const Lattice& lattice)
        : lattice_(lattice), edges_(lattice.tetrahedra.size() / 4) {}

    void march();
    /// The triangles between vertices without places.
    TriangleMesh finish_without_roots();
    Contour finish(const MeshSolid& solid, const MeshWork& work);

private:
    void add_one(const Four& v, std::uint32_t tetrahedron, bool inside);
    void add_two(const Four& v, std::uint32_t tetrahedron);
    void mark_crease(std::uint64_t key, MeshVertex& vertex);
    void add(const Triangle& triangle, std::uint32_t tetrahedron) {
        contour_.mesh.triangles.push_back(triangle);
        contour_.tetrahedra.push_back(tetrahedron);
    }
    /// The vertex on an edge, given by its ends inside and outside.
    std::uint32_t crossing(std::uint32_t inside, std::uint32_t outside) {
        return edges_.add(pair_key(inside, outside));
    }

    const Lattice& lattice_;
    KeyIndex edges_;
    Contour contour_;
};

/// The vertices of a tetrahedron with vertex `i` first, in an order that keeps its volume positive.
Four with_first(const Four& v, std::size_t i) {
    switch (i) {
        case 0: return v;
        case 1: return {v[1], v[0], v[3], v[2]};
        case 2: return {v[2], v[3], v[0], v[1]};
        default: return {v[3], v[2], v[1], v[0]};
    }
}

/// Cuts off the first vertex, which is inside or outside and all others not.
void Marcher::add_one(const Four& v, std::uint32_t tetrahedron, bool inside) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k)
        triangle[k] = inside ? crossing(v[0], v[k + 1]) : crossing(v[k + 1], v[0]);
    if (!inside) std::swap(triangle[1], triangle[2]);
    add(triangle, tetrahedron);
}

/// Cuts between the first two vertices, inside, and the other two.
void Marcher::add_two(const Four& v, std::uint32_t tetrahedron) {
    const std::array<std::uint32_t, 4> ring{crossing(v[0], v[2]), crossing(v[0], v[3]),
                                            crossing(v[1], v[3]), crossing(v[1], v[2])};
    add({ring[0], ring[1], ring[2]}, tetrahedron);
    add({ring[0], ring[2], ring[3]}, tetrahedron);
}

void Marcher::march() {
    for (std::uint32_t i = 0; i < lattice_.tetrahedra.size(); ++i) {
        const Four& vertices = lattice_.tetrahedra[i].vertices;
        const int count = lattice_.count_inside(lattice_.tetrahedra[i]);
        if (count == 0 || count == 4) continue;
        // The vertex that stands alone, or the first of the two inside, comes first.
        const bool wanted = count != 3;
        std::size_t first = 0;
        while (lattice_.inside(vertices[first]) != wanted)
            ++first;
        Four v = with_first(vertices, first);
        if (count != 2) {
            add_one(v, i, wanted);
            continue;
        }
        // Turns the others until the second one inside is second.
        while (!lattice_.inside(v[1]))
            v = {v[0], v[2], v[3], v[1]};
        add_two(v, i);
    }
}

/// A root on an edge along which two parts change lies on an edge of the solid.
void Marcher::mark_crease(std::uint64_t key, MeshVertex& vertex) {
    const LatticeVertex& a = lattice_.vertices[key >> 32U];
    const LatticeVertex& b = lattice_.vertices[key & 0xFFFFFFFFU];
    if (!a.is_kink() || !b.is_kink()) return;
    vertex.kind = VertexKind::Crease;
    contour_.creases.push_back({.vertex = edges_.find(key), .parts = a.kink});
}

TriangleMesh Marcher::finish_without_roots() {
    contour_.mesh.vertices.resize(edges_.keys().size());
    return std::move(contour_.mesh);
}

Contour Marcher::finish(const MeshSolid& solid, const MeshWork& work) {
    std::vector<CrossedEdge> brackets;
    brackets.reserve(edges_.keys().size());
    for (const std::uint64_t key : edges_.keys()) {
        const auto inside = static_cast<std::uint32_t>(key >> 32U);
        const auto outside = static_cast<std::uint32_t>(key);
        brackets.push_back({.inside = lattice_.vertices[inside].point,
                            .outside = lattice_.vertices[outside].point});
    }
    contour_.mesh.vertices = find_roots(solid, brackets, work);
    for (std::size_t i = 0; i < brackets.size(); ++i)
        mark_crease(edges_.keys()[i], contour_.mesh.vertices[i]);
    return std::move(contour_);
}

}  // namespace

MeshFacts contour_facts(const Lattice& lattice) {
    Marcher marcher(lattice);
    marcher.march();
    return facts_of(marcher.finish_without_roots());
}

std::size_t contour_complexity(const Lattice& lattice) {
    const MeshFacts facts = contour_facts(lattice);
    return facts.components + static_cast<std::size_t>(facts.genus());
}

Contour make_contour(const Lattice& lattice, const MeshSolid& solid, const MeshWork& work) {
    Marcher marcher(lattice);
    marcher.march();
    return marcher.finish(solid, work);
}

}  // namespace zeroset
