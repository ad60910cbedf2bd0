#include "engine/mesh/contour.hpp"
#include "engine/mesh/mesh_steps.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {
namespace {

constexpr std::uint32_t no_group = ~std::uint32_t{0};

/// A place where the proof fails: the vertices that may be turned, and the tetrahedra about them.
struct Group {
    std::vector<std::uint32_t> vertices;
    std::vector<Tetrahedron> tetrahedra;
};

/// The vertices whose own proof failed, whose side no cell tells, and beside which all cells are
/// small, as the surface goes off by a cell or two there.
std::vector<bool> turnable(const CellTree& tree, const Lattice& lattice,
                           std::span<const std::uint32_t> failed) {
    std::vector<bool> result(lattice.vertices.size());
    for (const std::uint32_t v : failed)
        result[v] = true;
    for (const Tetrahedron& tetrahedron : lattice.tetrahedra) {
        for (std::size_t k = 0; k < 2; ++k) {
            const MeshCell& cell = tree[tetrahedron.cells[k]];
            if (cell.is_active() && cell.level + 1 >= tree.deepest()) continue;
            for (const std::size_t v : {k, std::size_t{2}, std::size_t{3}})
                result[tetrahedron.vertices[v]] = false;
        }
    }
    return result;
}

std::vector<Group> turnable_groups(const CellTree& tree, std::span<const std::uint32_t> cells,
                                   std::span<const std::uint32_t> failed, const Lattice& lattice) {
    const auto groups = groups_of(tree, cells);
    std::vector<std::uint32_t> of_cells(tree.size(), no_group);
    for (std::uint32_t g = 0; g < groups.size(); ++g) {
        for (const std::uint32_t cell : groups[g])
            of_cells[cell] = g;
    }
    const std::vector<bool> may_turn = turnable(tree, lattice, failed);
    std::vector<Group> result(groups.size());
    for (const Tetrahedron& tetrahedron : lattice.tetrahedra) {
        const std::uint32_t group = of_cells[tetrahedron.cells[0]];
        if (group == no_group) continue;
        bool any = false;
        for (const std::uint32_t v : tetrahedron.vertices) {
            if (!may_turn[v]) continue;
            result[group].vertices.push_back(v);
            any = true;
        }
        if (any) result[group].tetrahedra.push_back(tetrahedron);
    }
    for (Group& group : result) {
        std::ranges::sort(group.vertices);
        group.vertices.erase(std::ranges::unique(group.vertices).begin(), group.vertices.end());
    }
    return result;
}

/// Turns the group's vertices to one side, and keeps it so where the contour then has fewer handles
/// than `least`, and no fewer components: so nothing is lost.
void try_side(Group& group, bool inside, Lattice& lattice, MeshFacts& least) {
    const auto euler_about = [&] {
        std::swap(lattice.tetrahedra, group.tetrahedra);
        const long long euler = contour_facts(lattice).euler();
        std::swap(lattice.tetrahedra, group.tetrahedra);
        return euler;
    };
    std::vector<std::uint32_t> turned;
    std::ranges::copy_if(group.vertices, std::back_inserter(turned),
                         [&](std::uint32_t v) { return lattice.inside(v) != inside; });
    const auto turn = [&] {
        for (const std::uint32_t v : turned)
            lattice.vertices[v].level = -lattice.vertices[v].level;
    };
    if (turned.empty()) return;
    const long long before = euler_about();
    turn();
    if (euler_about() != before) {
        const MeshFacts facts = contour_facts(lattice);
        if (facts.genus() < least.genus() && facts.components >= least.components) {
            least = facts;
            return;
        }
    }
    turn();
}

}  // namespace

bool simplify_unproved(const CellTree& tree, std::span<const std::uint32_t> cells,
                       std::span<const std::uint32_t> failed, Lattice& lattice,
                       const MeshWork& work) {
    const MeshFacts before = contour_facts(lattice);
    MeshFacts least = before;
    for (Group& group : turnable_groups(tree, cells, failed, lattice)) {
        for (const bool inside : {false, true}) {
            if (!work.limit.over()) try_side(group, inside, lattice, least);
        }
    }
    return least.genus() < before.genus();
}

}  // namespace zeroset
