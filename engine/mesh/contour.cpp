#include "engine/mesh/contour.hpp"

#include <array>
#include <utility>

namespace zeroset {
namespace {

using Four = std::array<std::uint32_t, 4>;

/// Makes the triangles of tetrahedra; vertices are numbered by the edges they lie on.
class Marcher {
public:
    explicit Marcher(const Lattice& lattice) : lattice_(lattice), edges_(lattice.vertices.size()) {}

    MarchedLattice march();

private:
    void add_one(const Four& v, std::uint32_t tetrahedron, bool inside);
    void add_two(const Four& v, std::uint32_t tetrahedron);
    void add(const Triangle& triangle, std::uint32_t tetrahedron) {
        result_.triangles.push_back(triangle);
        result_.tetrahedra.push_back(tetrahedron);
    }
    /// The vertex on an edge, given by its ends inside and outside.
    std::uint32_t crossing(std::uint32_t inside, std::uint32_t outside) {
        return edges_.add(inside, outside);
    }

    const Lattice& lattice_;
    PairIndex edges_;
    MarchedLattice result_;
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

MarchedLattice Marcher::march() {
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
    result_.edges = edges_.keys();
    return std::move(result_);
}

/// Whether two parts change along an edge, so that a root on it lies on an edge of the solid.
bool is_crease(const Lattice& lattice, std::uint64_t edge) {
    return lattice.vertices[edge >> 32U].is_kink() &&
           lattice.vertices[edge & 0xFFFFFFFFU].is_kink();
}

}  // namespace

MarchedLattice march(const Lattice& lattice) { return Marcher(lattice).march(); }

std::vector<MeshVertex> vertices_on(const Lattice& lattice, std::span<const std::uint64_t> edges,
                                    const MeshSolid& solid, const MeshWork& work) {
    std::vector<CrossedEdge> brackets;
    brackets.reserve(edges.size());
    for (const std::uint64_t key : edges) {
        brackets.push_back({.inside = lattice.vertices[key >> 32U].point,
                            .outside = lattice.vertices[key & 0xFFFFFFFFU].point});
    }
    std::vector<MeshVertex> vertices = find_roots(solid, brackets, work);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (is_crease(lattice, edges[i])) vertices[i].kind = VertexKind::Crease;
    }
    return vertices;
}

std::vector<Contour::Crease> creases_on(const Lattice& lattice,
                                        std::span<const std::uint64_t> edges) {
    std::vector<Contour::Crease> creases;
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        if (is_crease(lattice, edges[i]))
            creases.push_back({.vertex = i, .parts = lattice.vertices[edges[i] >> 32U].kink});
    }
    return creases;
}

MeshFacts contour_facts(const Lattice& lattice) {
    MarchedLattice marched = march(lattice);
    TriangleMesh mesh;
    mesh.vertices.resize(marched.edges.size());
    mesh.triangles = std::move(marched.triangles);
    return counts_of(mesh);
}

std::size_t contour_complexity(const Lattice& lattice) {
    const MeshFacts facts = contour_facts(lattice);
    return facts.components + static_cast<std::size_t>(facts.genus());
}

Contour make_contour(const Lattice& lattice, const MeshSolid& solid, const MeshWork& work) {
    MarchedLattice marched = march(lattice);
    return {.mesh = {.vertices = vertices_on(lattice, marched.edges, solid, work),
                     .triangles = std::move(marched.triangles)},
            .tetrahedra = std::move(marched.tetrahedra),
            .creases = creases_on(lattice, marched.edges)};
}

}  // namespace zeroset
