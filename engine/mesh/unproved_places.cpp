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
    UnprovedPlace take_group() {
        std::vector<std::uint32_t> open{*left_.begin()};
        left_.erase(left_.begin());
        UnprovedPlace place;
        const Box first = tree_.box(tree_[open.front()]);
        Box box = first;
        while (!open.empty()) {
            const std::uint32_t id = open.back();
            open.pop_back();
            const Box own = tree_.box(tree_[id]);
            box = {.lo = glm::min(box.lo, own.lo), .hi = glm::max(box.hi, own.hi)};
            ++place.cells;
            add_neighbours(id, open);
        }
        place.cell = first.centre();
        place.reach = 0.5 * box.size();
        return place;
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

}  // namespace

std::vector<UnprovedPlace> unproved_places(const CellTree& tree,
                                           std::span<const std::uint32_t> cells) {
    std::vector<UnprovedPlace> places;
    Flood flood(tree, cells);
    while (!flood.empty())
        places.push_back(flood.take_group());
    std::ranges::sort(places, std::ranges::greater(), &UnprovedPlace::cells);
    return places;
}

}  // namespace zeroset
