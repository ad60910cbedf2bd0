#pragma once

#include "engine/mesh/cell_tree.hpp"
#include "engine/mesh/mesh_work.hpp"
#include "engine/mesh/solid.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// How finely the octree of a mesh is divided.
struct GrowthLimits {
    double tolerance = 0.0;  ///< the surface may be so far from a plane in a cell, world units
    std::size_t most_cells = 0;
    /// No more cells than so many are divided at once for the proof's sake: so many do not hold
    /// single points or curves, but a surface along which nothing can be proved.
    std::size_t most_uncertain = ~std::size_t{0};
    MeshWork work = {};
};

/// Divides cells: until the surface in each is proved to rise along one direction and is flat to
/// the tolerance; never a cell that is proved to be empty.
class CellGrowth {
public:
    CellGrowth(CellTree& tree, const MeshSolid& solid, const GrowthLimits& limits)
        : tree_(tree), solid_(solid), limits_(limits) {}

    /// Divides the root.
    void begin();
    /// Divides these leaves, and all that then should be. Neighbours of cells that the surface may
    /// go through are at most twice as large.
    void divide(std::vector<std::uint32_t> leaves);
    /// Divides leaves as `divide` does, but for the proof's sake: as long as they are not too many
    /// for it.
    void divide_uncertain(std::vector<std::uint32_t> leaves);
    /// Whether the number of cells or the time has ended the division.
    [[nodiscard]] bool is_cut() const { return cut_; }
    /// Whether cells that cannot be proved were too many to be divided further.
    [[nodiscard]] bool is_dense() const { return dense_; }

private:
    void evaluate(std::span<const std::uint32_t> cells);
    void judge(std::span<const std::uint32_t> cells);
    void judge_flatness(std::span<const std::uint32_t> cells);
    [[nodiscard]] bool wants_split(const MeshCell& cell) const;
    std::vector<std::uint32_t> split_all(std::span<const std::uint32_t> leaves);
    void grow(std::vector<std::uint32_t> fresh);
    void leave_uncertain(std::vector<std::uint32_t>& cells);
    std::vector<std::uint32_t> too_large();

    CellTree& tree_;
    const MeshSolid& solid_;
    GrowthLimits limits_;
    bool cut_ = false, dense_ = false;
    std::size_t balanced_ = 0;  ///< cells before this one were asked for neighbours too large
    std::vector<std::uint32_t> unbalanced_;  ///< those of them that had one
};

}  // namespace zeroset
