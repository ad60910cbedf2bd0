#include "engine/mesh/cell_growth.hpp"

#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/gradient_cone.hpp"
#include "engine/mesh/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zeroset {
namespace {

constexpr std::size_t cells_of_task = 256;

/// About how far a surface is from the lattice's triangles within a cell of this edge in which its
/// normal turns by `turn`: the curvature is turn / (half the diagonal), the triangles' circles have
/// a radius of some 0.45 edges. What is farther all the same is measured and divided later.
double sagitta(double turn, double edge) { return 0.12 * turn * edge; }

/// By how much normals of a part turn among values at a cell's corners and, the last, its middle.
double turn_of(std::span<const SolidValue> values, std::uint32_t part) {
    const SolidValue* first = nullptr;
    double turn = 0.0;
    for (std::size_t i = values.size(); i-- > 0;) {
        if (values[i].part != part) continue;
        if (first == nullptr) first = &values[i];
        turn = std::max(turn, glm::length(values[i].normal - first->normal));
    }
    return turn;
}

}  // namespace

void CellGrowth::evaluate(std::span<const std::uint32_t> cells) {
    parallel_upward(cells.size(), cells_of_task, limits_.work,
                    [&](std::size_t first, std::size_t last) {
                        // Cells that are not asked in time count as not proved; the first levels
                        // are asked, or the border would not be known to be outside.
                        const bool needed = tree_[cells[first]].level <= least_level;
                        if (!needed && limits_.work.limit.over()) return;
                        std::vector<Box> boxes;
                        for (std::size_t i = first; i < last; ++i)
                            boxes.push_back(tree_.box(tree_[cells[i]]));
                        std::vector<BoxFacts> facts(boxes.size());
                        FieldOnBoxes(solid_).evaluate(boxes, facts);
                        for (std::size_t i = first; i < last; ++i)
                            tree_[cells[i]].facts = facts[i - first];
                    });
}

void CellGrowth::judge_flatness(std::span<const std::uint32_t> cells) {
    std::vector<glm::dvec3> points;
    constexpr std::size_t places = 9;
    points.reserve(places * cells.size());
    for (const std::uint32_t id : cells) {
        const MeshCell& cell = tree_[id];
        for (int corner = 0; corner < 8; ++corner) {
            const Place side(corner & 1, corner >> 1 & 1, corner >> 2);
            points.push_back(tree_.point(cell.corner + tree_.width(cell) * side));
        }
        points.push_back(tree_.point(tree_.middle(cell)));
    }
    const std::vector<SolidValue> values = field_at(solid_, points, limits_.work);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        MeshCell& cell = tree_[cells[i]];
        const auto own = std::span(values).subspan(places * i, places);
        const double turn = turn_of(own, cell.facts.part);
        constexpr double half_diagonal = 0.866;
        cell.bend = static_cast<float>(turn / (half_diagonal * tree_.edge(cell)));
        cell.coarse = !(sagitta(turn, tree_.edge(cell)) <= limits_.tolerance);
    }
}

void CellGrowth::judge(std::span<const std::uint32_t> cells) {
    parallel_upward(cells.size(), cells_of_task, limits_.work,
                    [&](std::size_t first, std::size_t last) {
                        for (std::size_t i = first; i < last; ++i) {
                            MeshCell& cell = tree_[cells[i]];
                            if (!cell.is_active()) continue;
                            cell.uncertain = !cell.facts.graded || !common_rise(cell.facts.all());
                        }
                    });
    std::vector<std::uint32_t> smooth;
    for (const std::uint32_t id : cells) {
        const MeshCell& cell = tree_[id];
        if (cell.is_active() && !cell.uncertain && !cell.facts.kinked) smooth.push_back(id);
    }
    judge_flatness(smooth);
}

bool CellGrowth::wants_split(const MeshCell& cell) const {
    if (!cell.is_active() || cell.level >= tree_.deepest()) return false;
    return cell.uncertain || cell.coarse || cell.level < least_level;
}

std::vector<std::uint32_t> CellGrowth::split_all(std::span<const std::uint32_t> leaves) {
    std::vector<std::uint32_t> fresh;
    for (const std::uint32_t leaf : leaves) {
        if (!tree_[leaf].is_leaf() || tree_[leaf].level >= tree_.deepest()) continue;
        // Without the first levels the border would not be known to be outside.
        if (tree_[leaf].level >= least_level &&
            (tree_.size() + 8 > limits_.most_cells || limits_.work.limit.over())) {
            cut_ = true;
            break;
        }
        const std::uint32_t first = tree_.split(leaf);
        for (std::uint32_t child = 0; child < 8; ++child)
            fresh.push_back(first + child);
    }
    return fresh;
}

/// Takes out those that are to be divided for the proof's sake alone, from where they are too many.
void CellGrowth::leave_uncertain(std::vector<std::uint32_t>& cells) {
    const auto for_proof = [&](std::uint32_t id) {
        const MeshCell& cell = tree_[id];
        return cell.uncertain && cell.level >= least_level;
    };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(cells, for_proof));
    dense_ = dense_ || count > limits_.most_uncertain;
    if (!dense_) return;
    std::erase_if(cells, for_proof);
}

void CellGrowth::grow(std::vector<std::uint32_t> fresh) {
    while (!fresh.empty()) {
        evaluate(fresh);
        judge(fresh);
        std::erase_if(fresh, [&](std::uint32_t cell) { return !wants_split(tree_[cell]); });
        leave_uncertain(fresh);
        fresh = split_all(fresh);
    }
}

/// Leaves that are more than twice as large as a neighbour that the surface may go through. Asks
/// new cells, and those that had such a neighbour when they were asked last.
std::vector<std::uint32_t> CellGrowth::too_large() {
    std::vector<std::uint32_t> asked = std::exchange(unbalanced_, {});
    for (; balanced_ < tree_.size(); ++balanced_)
        asked.push_back(static_cast<std::uint32_t>(balanced_));
    std::vector<std::uint32_t> found;
    for (const std::uint32_t id : asked) {
        const MeshCell& cell = tree_[id];
        if (!cell.is_leaf() || !cell.is_active()) continue;
        const std::size_t before = found.size();
        for (int face = 0; face < 6; ++face) {
            const std::uint32_t other = tree_.neighbour(cell, face / 2, face % 2 == 0 ? -1 : 1);
            if (other < tree_.size() && tree_[other].level + 1 < cell.level) found.push_back(other);
        }
        if (found.size() > before) unbalanced_.push_back(id);
    }
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    return found;
}

void CellGrowth::begin() {
    const std::uint32_t root = 0;
    evaluate({&root, 1});
    judge({&root, 1});
    if (tree_[root].is_active()) divide({root});
}

void CellGrowth::divide_uncertain(std::vector<std::uint32_t> leaves) {
    dense_ = dense_ || leaves.size() > limits_.most_uncertain;
    if (!dense_) divide(std::move(leaves));
}

void CellGrowth::divide(std::vector<std::uint32_t> leaves) {
    grow(split_all(leaves));
    for (auto large = too_large(); !large.empty() && !cut_; large = too_large())
        grow(split_all(large));
}

}  // namespace zeroset
