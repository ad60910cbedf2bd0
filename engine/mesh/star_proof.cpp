#include "engine/mesh/star_proof.hpp"

#include "engine/mesh/gradient_cone.hpp"
#include "engine/mesh/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace zeroset {
namespace {

/// Vertices of the lattice by their numbers, those whose stars are to be proved.
using VertexSet = std::vector<std::uint8_t>;

/// The tetrahedra about each vertex of a set.
class Stars {
public:
    Stars(const Lattice& lattice, const VertexSet& set) : starts_(lattice.vertices.size() + 1) {
        for (const Tetrahedron& tetrahedron : lattice.tetrahedra) {
            for (const std::uint32_t vertex : tetrahedron.vertices)
                starts_[vertex + 1] += set[vertex];
        }
        for (std::size_t i = 1; i < starts_.size(); ++i)
            starts_[i] += starts_[i - 1];
        members_.resize(starts_.back());
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        for (std::uint32_t i = 0; i < lattice.tetrahedra.size(); ++i) {
            for (const std::uint32_t vertex : lattice.tetrahedra[i].vertices) {
                if (set[vertex] != 0) members_[next[vertex]++] = i;
            }
        }
    }
    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t vertex) const {
        return std::span(members_).subspan(starts_[vertex], starts_[vertex + 1] - starts_[vertex]);
    }

private:
    std::vector<std::uint32_t> starts_, members_;
};

/// The gradient of L in a tetrahedron, widened by more than its rounding; nothing where the
/// tetrahedron is so flat that this is not known.
std::optional<GradientBox> linear_gradient(const Lattice& lattice, const Tetrahedron& tetrahedron) {
    const auto& v = tetrahedron.vertices;
    std::array<glm::dvec3, 3> edges;
    glm::dvec3 rise;
    const LatticeVertex& first = lattice.vertices[v[0]];
    for (std::size_t k = 0; k < 3; ++k) {
        const LatticeVertex& end = lattice.vertices[v[k + 1]];
        edges[k] = end.point - first.point;
        rise[static_cast<int>(k)] = end.level - first.level;
    }
    const glm::dvec3 across = glm::cross(edges[1], edges[2]);
    const double volume = glm::dot(edges[0], across);
    const double size = glm::length(edges[0]) * glm::length(edges[1]) * glm::length(edges[2]);
    if (!(volume > 1e-5 * size)) return std::nullopt;
    const glm::dvec3 gradient = (rise.x * across + rise.y * glm::cross(edges[2], edges[0]) +
                                 rise.z * glm::cross(edges[0], edges[1])) /
                                volume;
    const double steepest = glm::length(rise) * glm::length(across) / volume;
    const glm::dvec3 rounding(1e-9 * (glm::length(gradient) + steepest));
    return GradientBox{.lo = gradient - rounding, .hi = gradient + rounding};
}

/// The functions that are proved to rise in a star.
enum class Rise : std::uint8_t { None, Function, Both };

class Prover {
public:
    Prover(const CellTree& tree, const Lattice& lattice, const VertexSet& set,
           const MeshWork& work);
    [[nodiscard]] Rise rise(std::size_t vertex) const;
    /// Lowers what is proved of the cells about a vertex to what is proved of its star.
    void mark_cells(std::size_t vertex, Rise rise, std::vector<Rise>& of_cells) const;

private:
    /// Cells about a vertex, each once.
    void cells_about(std::size_t vertex, std::vector<std::uint32_t>& cells) const;
    [[nodiscard]] bool levels_rise(std::size_t vertex, const glm::dvec3& direction) const;
    [[nodiscard]] bool has_kink(std::size_t vertex) const;

    const CellTree& tree_;
    const Lattice& lattice_;
    Stars stars_;
    std::vector<std::optional<GradientBox>> levels_;  ///< of tetrahedra
};

Prover::Prover(const CellTree& tree, const Lattice& lattice, const VertexSet& set,
               const MeshWork& work)
    : tree_(tree), lattice_(lattice), stars_(lattice, set), levels_(lattice.tetrahedra.size()) {
    parallel_upward(levels_.size(), 4096, work, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const auto& [a, b, c, d] = lattice.tetrahedra[i].vertices;
            if ((set[a] | set[b] | set[c] | set[d]) != 0)
                levels_[i] = linear_gradient(lattice, lattice.tetrahedra[i]);
        }
    });
}

void Prover::cells_about(std::size_t vertex, std::vector<std::uint32_t>& cells) const {
    // The last vertex that asked for each cell, so that none is taken twice.
    static thread_local std::vector<std::uint64_t> asked;
    static thread_local std::uint64_t number = 0;
    if (asked.size() < tree_.size()) asked.resize(tree_.size());
    ++number;
    cells.clear();
    for (const std::uint32_t id : stars_.of(vertex)) {
        for (const std::uint32_t cell : lattice_.tetrahedra[id].cells) {
            if (std::exchange(asked[cell], number) != number) cells.push_back(cell);
        }
    }
}

