#include "engine/measure/open_space.hpp"

#include "engine/base/parallel.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/real/rounding.hpp"
#include "engine/real/scalar.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <span>

namespace zeroset {
namespace {

constexpr std::size_t parents_at_once = 32;
constexpr std::size_t boxes_at_once = 8 * parents_at_once;

/// The planes between the cells of a grid, by axis, rounded to floats outward.
struct GridPlanes {
    std::array<std::vector<float>, 3> neg_lo, hi;

    GridPlanes(const Box& box, int side) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            const double step = (box.hi[axis] - box.lo[axis]) / side;
            for (int i = 0; i <= side; ++i) {
                const double at = i == side ? box.hi[axis] : box.lo[axis] + i * step;
                neg_lo[k].push_back(float_above(-at));
                hi[k].push_back(float_above(at));
            }
        }
    }
};

/// The octants of some cells of a grid, judged.
class Octants {
public:
    Octants(const Kernel& surface, const Uniforms& uniforms, const GridPlanes& planes,
            std::uint32_t side, bool jumps)
        : surface_(surface), uniforms_(uniforms), planes_(planes), side_(side), jumps_(jumps) {}

    /// The octants that may hold the surface of cells of the grid half as fine.
    [[gnu::noinline]] std::vector<std::uint32_t> open(std::span<const std::uint32_t> parents) {
        push_octants(parents);
        boxes_.pad(cells_.size());
        surface_.range(boxes_.batch(padded(cells_.size()), uniforms_.boxes<float>()));
        std::vector<std::uint32_t> result;
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (!is_empty(i)) result.push_back(cells_[i]);
        }
        return result;
    }

private:
    void push_octants(std::span<const std::uint32_t> parents) {
        const std::uint32_t half = side_ / 2;
        cells_.clear();
        for (const std::uint32_t parent : parents) {
            const std::array<std::uint32_t, 3> at{parent % half, parent / half % half,
                                                  parent / half / half};
            for (std::uint32_t octant = 0; octant < 8; ++octant) {
                const std::size_t i = cells_.size();
                std::array<std::uint32_t, 3> cell{};
                for (std::size_t k = 0; k < 3; ++k) {
                    cell[k] = 2 * at[k] + (octant >> k & 1U);
                    boxes_.ends[k][i] = planes_.neg_lo[k][cell[k]];
                    boxes_.ends[k + 3][i] = planes_.hi[k][cell[k] + 1];
                }
                cells_.push_back(cell[0] + side_ * (cell[1] + side_ * cell[2]));
            }
        }
    }
    /// Where there is a gap between two signs there is no root, but there may be a jump.
    [[nodiscard]] bool is_empty(std::size_t i) const {
        const bool gap = boxes_.f_neg_lo[i] < 0 && boxes_.f_hi[i] < 0;
        return boxes_.excludes_zero(i) && !(jumps_ && gap);
    }

    const Kernel& surface_;
    const Uniforms& uniforms_;
    const GridPlanes& planes_;
    std::uint32_t side_;
    bool jumps_;
    std::vector<std::uint32_t> cells_;
    RangeBoxes<float, boxes_at_once> boxes_;
};

}  // namespace

OpenSpaceSearch find_open_space(const Kernel& surface, const Box& box, const Uniforms& uniforms,
                                int levels, bool jumps, int threads) {
    assert(levels >= 1 && levels <= most_open_levels);
    OpenSpaceSearch search{.space = {.box = box, .side = 1, .cells = {0}}};
    for (int level = 1; level <= levels && !search.space.cells.empty(); ++level) {
        const std::vector<std::uint32_t> parents = std::move(search.space.cells);
        search.ranges += 8 * parents.size();
        search.space.side = 1 << level;
        const GridPlanes planes(box, search.space.side);
        std::vector<std::vector<std::uint32_t>> parts((parents.size() + parents_at_once - 1) /
                                                      parents_at_once);
        parallel_for(parts.size(), threads, [&](std::size_t i) {
            const UpwardRegisters upward;
            const auto some = std::span(parents).subspan(
                i * parents_at_once,
                std::min(parents_at_once, parents.size() - i * parents_at_once));
            Octants octants(surface, uniforms, planes,
                            static_cast<std::uint32_t>(search.space.side), jumps);
            parts[i] = octants.open(some);
        });
        search.space.cells.clear();
        for (const auto& part : parts)
            search.space.cells.insert(search.space.cells.end(), part.begin(), part.end());
    }
    return search;
}

}  // namespace zeroset
