#include "papers/florez/cell_grid.hpp"

#include "engine/base/parallel.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/real/rounding.hpp"
#include "engine/real/scalar.hpp"

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <utility>

namespace zeroset {
namespace {

/// The latest grids of a kernel (Kernel::memory).
class GridMemory {
public:
    std::shared_ptr<const CellGrid> find(const TraceFrame& frame) {
        const std::scoped_lock lock(mutex_);
        const auto uniforms = frame.scene.uniforms.all_boxes<double>();
        const auto found = std::ranges::find_if(kept_, [&](const Kept& kept) {
            return kept.grid->clip() == frame.scene.clip &&
                   std::ranges::equal(uniforms, kept.uniforms, std::ranges::less_equal());
        });
        return found == kept_.end() ? nullptr : found->grid;
    }
    void keep(const TraceFrame& frame, std::shared_ptr<const CellGrid> grid) {
        const std::scoped_lock lock(mutex_);
        const auto uniforms = frame.scene.uniforms.all_boxes<double>();
        if (kept_.size() == most_kept) kept_.erase(kept_.begin());
        kept_.push_back({.uniforms = {uniforms.begin(), uniforms.end()}, .grid = std::move(grid)});
    }

private:
    static constexpr std::size_t most_kept = 4;
    struct Kept {
        std::vector<double> uniforms;  ///< Uniforms::boxes: -lo and hi of each
        std::shared_ptr<const CellGrid> grid;
    };
    std::mutex mutex_;
    std::vector<Kept> kept_;
};

/// Whether w or a parameter takes more than one value.
bool are_intervals(const TraceFrame& surface) {
    const auto ends = surface.scene.uniforms.all_boxes<double>();
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        if (-ends[i] < ends[i + 1]) return true;
    }
    return false;
}

/// The cells of one z that the surface may cross, in rows of x.
std::vector<bool> crossed_in_layer(const TraceFrame& frame, const CellGrid& grid, int z) {
    constexpr int side = CellGrid::side;
    std::vector<bool> crossed;
    RangeBoxes<float, side> boxes;
    for (int y = 0; y < side && !frame.stopped(); ++y) {
        for (int x = 0; x < side; ++x) {
            const std::array<int, 3> cell{x, y, z};
            for (int axis = 0; axis < 3; ++axis) {
                const int i = cell[static_cast<std::size_t>(axis)];
                boxes.ends[axis][x] = upper_end(float{}, -grid.plane(axis, i));
                boxes.ends[axis + 3][x] = upper_end(float{}, grid.plane(axis, i + 1));
            }
        }
        frame.kernel.range<float>(boxes.batch(side, frame.scene.uniforms.boxes<float>()));
        for (std::size_t x = 0; x < side; ++x)
            crossed.push_back(!boxes.excludes_zero(x));
    }
    return crossed;
}

}  // namespace

std::size_t CellGrid::crossed_cells() const {
    return static_cast<std::size_t>(std::ranges::count(crossed_, true));
}

std::shared_ptr<const PreparedSurface> prepare_cell_grid(const TraceFrame& surface, int threads) {
    if (surface.stopped()) return nullptr;
    const auto memory = surface.kernel.memory->of<GridMemory>();
    if (auto found = memory->find(surface)) return found;
    constexpr int side = CellGrid::side;
    auto grid = std::make_shared<CellGrid>(surface.scene.clip, are_intervals(surface));
    std::array<std::vector<bool>, side> layers;
    parallel_for(side, threads, [&](std::size_t z) {
        const UpwardRegisters upward;
        layers[z] = crossed_in_layer(surface, *grid, static_cast<int>(z));
    });
    if (surface.stopped()) return nullptr;
    for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                if (layers[static_cast<std::size_t>(z)][static_cast<std::size_t>(y * side + x)])
                    grid->cross(x, y, z);
            }
        }
    }
    memory->keep(surface, grid);
    return grid;
}

}  // namespace zeroset
