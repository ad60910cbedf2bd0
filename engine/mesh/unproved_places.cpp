#include "engine/mesh/mesh_steps.hpp"

#include <algorithm>
#include <unordered_set>

namespace zeroset {
namespace {

/// Leaves of a list that a flood has not reached yet.
class Flood {
public:
    Flood(const CellTree& tree, std::span<const std::uint32_t> cells)
        : tree_(tree), left_(cells.begin(), cells.end()) {}

    [[nodiscard]] bool empty() const { return left_.empty(); }
    std::vector<std::uint32_t> take_group() {
        std::vector<std::uint32_t> group{*left_.begin()};
        left_.erase(left_.begin());
        for (std::size_t i = 0; i < group.size(); ++i)
            add_neighbours(group[i], group);
        return group;
    }

private:
    void add_neighbours(std::uint32_t id, std::vector<std::uint32_t>& open) {
        const MeshCell& cell = tree_[id];
        const int width = tree_.width(cell);
        for (int i = 0; i < 27; ++i) {
            const Place beside = Place(i % 3, i / 3 % 3, i / 9) - Place(1);
            const Place place = tree_.middle(cell) + width * beside;
            if (!tree_.contains(place)) continue;
            const auto found = left_.find(tree_.find(place));
            if (found == left_.end()) continue;
            open.push_back(*found);
            left_.erase(found);
        }
    }

    const CellTree& tree_;
    std::unordered_set<std::uint32_t> left_;
};

UnprovedPlace place_of(const CellTree& tree, std::span<const std::uint32_t> group) {
    const Box first = tree.box(tree[group.front()]);
    Box box = first;
    for (const std::uint32_t id : group) {
        const Box own = tree.box(tree[id]);
        box = {.lo = glm::min(box.lo, own.lo), .hi = glm::max(box.hi, own.hi)};
    }
    return {.cell = first.centre(), .reach = 0.5 * box.size(), .cells = group.size()};
}

}  // namespace

std::vector<std::vector<std::uint32_t>> groups_of(const CellTree& tree,
                                                  std::span<const std::uint32_t> cells) {
    std::vector<std::vector<std::uint32_t>> groups;
    Flood flood(tree, cells);
    while (!flood.empty())
        groups.push_back(flood.take_group());
    std::ranges::sort(groups, std::ranges::greater(), &std::vector<std::uint32_t>::size);
    return groups;
}

std::vector<UnprovedPlace> unproved_places(const CellTree& tree,
                                           std::span<const std::uint32_t> cells) {
    std::vector<UnprovedPlace> places;
    for (const std::vector<std::uint32_t>& group : groups_of(tree, cells))
        places.push_back(place_of(tree, group));
    return places;
}

}  // namespace zeroset