bool Prover::levels_rise(std::size_t vertex, const glm::dvec3& direction) const {
    return std::ranges::all_of(stars_.of(vertex), [&](std::uint32_t id) {
        return levels_[id] && least_slope(*levels_[id], direction) > 0;
    });
}

/// Whether split_at_kinks made a vertex of its star: its tetrahedra may be too flat.
bool Prover::has_kink(std::size_t vertex) const {
    return std::ranges::any_of(stars_.of(vertex), [&](std::uint32_t id) {
        return std::ranges::any_of(lattice_.tetrahedra[id].vertices,
                                   [&](std::uint32_t v) { return lattice_.vertices[v].is_kink(); });
    });
}

Rise Prover::rise(std::size_t vertex) const {
    static thread_local std::vector<std::uint32_t> cells;
    static thread_local std::vector<GradientBox> gradients;
    cells_about(vertex, cells);
    gradients.clear();
    bool kinked = false;
    for (const std::uint32_t cell : cells) {
        const BoxFacts& facts = tree_[cell].facts;
        if (facts.side != BoxSide::Unknown) continue;
        if (!facts.graded || tree_[cell].uncertain) return Rise::None;
        kinked = kinked || facts.kinked;
        gradients.insert(gradients.end(), facts.all().begin(), facts.all().end());
    }
    // A function that does not rise alone does not rise with the levels, of which there are many.
    const auto direction = common_rise(gradients);
    if (!direction) return Rise::None;
    if (levels_rise(vertex, *direction)) return Rise::Both;
    const Rise function = kinked || has_kink(vertex) ? Rise::Function : Rise::None;
    for (const std::uint32_t id : stars_.of(vertex)) {
        if (!levels_[id]) return function;
        gradients.push_back(*levels_[id]);
    }
    return common_rise(gradients) ? Rise::Both : function;
}

void Prover::mark_cells(std::size_t vertex, Rise rise, std::vector<Rise>& of_cells) const {
    for (const std::uint32_t id : stars_.of(vertex)) {
        for (const std::uint32_t cell : lattice_.tetrahedra[id].cells)
            of_cells[cell] = std::min(of_cells[cell], rise);
    }
}

StarProof prove_some(const CellTree& tree, const Lattice& lattice, const VertexSet& set,
                     const MeshWork& work) {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < set.size(); ++v) {
        if (set[v] != 0) vertices.push_back(v);
    }
    const Prover prover(tree, lattice, set, work);
    std::vector<Rise> rises(vertices.size());
    parallel_upward(rises.size(), 256, work, [&](std::size_t first, std::size_t last) {
        if (work.limit.over()) return;  // what is left counts as not proved
        for (std::size_t i = first; i < last; ++i)
            rises[i] = prover.rise(vertices[i]);
    });
    StarProof proof{.stars = vertices.size(), .failed = {}, .unknown = {}, .rough = {}};
    std::vector<Rise> of_cells(tree.size(), Rise::Both);
    for (std::size_t i = 0; i < rises.size(); ++i) {
        if (rises[i] == Rise::Both) continue;
        proof.failed.push_back(vertices[i]);
        prover.mark_cells(vertices[i], rises[i], of_cells);
    }
    for (std::uint32_t cell = 0; cell < tree.size(); ++cell) {
        if (of_cells[cell] == Rise::Both || !tree[cell].is_active()) continue;
        (of_cells[cell] == Rise::None ? proof.unknown : proof.rough).push_back(cell);
    }
    return proof;
}

}  // namespace

StarProof prove_stars(const CellTree& tree, const Lattice& lattice, const MeshWork& work) {
    return prove_some(tree, lattice, VertexSet(lattice.vertices.size(), 1), work);
}

StarProof prove_stars(const CellTree& tree, const Lattice& lattice,
                      std::span<const std::uint32_t> leaves, std::uint32_t first_new,
                      const MeshWork& work) {
    std::vector<bool> wanted(tree.size());
    for (const std::uint32_t leaf : leaves)
        wanted[leaf] = true;
    VertexSet set(lattice.vertices.size());
    for (const Tetrahedron& tetrahedron : lattice.tetrahedra) {
        const auto& [a, b] = tetrahedron.cells;
        if (tetrahedron.newest < first_new && !wanted[a] && !wanted[b]) continue;
        for (const std::uint32_t vertex : tetrahedron.vertices)
            set[vertex] = 1;
    }
    return prove_some(tree, lattice, set, work);
}

}  // namespace zeroset
