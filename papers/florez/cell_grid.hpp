#pragma once

#include "engine/kernel/kernel_memory.hpp"
#include "engine/scene/scene.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace zeroset {

/// A regular grid over the clip box [Florez08, sec. 6.2.1]: which of its cells a surface may cross,
/// for all values that w and the parameters may take. Read-only; any thread.
class CellGrid : public PreparedSurface {
public:
    static constexpr int side = 32;  ///< cells along each axis

    /// `of_frames`: w or a parameter takes several values.
    CellGrid(const Box& clip, bool of_frames)
        : clip_(clip), of_frames_(of_frames), crossed_(std::size_t{side} * side * side) {}

    /// The plane before cell i along an axis; that of cell `side` ends the grid.
    [[nodiscard]] double plane(int axis, int i) const {
        if (i == side) return clip_.hi[axis];
        return clip_.lo[axis] + i * ((clip_.hi[axis] - clip_.lo[axis]) / side);
    }
    [[nodiscard]] bool is_crossed(int x, int y, int z) const { return crossed_[index(x, y, z)]; }
    void cross(int x, int y, int z) { crossed_[index(x, y, z)] = true; }
    [[nodiscard]] std::size_t crossed_cells() const;
    [[nodiscard]] const Box& clip() const { return clip_; }
    /// Whether it serves several frames.
    [[nodiscard]] bool of_frames() const { return of_frames_; }
    /// The findings of beams in the grid, kept from frame to frame.
    [[nodiscard]] KernelMemory& memory() const { return memory_; }

private:
    static std::size_t index(int x, int y, int z) {
        return static_cast<std::size_t>((z * side + y) * side + x);
    }
    Box clip_;
    bool of_frames_;
    std::vector<bool> crossed_;
    mutable KernelMemory memory_;
};

/// The grid of a surface for the uniforms of `frame`: that of a frame before, if its clip box is
/// the same and its uniforms hold these; else a new one, made on so many threads. So a grid for n
/// frames is made by a frame whose uniforms are intervals that hold those of all n. nullptr when
/// stopped.
std::shared_ptr<const PreparedSurface> prepare_cell_grid(const TraceFrame& surface, int threads);

}  // namespace zeroset
