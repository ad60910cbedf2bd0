#pragma once

#include "engine/trace/tile.hpp"
#include "papers/along_rays/stretch.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// For each ray of a tile the stretches still to be looked at, the nearest on top.
class StretchStacks {
public:
    /// All are empty. Keeps its room.
    void begin() {
        tops_.assign(static_cast<std::size_t>(tile_size) * tile_size, none);
        nodes_.clear();
        free_ = none;
    }
    [[nodiscard]] bool empty(std::uint32_t pixel) const { return tops_[pixel] == none; }
    void push(std::uint32_t pixel, const Stretch& stretch) {
        std::uint32_t at = free_;
        if (at == none) {
            at = static_cast<std::uint32_t>(nodes_.size());
            nodes_.emplace_back();
        } else {
            free_ = nodes_[at].below;
        }
        nodes_[at] = {.stretch = stretch, .below = tops_[pixel]};
        tops_[pixel] = at;
    }
    Stretch pop(std::uint32_t pixel) {
        const std::uint32_t at = tops_[pixel];
        Node& node = nodes_[at];
        tops_[pixel] = node.below;
        node.below = free_;
        free_ = at;
        return node.stretch;
    }
    [[nodiscard]] const Stretch& top(std::uint32_t pixel) const {
        return nodes_[tops_[pixel]].stretch;
    }
    /// The ray is not searched any further.
    void drop(std::uint32_t pixel) {
        while (!empty(pixel))
            pop(pixel);
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    struct Node {
        Stretch stretch;
        std::uint32_t below;
    };
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> tops_;
    std::uint32_t free_ = none;
};

}  // namespace zeroset
