#pragma once

#include "engine/trace/tile.hpp"
#include "engine/trace/trace_frame.hpp"

#include <array>
#include <memory>
#include <mutex>

namespace zeroset {

/// The kernels of a frame's tiles: where the whole one can be specialized, what matters in each.
/// They are made down a quadtree of regions of the image, each from that of the region around it,
/// as far as they are asked for.
class FrameKernels {
public:
    /// `frame` lives longer.
    explicit FrameKernels(const TraceFrame& frame);
    ~FrameKernels();

    /// For the rays of a tile. Any thread, in upward rounding. Lives as long as this.
    const Kernel& of(const Tile& tile);

private:
    struct Region;
    void make(Region& region, const Kernel& around) const;

    const TraceFrame& frame_;
    std::unique_ptr<Region> whole_;
};

}  // namespace zeroset
